// SPDX-License-Identifier: Apache-2.0
// path/light_coordinates.vert with the tangents that a normal map needs.

#define main pass_coordinates
#include "path/light_coordinates.vert"
#undef main

out vec4 tangent;

void main() {
  pass_coordinates();
  tangent = vec4(world_direction(vertex_tangent.xyz), vertex_tangent.w);
}
