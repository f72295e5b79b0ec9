// SPDX-License-Identifier: Apache-2.0
// The vectors from up to four lights that share their maps, which the fragment turns into range coordinates, and their
// cone coordinates; and the shading value of the directional light (Steven Hales 2004, "Realtime Pixel Lighting Using
// Fragment Programs", sections "Embedding Range Attenuation in a Texture Map" to "Multiple Light Sources"; the same
// mappings in Ronald Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL", with x0/2 + 0.5 for
// the range and -z for the light's direction).

#include "light_batch.glsl"
#include "scene.glsl"
#include "vertex.glsl"

uniform mat3 cone_from_world[batch_size];  // a rotation into the light's coordinates, scaled across its axis

out vec3 from_light[batch_size];
out vec3 cone_coordinates[batch_size];
out vec3 normal;
out float directional_shade;  // d . n

void main() {
  vec3 v = place_vertex();
  normal = world_normal();
  directional_shade = dot(moon_direction, normal);
  for (int i = 0; i < lights_in_pass; ++i) {
    vec3 p = v - batch_light(i).position_extent.xyz;
    from_light[i] = p;
    cone_coordinates[i] = cone_from_world[i] * p;
  }
}
