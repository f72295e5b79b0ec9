// SPDX-License-Identifier: Apache-2.0
// Passes a triangle on unchanged, for comparison with a path that has a geometry shader. Such a shader may change the
// last bit of depth, and the same one of two coplanar surfaces must be visible.

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in vec3 corner_position[];
in vec2 corner_uv[];
in vec3 corner_normal[];
in vec4 corner_tangent[];

out vec3 rasterised_position;
out vec2 uv;
out vec3 normal;
out vec4 tangent;
invariant gl_Position;

void main() {
  for (int corner = 0; corner < 3; ++corner) {
    rasterised_position = corner_position[corner];
    uv = corner_uv[corner];
    normal = corner_normal[corner];
    tangent = corner_tangent[corner];
    gl_Position = gl_in[corner].gl_Position;
    EmitVertex();
  }
  EndPrimitive();
}
