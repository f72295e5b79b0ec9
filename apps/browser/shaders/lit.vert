// SPDX-License-Identifier: Apache-2.0
#include "vertex.glsl"

out vec3 normal;
out vec4 tangent;

void main() {
  place_vertex();
  normal = world_normal();
  tangent = vec4(world_direction(vertex_tangent.xyz), vertex_tangent.w);
}
