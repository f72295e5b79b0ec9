// SPDX-License-Identifier: Apache-2.0
// The baseline of Hales 2004, table 1: light at the vertices as OpenGL's fixed pipeline has it, ambient and diffuse.

#include "cookie.glsl"
#include "litfog/surface.glsl"
#include "local_lights.glsl"
#include "scene.glsl"
#include "vertex.glsl"

out vec3 light;

void main() {
  vec3 position = place_vertex();
  vec3 normal = world_normal();
  light = ambient_light + moon_color * max(dot(normal, moon_direction), 0.0);
  for (int i = 0; i < reaching_light_count(); ++i) {
    FogLight lamp = reaching_light(i);
    vec3 to_light = litfog_direction(position, lamp.position_extent.xyz);
    light += litfog_light_at(lamp, position) * max(dot(normal, to_light), 0.0);
  }
}
