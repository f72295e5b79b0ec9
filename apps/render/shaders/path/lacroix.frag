// SPDX-License-Identifier: Apache-2.0
// Jason Lacroix 2005, "Let There Be Light!: A Unified Lighting Technique for a New Generation of Games", equations (1)
// to (4) as printed, in the loop of listing 2.1, with the normal of listing 2.2. The attenuation is neither clamped to
// 1 nor cut at an extent. N . -L is not clamped to 0: a light behind a surface takes light away. unified.frag clamps
// and cuts.
//
// Differences: the listing's 1/dist is equation (3) for A0 = A2 = 0; here A0, A1 and A2 are the light's own C,
// L and Q. The listing has point lights only ("other kinds of lights ... left to the reader") and no texture; here
// spots have their cones, the base texture reflects the lights, ambient light and a directional light are added, and
// Hales's fog lies before the surface. The sum is clamped to 0, as a framebuffer of eight bits does.

#include "depth_test.glsl"
#include "fragment.glsl"
#include "listed_lights.glsl"

in vec3 normal;

vec3 contribution(LitfogLight light, vec3 position, vec3 n) {
  float dist = length(position - light.position_extent.xyz);
  vec3 direction = normalize(position - light.position_extent.xyz);
  float att = 1.0 / (light.attenuation.x + light.attenuation.y * dist + light.attenuation.z * dist * dist);
  return light.color_intensity.rgb * litfog_cone(light, direction) * att * dot(n, -direction);
}

void main() {
  vec3 position = fragment_position();
  vec3 n = normalize(normal);
  vec3 light = ambient_light + moon_color * dot(n, moon_direction);
#define ADD_LIGHT(i) light += contribution(batch_light(i), position, n);
  EACH_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
#define ADD_LIGHT(i) light += contribution(listed_light(i), position, n);
  EACH_LISTED_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
  color = seen_by_eye(max(emissive + base_texture().rgb * light, 0.0), position);
}
