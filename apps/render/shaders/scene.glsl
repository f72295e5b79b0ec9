// SPDX-License-Identifier: Apache-2.0
// The eye, and the light of a scene apart from its lamps.

#include "surface_draw.glsl"
#include "generated/environment.glsl"

uniform vec3 ambient_light;
// The directional light, if has_moon.
uniform vec3 moon_direction;
uniform vec3 moon_color;

// The unit direction to the viewer if has_infinite_viewer (Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial",
// chapter 5, exercise 4).
uniform vec3 infinite_viewer;

// The vector to the viewer; its length has no meaning.
vec3 vector_to_viewer(vec3 position) { return has_infinite_viewer ? infinite_viewer : eye - position; }
