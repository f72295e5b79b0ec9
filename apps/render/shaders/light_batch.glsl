// SPDX-License-Identifier: Apache-2.0
// The few lights that a pass takes as uniforms: first those that light the fog, then those that light the surface. If
// first_light_in_pass is 0, the fog's lights also light the surface and are stored once. Their number is known when the
// shader is compiled (pass.glsl), so EACH_LIGHT and EACH_FOG_LIGHT are unrolled loops. The light list would cost a
// fetch of each vector for each fragment.

#include "cookie.glsl"
#include "litfog/shaders/light.glsl"
#include "generated/pass.glsl"

uniform vec4 uniform_lights[5 * uniform_light_count];

LitfogLight uniform_light(int i) {
  int first = 5 * i;
  LitfogKind kind = LitfogKind(uniform_lights[first], uniform_lights[first + 1]);
  LitfogInstance instance =
      LitfogInstance(uniform_lights[first + 2], uniform_lights[first + 3], uniform_lights[first + 4]);
  return litfog_light(instance, kind);
}

// Light i of the pass.
LitfogLight batch_light(int i) { return uniform_light(first_light_in_pass + i); }
