// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec3 vertex_position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec4 vertex_tangent;
layout(location = 3) in vec2 vertex_uv;

uniform mat4 clip_from_world;
uniform mat4 world_from_model;
uniform float tile_size;

out vec3 position;
out vec3 normal;
out vec4 tangent;
out vec2 uv;

void main() {
  vec4 world = world_from_model * vec4(vertex_position, 1.0);
  position = world.xyz;
  normal = mat3(world_from_model) * vertex_normal;
  tangent = vec4(mat3(world_from_model) * vertex_tangent.xyz, vertex_tangent.w);
  uv = vertex_uv / tile_size;
  gl_Position = clip_from_world * world;
}
