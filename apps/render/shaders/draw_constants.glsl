// SPDX-License-Identifier: Apache-2.0
// What is the same all over a draw. Some drivers look each number of a uniform up for every few fragments, which on large
// triangles costs more than a light. So a fragment shader that defines CONSTANTS_FROM_VERTICES takes these, the fog and
// the first lights from the vertices, which pass them on unchanged (surface.vert). On small triangles that costs more.

const int draw_constant_count = 5;

#ifdef CONSTANTS_FROM_VERTICES
flat in vec4 vertex_constants[draw_constant_count];
#define DRAW_CONSTANT(i) vertex_constants[i]
#else
uniform vec4 draw_constants[draw_constant_count];
#define DRAW_CONSTANT(i) draw_constants[i]
#endif

vec3 eye = DRAW_CONSTANT(0).xyz;
float relief = DRAW_CONSTANT(0).w;  // of the material's heights, in tiles
vec3 bounds_low = DRAW_CONSTANT(1).xyz;  // of the surface drawn
float coverage = DRAW_CONSTANT(1).w;  // the least of a mask; of a pane, where its texels and vertices have 1
vec3 bounds_high = DRAW_CONSTANT(2).xyz;
float normal_scale = DRAW_CONSTANT(2).w;  // of its normal map
vec3 specular = DRAW_CONSTANT(3).xyz;  // of its material
float shininess = DRAW_CONSTANT(3).w;
vec3 emissive = DRAW_CONSTANT(4).xyz;
float metal_roughness = DRAW_CONSTANT(4).w;  // 0: no metal
