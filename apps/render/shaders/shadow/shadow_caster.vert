// SPDX-License-Identifier: Apache-2.0
// A surface as a lamp sees it through one of its shadow maps, or as the directional light does (render::MoonMap).

#include "shadow/shadow_map_place.glsl"

layout(location = 0) in vec3 vertex_position;
layout(location = 3) in vec2 vertex_uv;
layout(location = 4) in vec4 vertex_color;  // coverage 1 if a scene has none

uniform mat4 world_from_model;
uniform mat4 frame_from_world;  // its rotation
uniform vec3 lamp_position;
uniform int map;
uniform float half_size;   // half the map's side, a metre before the lamp
uniform float near_plane;  // metres
uniform bool is_parallel;  // the directional light's, whose half_size is in metres
uniform float reach;       // metres
uniform float tile_size;   // metres that one tile of the material's textures covers

out vec3 from_lamp;
out vec2 uv;
out float coverage;

void main() {
  from_lamp = (world_from_model * vec4(vertex_position, 1.0)).xyz - lamp_position;
  uv = vertex_uv / tile_size;
  coverage = vertex_color.a;
  vec3 place = map_from_frame(mat3(frame_from_world) * from_lamp, map);
  gl_Position = vec4(place.xy / half_size, place.z - 2.0 * near_plane, place.z);
  if (is_parallel) {
    from_lamp = vec3(0.0, 0.0, place.z);
    gl_Position = vec4(place.xy / half_size, 2.0 * place.z / reach - 1.0, 1.0);
  }
}
