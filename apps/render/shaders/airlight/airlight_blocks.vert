// SPDX-License-Identifier: Apache-2.0
// Draws points over blocks.

#include "airlight/block_point.glsl"

void main() { draw_block(); }
