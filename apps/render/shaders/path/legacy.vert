// SPDX-License-Identifier: Apache-2.0
// The column "legacy" of Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs", table 1: a card's fixed
// pipeline. He prints no formula for it. Here it is OpenGL's: ambient and diffuse light at the vertices, one texture,
// fog of one colour. He does not say whether his had lamps; this one has them.

#include "path/diffuse.glsl"
#include "listed_lights.glsl"
#include "scene.glsl"
#include "vertex.glsl"

out vec3 light;

void main() {
  vec3 position = place_vertex();
  vec3 normal = world_normal();
  light = ambient_light + moon_color * max(dot(normal, moon_direction), 0.0);
#define ADD_LIGHT(i) light += diffuse_reflection(batch_light(i), position, normal);
  EACH_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
#define ADD_LIGHT(i) light += diffuse_reflection(listed_light(i), position, normal);
  EACH_LISTED_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
}
