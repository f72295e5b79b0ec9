// SPDX-License-Identifier: Apache-2.0
// The eye and what lights a scene beside its lamps.

uniform vec3 eye;
uniform vec4 viewer;  // w 1: xyz is the eye; w 0: xyz is the unit direction to an infinite viewer (Cg Tutorial, exercise 4)
uniform vec3 ambient_light;
uniform vec3 moon_direction;  // the directional light
uniform vec3 moon_color;

vec3 direction_to_viewer(vec3 position) { return normalize(viewer.xyz - position * viewer.w); }
