// SPDX-License-Identifier: Apache-2.0
// The fragment's side of light_coordinates.vert.

#include "fragment.glsl"
#include "light_batch.glsl"

uniform mat3 cone_from_world[batch_size];

in vec3 from_light[batch_size];
in vec3 cone_coordinates[batch_size];
in vec3 normal;
in float directional_shade;

// Clamped to the surface's bounds like the fragment's position.
vec3 vector_from_light(int i) { return from_light[i] + drawn_back(); }

// 0 to 1 from -E to E: 0.5 + k P with k = 0.5 / E. The papers compute this at the vertices, where the sum rounds away
// k P, and with it the direction to the light, if the light's extent is large.
vec3 range_coordinate(int i) { return 0.5 + vector_from_light(i) * (0.5 / batch_light(i).position_extent.w); }
vec3 cone_coordinate(int i) { return cone_coordinates[i] + cone_from_world[i] * drawn_back(); }
