// SPDX-License-Identifier: Apache-2.0
// Passes everything on to the fragments (Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", example 5-2; Jason
// Lacroix 2005, "Let There Be Light!: A Unified Lighting Technique for a New Generation of Games", listing 2.3).

#include "vertex.glsl"

out vec3 normal;  // unit at the vertices, where paths that interpolate their own results use it
out vec4 tangent;

void main() {
  place_vertex();
  normal = world_normal();
  tangent = vec4(world_direction(vertex_tangent.xyz), vertex_tangent.w);
}
