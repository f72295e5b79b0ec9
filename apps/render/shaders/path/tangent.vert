// SPDX-License-Identifier: Apache-2.0
// Jason Lacroix 2005, "Let There Be Light!: A Unified Lighting Technique for a New Generation of Games", listing 1.2,
// VertexShader.vsh: its transforms, its binormal, and its loop "lighting information conversion" over five lights.
//
// Differences: the listing multiplies the lights' positions by the tangent matrix, in the direction from
// tangent space into the world (world_normal.glsl says why), and compares them with the position in the world. That is
// right only where both spaces are the same. Here the vectors to the lights and the eye are transformed into tangent
// space. His binormal is that of w = -1. His lights are points, of one register each; a spot's axis takes a second.
// "Light count restrictions" counts them for the ten interpolated registers of a GeForce 6800, two of them taken: eight
// directional lights, seven points, four spots. OpenGL 3.3 promises fifteen vectors; five spots and the rest take
// fourteen. More lights are added in more passes.

#include "light_batch.glsl"
#include "scene.glsl"
#include "vertex.glsl"

// Vectors from the vertex, in tangent space.
out vec3 to_viewer;
out vec3 to_moon;
out vec3 to_light[batch_size];
out vec3 light_axis[batch_size];
#ifdef LITFOG_COOKIES
out vec3 cookie_up[batch_size];
#endif

void main() {
  vec3 position = place_vertex();
  vec3 n = world_normal();
  vec3 tangent = world_direction(vertex_tangent.xyz);
  vec3 t = normalize(tangent - n * dot(n, tangent));
  vec3 b = cross(n, t) * vertex_tangent.w;
  mat3 tangent_from_world = transpose(mat3(t, b, n));
  to_viewer = tangent_from_world * vector_to_viewer(position);
  to_moon = tangent_from_world * moon_direction;
  for (int i = 0; i < lights_in_pass; ++i) {
    LitfogLight light = batch_light(i);
    to_light[i] = tangent_from_world * (light.position_extent.xyz - position);
    light_axis[i] = tangent_from_world * light.axis_profile.xyz;
#ifdef LITFOG_COOKIES
    cookie_up[i] = tangent_from_world * light.cone.yzw;
#endif
  }
}
