// SPDX-License-Identifier: Apache-2.0
// The fragment's side of light_coordinates.vert.

#include "fragment.glsl"
#include "light_batch.glsl"

uniform mat3 cone_from_world[batch_size];

in vec3 range_coordinates[batch_size];
in vec3 cone_coordinates[batch_size];
in vec3 normal;
in float directional_shade;

// Where the fragment's place is drawn back to its surface, the coordinates go with it.
vec3 range_coordinate(int i) {
  return range_coordinates[i] + drawn_back() * (0.5 / batch_light(i).position_extent.w);
}
vec3 cone_coordinate(int i) { return cone_coordinates[i] + cone_from_world[i] * drawn_back(); }

// Ambient and directional light for a shading value d . n, which beyond the edge of a triangle is extrapolated.
vec3 directional_light(float shade) { return ambient_light + moon_color * clamp(shade, 0.0, 1.0); }
