// SPDX-License-Identifier: Apache-2.0
// Ronald Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL": a light's colour times 1 - (x/R)^2
// - (y/R)^2 - (z/R)^2, R the light's extent, times a cube map. The first two squares are from a 2-D texture, the third
// is from a 1-D one. The surface's orientation is ignored.

#include "light_coordinates.glsl"
#include "map_coordinate.glsl"

uniform sampler2D range_map;
uniform sampler1D distance_map;
uniform samplerCube cone_map;

vec3 radial_light(int i) {
  vec3 str = range_coordinate(i);
  float texture0 = texture(range_map, map_coordinate(str.xy, textureSize(range_map, 0).x)).r;
  float texture1 = texture(distance_map, map_coordinate(str.z, textureSize(distance_map, 0))).r;
  float intensity = max(1.0 - (texture0 + texture1), 0.0);
  return batch_light(i).color_intensity.rgb * intensity * texture(cone_map, cone_coordinate(i)).r *
         lamp_factor(batch_light(i), length(vector_from_light(i))) * lamp_shadow(i);
}
