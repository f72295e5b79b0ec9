// SPDX-License-Identifier: Apache-2.0
// The few lights of a pass, handed over with the surface: those that can light the fog before it, then others that can
// light it. Their number and profiles are known when the shader is compiled (pass.glsl), so that nothing of a light is
// looked up and no other profile's cone computed, which some drivers take longer over than to light a fragment. For the
// same reason EACH_LIGHT and EACH_FOG_LIGHT unroll what loops would: some drivers leave the longer ones alone.

#include "cookie.glsl"
#include "litfog/light.glsl"
#include "pass.glsl"

uniform vec4 light_batch[5 * hand_size];

FogLight handed_light(int i) {
  int first = 5 * i;
  return FogLight(light_batch[first], vec4(light_batch[first + 1].xyz, profiles[i]), light_batch[first + 2],
                  light_batch[first + 3], light_batch[first + 4]);
}

// Light i of the pass.
FogLight batch_light(int i) { return handed_light(first_light_in_pass + i); }
