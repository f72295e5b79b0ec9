// SPDX-License-Identifier: Apache-2.0
// Passes a triangle on unchanged, for comparison with a path that has a geometry shader. Geometry shaders may change
// the last bit of depth, and the same one of two coplanar surfaces must be visible.

#include "corner.glsl"

in vec3 corner_normal[];
in vec4 corner_tangent[];

out vec3 normal;
out vec4 tangent;

void main() {
  for (int corner = 0; corner < 3; ++corner) {
    pass_corner(corner);
    normal = corner_normal[corner];
    tangent = corner_tangent[corner];
    EmitVertex();
  }
  EndPrimitive();
}
