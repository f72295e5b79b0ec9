// SPDX-License-Identifier: Apache-2.0
// The few lights of a pass, handed over with the surface: those of the fog before it, then those of the surface itself;
// where the pass takes all (first_light_in_pass is 0) the fog's are the surface's, too, and stand there once. Their number
// and, of one or two, their profile are known when the shader is compiled (pass.glsl), so that nothing of a light is looked
// up and no other profile's cone computed, which some drivers take longer over than to light a fragment. For the same reason
// EACH_LIGHT and EACH_FOG_LIGHT unroll what loops would: some drivers leave the longer ones alone.

#include "cookie.glsl"
#include "litfog/shaders/light.glsl"
#include "pass.glsl"

uniform vec4 handed_lights[5 * hand_size];

LitfogLight handed_light(int i) {
  int first = 5 * i;
  LitfogLight light = LitfogLight(handed_lights[first], handed_lights[first + 1], handed_lights[first + 2],
                            handed_lights[first + 3], handed_lights[first + 4]);
  if (profiles[i] != any_profile) light.axis_profile.w = float(profiles[i]);
  return light;
}

// Light i of the pass.
LitfogLight batch_light(int i) { return handed_light(first_light_in_pass + i); }
