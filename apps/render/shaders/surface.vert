// SPDX-License-Identifier: Apache-2.0
// Passes everything on to the fragments (Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", example 5-2; Jason
// Lacroix 2005, "Let There Be Light!: A Unified Lighting Technique for a New Generation of Games", listing 2.3).

#include "draw_constants.glsl"
#include "litfog/shaders/light_block.glsl"
#include "pass.glsl"
#include "vertex.glsl"

out vec3 normal;  // unit at the vertices, where paths that interpolate their own results use it
out vec4 tangent;

uniform vec4 uniform_lights[5 * uniform_light_count];

flat out vec4 vertex_bounds[draw_bound_count];
#ifdef VERTICES_PASS_CONSTANTS
flat out vec4 vertex_constants[draw_constant_count];
flat out vec4 vertex_fog;
flat out vec4 vertex_ambient_fog_color;
flat out vec4 vertex_lights[5 * max(vertex_light_count, 1)];
#endif

void main() {
  place_vertex();
  normal = world_normal();
  tangent = vec4(world_direction(vertex_tangent.xyz), vertex_tangent.w);
  vertex_bounds = draw_bounds;
#ifdef VERTICES_PASS_CONSTANTS
  vertex_constants = draw_constants;
  vertex_fog = litfog_fog;
  vertex_ambient_fog_color = litfog_ambient_fog_color;
  for (int i = 0; i < 5 * vertex_light_count; ++i) vertex_lights[i] = uniform_lights[i];
#endif
}
