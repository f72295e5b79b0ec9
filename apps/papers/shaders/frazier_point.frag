// SPDX-License-Identifier: Apache-2.0
// The first of two passes of a spot light that has no texture unit left for its cube map: a point light, added (Ronald
// Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL", section "Converting a Point Light Into a
// Spot Light").

#include "depth_test.glsl"
#include "path/light_coordinates.glsl"
#include "path/map_coordinate.glsl"

uniform sampler2D range_map;
uniform sampler1D distance_map;

void main() {
  vec3 str = range_coordinate(0);
  float texture0 = texture(range_map, map_coordinate(str.xy, textureSize(range_map, 0).x)).r;
  float texture1 = texture(distance_map, map_coordinate(str.z, textureSize(distance_map, 0))).r;
  color = vec4(batch_light(0).color_intensity.rgb * max(1.0 - (texture0 + texture1), 0.0), 1.0);
}
