// SPDX-License-Identifier: Apache-2.0
// "Then, additively render each light into the scene to create a lightmap" (Frazier 2000, "Multiple Lights in a
// Scene").

#include "radial.glsl"

void main() { color = vec4(radial_light(0), 1.0); }
