// SPDX-License-Identifier: Apache-2.0
// A vertex in the world.

#include "generated/material.glsl"

layout(location = 0) in vec3 vertex_position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec4 vertex_tangent;
layout(location = 3) in vec2 vertex_uv;
#ifdef VERTEX_DETAILS
layout(location = 4) in vec4 vertex_color;
layout(location = 5) in vec4 vertex_map_uvs;

out vec4 tint;
out vec4 map_uvs;
#endif

uniform mat4 clip_from_world;
uniform mat4 world_from_model;
uniform float tile_size;  // metres that one tile of the textures covers

out vec3 rasterised_position;
out vec2 uv;
invariant gl_Position;  // all passes of a surface have the same depth

// Sets the inputs of every fragment shader. Returns the position in the world.
vec3 place_vertex() {
  vec4 world = world_from_model * vec4(vertex_position, 1.0);
  rasterised_position = world.xyz;
  uv = vertex_uv / tile_size;
#ifdef VERTEX_DETAILS
  tint = vertex_color;
  map_uvs = vertex_map_uvs / tile_size;
#endif
  gl_Position = clip_from_world * world;
  return world.xyz;
}

// Models are rotated and scaled uniformly, so directions transform like positions.
vec3 world_direction(vec3 direction) { return mat3(world_from_model) * direction; }
vec3 world_normal() { return normalize(world_direction(vertex_normal)); }
