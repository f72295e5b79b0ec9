// SPDX-License-Identifier: Apache-2.0
// The fog light of carried lights, which are on the eye's vehicle.

#include "light_list.glsl"
#include "litfog/shaders/fog.glsl"

vec3 litfog_lights_fog(vec3 position) {
  vec3 fog = vec3(0.0);
  int i = 0;
  do {  // tests at the end: with a test at the beginning, drivers without branches run the body once more
    if (i < carried_count) fog += litfog_light_fog(carried_light(i), position);
    ++i;
  } while (i < carried_count);
  return fog;
}
