// SPDX-License-Identifier: Apache-2.0
// The values of a corner that every geometry shader passes from vertex.glsl to rasterised.glsl. The vertex shader
// renames its outputs (geometry_corner.vert).

#include "generated/material.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in vec3 corner_position[];
in vec2 corner_uv[];
#ifdef VERTEX_DETAILS
in vec4 corner_tint[];
in vec4 corner_map_uvs[];
#endif

out vec3 rasterised_position;
out vec2 uv;
#ifdef VERTEX_DETAILS
out vec4 tint;
out vec4 map_uvs;
#endif
invariant gl_Position;

// Sets the inputs that every fragment shader reads.
void pass_corner(int corner) {
  rasterised_position = corner_position[corner];
  uv = corner_uv[corner];
#ifdef VERTEX_DETAILS
  tint = corner_tint[corner];
  map_uvs = corner_map_uvs[corner];
#endif
  gl_Position = gl_in[corner].gl_Position;
}
