// SPDX-License-Identifier: Apache-2.0
// Attenuation and spots at the vertices, in the world's space.

#include "cg_vertex.glsl"

void main() {
  vec3 p = place_vertex();
  light_vertex(mat4(1.0), 1.0, p, world_normal(), normalize(vector_to_viewer(p)));
}
