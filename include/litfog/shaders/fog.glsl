// SPDX-License-Identifier: Apache-2.0
// litfog: the fog between the eye and a fragment, lit by the lights of the block.
//
// LITFOG_FOG_LIGHTS, defined before the first include of litfog, leaves litfog_lights_fog() to the including program,
// which adds up litfog_light_fog() over lights of its own choice, in the block or elsewhere.
//
// A program for one fog mode may define LITFOG_FOG_MODE, 0.0 (exp) or 1.0 (exp2), before the first include of litfog;
// compilers then drop the other. LITFOG_KNOT_COUNT of density_profile.glsl does the same for layers.

#ifndef LITFOG_FOG_GLSL
#define LITFOG_FOG_GLSL

#include "litfog/shaders/density_profile.glsl"
#include "litfog/shaders/light_block.glsl"

// The fog mode, for litfog_is_exp().
#ifdef LITFOG_FOG_MODE
float litfog_fog_mode() { return LITFOG_FOG_MODE; }
#else
float litfog_fog_mode() { return litfog_fog.y; }
#endif

// airlight_unit() of litfog/airlight.h.
float litfog_airlight_unit() { return 0.25 * litfog_fog.w; }

// Density of the fog, 1/m: its mean along a straight line between two heights.
float litfog_fog_density(float height_a, float height_b) {
  return litfog_fog.x + litfog_mean_density(height_a, height_b);
}

// Opacity 1 - f of the fog over a range between two heights. density_scale is the light's, or 1 for surfaces.
float litfog_fog_opacity(float height_a, float height_b, float range, float density_scale) {
  // Finite, because infinity gives NaN at range 0.
  float density = min(litfog_fog_density(height_a, height_b) * density_scale, 3.4e38);
  return litfog_opacity(litfog_is_exp(litfog_fog_mode()) ? litfog_depth_exp(range, density)
                                                         : litfog_depth_exp2(range, density));
}

// Fog factor from the lamp to a height at a range. With single scattering (litfog/shaders/light_airlight.glsl) it also
// dims the light that arrives at a surface.
float litfog_lamp_factor(LitfogLight light, float height, float range) {
  return 1.0 - litfog_fog_opacity(light.position_extent.y, height, range, light.attenuation.w);
}

// A light's part of a fragment's fog colour: colour * cone * fog colour intensity (Steven Hales 2004, "Realtime Pixel
// Lighting Using Fragment Programs", section "Lighting in Fog"). light_airlight.glsl has the airlight instead.
vec3 litfog_light_fog(LitfogLight light, vec3 position) {
  vec3 direction = litfog_ray(light.position_extent.xyz, position).xyz;
  return light.color_intensity.rgb * (litfog_cone(light, direction) * light.color_intensity.w);
}

// The sum of litfog_light_fog() over the lights that light the fog.
#ifdef LITFOG_FOG_LIGHTS
vec3 litfog_lights_fog(vec3 position);
#else
vec3 litfog_lights_fog(vec3 position) {
  vec3 color = vec3(0.0);
  int count = int(litfog_fog.z);
  for (int i = 0; i < count; ++i) color += litfog_light_fog(litfog_block_light(i), position);
  return color;
}
#endif

// Fragment fog colour = ambient fog colour + litfog_lights_fog().
vec3 litfog_fog_color(vec3 position) { return litfog_ambient_fog_color.rgb + litfog_lights_fog(position); }

// The fragment as the eye sees it: mix(fog, surface, f).
vec3 litfog_apply_fog(vec3 color, vec3 position, vec3 eye) {
  float opacity = litfog_fog_opacity(position.y, eye.y, distance(position, eye), 1.0);
  if (opacity <= 0.0) return color;
  return color + (litfog_fog_color(position) - color) * opacity;
}

#endif
