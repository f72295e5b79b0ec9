// SPDX-License-Identifier: Apache-2.0
// Passes a triangle on unchanged, for comparison with a path that has a geometry shader. Such a shader may change the
// last bit of depth, and the same one of two coplanar surfaces must be visible.

#include "material.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in vec3 corner_position[];
in vec2 corner_uv[];
in vec3 corner_normal[];
in vec4 corner_tangent[];
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
out vec3 normal;
out vec4 tangent;
invariant gl_Position;

void main() {
  for (int corner = 0; corner < 3; ++corner) {
    rasterised_position = corner_position[corner];
    uv = corner_uv[corner];
#ifdef VERTEX_DETAILS
    tint = corner_tint[corner];
    map_uvs = corner_map_uvs[corner];
#endif
    normal = corner_normal[corner];
    tangent = corner_tangent[corner];
    gl_Position = gl_in[corner].gl_Position;
    EmitVertex();
  }
  EndPrimitive();
}
