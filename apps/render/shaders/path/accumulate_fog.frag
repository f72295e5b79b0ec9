// SPDX-License-Identifier: Apache-2.0
// The surface's emission, and the fog over everything drawn so far. Alpha is the fog's transmittance.

#include "depth_test.glsl"
#include "fragment.glsl"

void main() {
  vec3 position = fragment_position();
  vec3 fog = litfog_apply_fog(emissive, position, eye) + moon_airlight_before(position);
  color = vec4(fog, 1.0 - opacity_before(position));
}
