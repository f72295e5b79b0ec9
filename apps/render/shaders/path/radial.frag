// SPDX-License-Identifier: Apache-2.0
// Point and spot lights on the base texture (Ronald Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot Lights in
// OpenGL", section "Per-Pixel Point Lighting", whose two passes are one here).

#include "depth_test.glsl"
#include "path/radial.glsl"

void main() {
  vec3 light = vec3(0.0);
  for (int i = 0; i < lights_in_pass; ++i) light += radial_light(i);
  if (is_first_pass) light += directional_light(directional_shade);
  vec3 lit = light * base_texture().rgb;
  if (is_first_pass) lit += emissive;
  color = seen_by_eye(lit, fragment_position());
}
