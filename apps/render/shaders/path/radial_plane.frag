// SPDX-License-Identifier: Apache-2.0
// Point and spot lights by one 2-D texture and a cube map: the square of the plane's distance is a constant (Ronald
// Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL", sections "Simplifying a Point Light to
// Use Only One Texture" to "Configuring the Register Combiners for Per-Pixel Spot Lighting": 1 - (texture0 + constant
// color 0), times colour and texture1). He leaves open whether two point lights fit into one pass on the texture unit
// that this frees. They do, even on his card: each light's z^2 goes into the alpha of its constant color, a general
// combiner for each light adds that to its texture, and the final combiner computes (1 - spare 0) * constant color 0 +
// (1 - spare 1) * constant color 1, the second product as its E * F. Here a pass has up to four lights, each of which
// may be a spot. Differences: as in radial.glsl.

#include "depth_test.glsl"
#include "fragment.glsl"
#include "light_batch.glsl"
#include "path/map_coordinate.glsl"
#include "path/plane_rotation.glsl"

uniform sampler2D range_map;
uniform samplerCube cone_map;
uniform mat3 cone_from_world[batch_size];

in float directional_shade;
in vec2 range_coordinates[batch_size];
flat in vec3 plane_normal;
flat in float square_distance[batch_size];
in vec3 cone_coordinates[batch_size];

void main() {
  vec3 back = drawn_back();  // clamps the coordinates to the surface's bounds, too
  vec2 back_in_plane = rotate_plane(back, plane_normal).xy;
  vec3 light = vec3(0.0);
  for (int i = 0; i < lights_in_pass; ++i) {
    vec2 st = range_coordinates[i] + back_in_plane * (0.5 / batch_light(i).position_extent.w);
    float texture0 = texture(range_map, map_coordinate(st, textureSize(range_map, 0).x)).r;
    float intensity = max(1.0 - (texture0 + square_distance[i]), 0.0);
    float aa = texture(cone_map, cone_coordinates[i] + cone_from_world[i] * back).r;
    light += batch_light(i).color_intensity.rgb * intensity * aa *
             lamp_factor(batch_light(i), fragment_position().y,
                         distance(batch_light(i).position_extent.xyz, fragment_position())) *
             lamp_shadow(i);
  }
  if (is_first_pass) light += directional_light(directional_shade);
  vec3 lit = light * base_texture().rgb;
  if (is_first_pass) lit += emissive;
  color = seen_by_eye(lit, fragment_position());
}
