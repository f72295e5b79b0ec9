// SPDX-License-Identifier: Apache-2.0
// In the papers texel i of n is at the coordinate i / (n - 1), so that the map's edges are texels. In OpenGL it is at
// (i + 0.5) / n.
float map_coordinate(float s, int size) { return (s * float(size - 1) + 0.5) / float(size); }
vec2 map_coordinate(vec2 st, int size) { return (st * float(size - 1) + 0.5) / float(size); }
vec3 map_coordinate(vec3 str, int size) { return (str * float(size - 1) + 0.5) / float(size); }
