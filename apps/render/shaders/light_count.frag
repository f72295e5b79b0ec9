// SPDX-License-Identifier: Apache-2.0
// The number of lights that a surface is shaded with.

uniform ivec2 light_list_range;  // first, count

out vec4 color;

void main() { color = vec4(float(light_list_range.y), 1.0, 0.0, 1.0); }
