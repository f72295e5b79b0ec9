// SPDX-License-Identifier: Apache-2.0
// Prepares up to four lights for a triangle's plane (Ronald Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot
// Lights in OpenGL", section "Simplifying a Point Light to Use Only One Texture", prepareLightForPlane): the plane is
// rotated to z = 0, so that z^2 is a constant, and x and y are texture coordinates. In the paper the application did
// this before drawing each plane; here the triangle's shader does.

#include "corner.glsl"
#include "light_batch.glsl"
#include "path/plane_rotation.glsl"

in float corner_shade[];

uniform mat3 cone_from_world[batch_size];

out float directional_shade;
out vec2 range_coordinates[batch_size];
flat out vec3 plane_normal;
flat out float square_distance[batch_size];  // from light to plane, in units of R^2
out vec3 cone_coordinates[batch_size];

void main() {
  vec3 normal =
      normalize(cross(corner_position[1] - corner_position[0], corner_position[2] - corner_position[0]));

  for (int corner = 0; corner < 3; ++corner) {
    pass_corner(corner);
    directional_shade = corner_shade[corner];
    plane_normal = normal;
    for (int i = 0; i < lights_in_pass; ++i) {
      vec4 position_extent = batch_light(i).position_extent;
      vec3 p = corner_position[corner] - position_extent.xyz;
      float k = 0.5 / position_extent.w;
      float radial_distance = dot(normal, p) / position_extent.w;
      range_coordinates[i] = 0.5 + k * rotate_plane(p, normal).xy;
      square_distance[i] = radial_distance * radial_distance;
      cone_coordinates[i] = cone_from_world[i] * p;
    }
    EmitVertex();
  }
  EndPrimitive();
}
