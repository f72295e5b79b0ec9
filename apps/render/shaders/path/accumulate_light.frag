// SPDX-License-Identifier: Apache-2.0
// "Then, additively render each light into the scene to create a lightmap" (Ronald Frazier 2000, "Real-Time Per-Pixel
// Point Lights and Spot Lights in OpenGL", section "Multiple Lights in a Scene").

#include "depth_test.glsl"
#include "path/radial.glsl"

void main() { color = vec4(radial_light(0), 1.0); }
