// SPDX-License-Identifier: Apache-2.0
// A fragment of a surface: its material and the fog before it.

#define LITFOG_FOG_LIGHTS
#include "light_batch.glsl"
#include "light_list.glsl"
#include "litfog/shaders/fog.glsl"
#include "rasterised.glsl"
#include "scene.glsl"

#include "moonlight.glsl"

#include "shadow/shadow.glsl"

out vec4 color;

// Sums the fog's light over lights passed as uniforms or, if there are too many, read through the light list.
vec3 litfog_lights_fog(vec3 position) {
  vec3 fog = vec3(0.0);
  if (has_listed_fog_lights) {
    int carried = is_hidden() ? 0 : carried_count;
    for (int i = 0; i < carried; ++i) fog += litfog_light_fog(carried_light(i), position);
  }
#define ADD_LIGHT(i) fog += litfog_light_fog(uniform_light(i), position);
  EACH_FOG_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
  return fog;
}

// The range up to which lights light surfaces, as a multiple of their extents.
uniform float reach;

// A light with the extent up to which it lights surfaces.
LitfogLight surface_light(LitfogLight light) {
  if (are_lit_beyond_ends) light.position_extent.w *= reach;
  return light;
}

// Fraction of a lamp's light that is left at a height and range.
float lamp_factor(LitfogLight light, float height, float range) {
  return is_lamp_leg_fogged ? litfog_lamp_factor(light, height, range) : 1.0;
}

// Opacity of the fog before a position.
float opacity_before(vec3 position) {
  return litfog_fog_opacity(position.y, eye.y, distance(position, eye), 1.0);
}

// Light from the vertices, at least 0. At the centre of a pixel that a triangle only partly covers it is extrapolated.
vec3 vertex_light(vec3 interpolated) { return max(interpolated, vec3(0.0)); }

// The directional light's airlight before a position.
vec3 moon_airlight_before(vec3 position) {
  return is_lamp_leg_fogged && has_moon ? moon_airlight(position, eye) : vec3(0.0);
}

// A pass's light from the surface, after the fog. The first pass also adds the fog's own light.
vec4 seen_by_eye(vec3 lit, vec3 position) {
  if (is_first_pass) return vec4(litfog_apply_fog(lit, position, eye) + moon_airlight_before(position), 1.0);
  return vec4(lit * (1.0 - opacity_before(position)), 1.0);
}

// Fraction of the directional light that reaches the fragment past other surfaces and through the fog.
float moon_factor() {
  return moon_shadow() * (is_lamp_leg_fogged && has_moon ? moon_fog_factor(fragment_position().y) : 1.0);
}

// Ambient and directional light for a shading value d . n, which may be extrapolated beyond the edge of a triangle.
vec3 directional_light(float shade) {
  return ambient_light + moon_color * (clamp(shade, 0.0, 1.0) * moon_factor());
}
