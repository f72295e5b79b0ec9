// SPDX-License-Identifier: Apache-2.0
// "The first thing to do is to clear the back buffer to the ambiant light color" (Ronald Frazier 2000, "Real-Time
// Per-Pixel Point Lights and Spot Lights in OpenGL", section "Multiple Lights in a Scene"). Here that colour includes
// the directional light.

#include "depth_test.glsl"
#include "path/light_coordinates.glsl"

void main() { color = vec4(directional_light(directional_shade), 1.0); }
