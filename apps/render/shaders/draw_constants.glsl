// SPDX-License-Identifier: Apache-2.0
// What is the same all over a draw. Some drivers look each number of a uniform up for every few fragments, which on
// large triangles costs more than a light. So a fragment shader that defines CONSTANTS_FROM_VERTICES takes these, the
// fog and the first lights from the vertices, which pass them on unchanged (surface.vert). On small triangles that
// costs more.
//
// The bounds differ between draws that have all else in common, and some drivers copy all uniforms of a fragment shader
// when one of them changes. So a fragment shader that defines BOUNDS_FROM_VERTICES takes them from the vertices, too.

const int draw_bound_count = 2;
const int draw_constant_count = 3;

#ifdef BOUNDS_FROM_VERTICES
flat in vec4 vertex_bounds[draw_bound_count];
#define DRAW_BOUND(i) vertex_bounds[i]
#else
uniform vec4 draw_bounds[draw_bound_count];
#define DRAW_BOUND(i) draw_bounds[i]
#endif

#ifdef CONSTANTS_FROM_VERTICES
flat in vec4 vertex_constants[draw_constant_count];
#define DRAW_CONSTANT(i) vertex_constants[i]
#else
uniform vec4 draw_constants[draw_constant_count];
#define DRAW_CONSTANT(i) draw_constants[i]
#endif

uniform float coverage;  // the least of a mask; of a pane, where its texels and vertices have 1
uniform float normal_scale;  // of its material's normal map
vec3 bounds_low = DRAW_BOUND(0).xyz;  // of the surface drawn
vec3 bounds_high = DRAW_BOUND(1).xyz;
vec3 eye = DRAW_CONSTANT(0).xyz;
float relief = DRAW_CONSTANT(0).w;  // of the material's heights, in tiles
vec3 specular = DRAW_CONSTANT(1).xyz;  // of its material
float shininess = DRAW_CONSTANT(1).w;
vec3 emissive = DRAW_CONSTANT(2).xyz;
float metal_roughness = DRAW_CONSTANT(2).w;  // 0: no metal
