// SPDX-License-Identifier: Apache-2.0
// A corner of a triangle that casts a shadow.

layout(location = 0) in vec3 vertex_position;

uniform mat4 clip_from_world;

out vec3 corner;

void main() {
  corner = vertex_position;
  gl_Position = clip_from_world * vec4(vertex_position, 1.0);
}
