// SPDX-License-Identifier: Apache-2.0
// The few lights of a pass (lights_in_pass of them, see pass.glsl), as the vertices hand them to the fragments.

#include "cookie.glsl"
#include "litfog/light.glsl"
#include "pass.glsl"

uniform vec4 light_batch[5 * batch_size];

FogLight batch_light(int i) {
  int first = 5 * i;
  return FogLight(light_batch[first], light_batch[first + 1], light_batch[first + 2], light_batch[first + 3],
                  light_batch[first + 4]);
}
