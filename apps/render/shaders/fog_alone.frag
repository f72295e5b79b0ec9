// SPDX-License-Identifier: Apache-2.0
// The fog before a surface that the fog hides.

#include "depth_test.glsl"
#include "fragment.glsl"

void main() { color = seen_by_eye(vec3(0.0), fragment_position()); }
