// SPDX-License-Identifier: Apache-2.0
// Texture coordinates of up to four lights that share their maps. Steven Hales 2004, "Realtime Pixel Lighting Using
// Fragment Programs": P = V - L ("Lighting Algorithms"); the vertex rotated into light coordinates and scaled, s = x, t
// = a y, r = a z ("Embedding Angle Attenuation in a Texture Map"), by azimuth, elevation, heading, pitch and roll
// (scene/light_frame.h); the shading value of the directional light ("Directional Light Source"); up to four lights
// ("Multiple Light Sources"). Ronald Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL" has the
// same mappings, with -z for the light's direction. Difference: k P + 0.5 is computed at the fragments.

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
