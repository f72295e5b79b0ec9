// SPDX-License-Identifier: Apache-2.0
// The eye, and a scene's light that is not from lamps.

#include "environment.glsl"

uniform vec3 eye;
uniform vec3 infinite_viewer;  // the unit direction to it, where has_infinite_viewer (Cg Tutorial, exercise 4)

// The vector to the viewer; its length has no meaning.
vec3 vector_to_viewer(vec3 position) { return has_infinite_viewer ? infinite_viewer : eye - position; }
