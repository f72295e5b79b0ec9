// SPDX-License-Identifier: Apache-2.0
// The light of the fog by the lights that the eye's vehicle carries, if any.

#include "light_list.glsl"
#include "litfog/shaders/fog.glsl"

vec3 litfog_lights_fog(vec3 position) {
  vec3 fog = vec3(0.0);
  int i = 0;
  do {  // tested at its end, because drivers without branches run a body once more to test it at its beginning
    if (i < carried_count) fog += litfog_light_fog(carried_light(i), position);
    ++i;
  } while (i < carried_count);
  return fog;
}
