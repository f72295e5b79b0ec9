// SPDX-License-Identifier: Apache-2.0
// "Finally, after all lights are rendered, render the base textures using dst_color : zero blending" (Ronald Frazier
// 2000, "Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL", section "Multiple Lights in a Scene"). His back
// buffer of eight bits clamps to 1; this one does not.

#include "depth_test.glsl"
#include "fragment.glsl"

void main() { color = vec4(base_texture().rgb, 1.0); }
