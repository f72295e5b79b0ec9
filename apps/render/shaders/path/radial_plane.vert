// SPDX-License-Identifier: Apache-2.0
// The corners of a triangle. radial_plane.geom needs its plane before it writes the fragments' position.

#define rasterised_position corner_position
#define uv corner_uv
#define tint corner_tint
#define map_uvs corner_map_uvs
#include "scene.glsl"
#include "vertex.glsl"

out float corner_shade;  // d . n of the directional light

void main() {
  place_vertex();
  corner_shade = dot(moon_direction, world_normal());
}
