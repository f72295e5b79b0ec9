// SPDX-License-Identifier: Apache-2.0
// Ronald Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL". Section "Calculating Attenuation":
// Intensity = 1 - (Texture0 + Texture1), with (x/R)^2 + (y/R)^2 from the 2-D texture and (z/R)^2 from the 1-D one, R
// the light's extent. "Filtering a Point Light into a Spot Light": times the cube map. The surface's orientation is
// ignored.
//
// Differences: the map holds each light's own cone, unless ConeMaps::one_disc asks for his one map for every angle; a
// cone of 90 degrees or more has no scale. Texture coordinates are computed at the fragment (light_coordinates.glsl).
// Nothing is clamped to 1 before the screen. Hales's fog and the directional light are added.

#include "path/light_coordinates.glsl"
#include "path/map_coordinate.glsl"

uniform sampler2D range_map;
uniform sampler1D distance_map;
uniform samplerCube cone_map;

vec3 radial_light(int i) {
  vec3 str = range_coordinate(i);
  float texture0 = texture(range_map, map_coordinate(str.xy, textureSize(range_map, 0).x)).r;
  float texture1 = texture(distance_map, map_coordinate(str.z, textureSize(distance_map, 0))).r;
  float intensity = max(1.0 - (texture0 + texture1), 0.0);
  return batch_light(i).color_intensity.rgb * intensity * texture(cone_map, cone_coordinate(i)).r *
         lamp_factor(batch_light(i), fragment_position().y, length(vector_from_light(i))) * lamp_shadow(i);
}
