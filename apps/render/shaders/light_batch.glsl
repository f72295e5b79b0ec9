// SPDX-License-Identifier: Apache-2.0
// The few lights of a pass, passed as uniforms: first those that light the fog, then those that light the surface. If
// the pass takes all lights (first_light_in_pass is 0), the fog's lights also light the surface and are stored once.
// Their number and, for one or two lights, their profile are known when the shader is compiled (pass.glsl), so that no
// light is looked up and no other profile's cone is computed: on some drivers that costs more than lighting the
// fragment. EACH_LIGHT and EACH_FOG_LIGHT are unrolled loops for the same reason, because some drivers do not unroll
// the longer ones.

#include "cookie.glsl"
#include "litfog/shaders/light.glsl"
#include "pass.glsl"

uniform vec4 uniform_lights[5 * uniform_light_count];

#ifdef CONSTANTS_FROM_VERTICES
flat in vec4 vertex_lights[5 * max(vertex_light_count, 1)];
// Vertices pass the first lights on (draw_constants.glsl).
vec4 light_vector(int i) { return i < 5 * vertex_light_count ? vertex_lights[i] : uniform_lights[i]; }
#else
vec4 light_vector(int i) { return uniform_lights[i]; }
#endif

LitfogLight uniform_light(int i) {
  int first = 5 * i;
  LitfogKind kind = LitfogKind(light_vector(first), light_vector(first + 1));
  LitfogInstance instance =
      LitfogInstance(light_vector(first + 2), light_vector(first + 3), light_vector(first + 4));
  if (profiles[i] != any_profile) instance.axis_profile.w = float(profiles[i]);
  return litfog_light(instance, kind);
}

// Light i of the pass.
LitfogLight batch_light(int i) { return uniform_light(first_light_in_pass + i); }
