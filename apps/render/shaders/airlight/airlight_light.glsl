// SPDX-License-Identifier: Apache-2.0
// The airlight of a light along the ray through a pixel, up to the surfaces that the pixel's samples see.

#include "generated/airlight_constants.glsl"
#include "airlight/airlight_entry.glsl"
#include "airlight/display_slope.glsl"
#include "airlight/seen.glsl"
#include "litfog/shaders/far_airlight.glsl"

uniform vec3 eye;

#ifdef HAS_HIGHER_ORDERS
#include "airlight/higher_orders.glsl"
#else
#include "airlight/shaft.glsl"  // uses the eye declared above
#endif

layout(location = 0) out vec4 airlight;
layout(location = 1) out vec4 gain;  // derivative of airlight by the fog's opacity, at the end of the ray

// Largest difference of airlight as shown, by the opacity's largest gain, between samples that share an airlight: half a
// step of the display where the gain is 1 or more.
const float most_equal_bright = 0.002;
const float most_equal_dim = 0.0006;

// Upper bound of the gain, airlight per opacity of isotropic fog, for a ray that ends between two ranges.
float largest_gain(LitfogLight light, vec3 direction, float nearest, float farthest) {
  vec3 to_light = light.position_extent.xyz - eye;
  float range = distance(direction * clamp(dot(to_light, direction), nearest, farthest), to_light);
  vec3 color = light.color_intensity.rgb;
  return litfog_airlight_unit() * max(max(color.r, color.g), color.b) *
         litfog_attenuation(range, light.attenuation.x, light.attenuation.y, light.attenuation.z);
}

// The versine of the angle by which a light's rays are scattered into the eye, at a range. It rises along a ray.
float scattering_versine(LitfogLight light, vec3 direction, float range) {
  return 1.0 + dot(direction, litfog_ray(light.position_extent.xyz, eye + direction * range).xyz);
}

// The largest value of the phase function between two ranges of a ray.
float largest_phase(LitfogLight light, vec3 direction, float nearest, float farthest) {
  LitfogPhase phase = litfog_fog_phase();
  if (litfog_is_isotropic(phase)) return 1.0;
  return litfog_largest_phase(phase, scattering_versine(light, direction, nearest),
                              scattering_versine(light, direction, farthest));
}

#ifdef HAS_HIGHER_ORDERS
// The peak of a light's higher orders along a ray up to a range.
vec3 light_along(int light_index, LitfogLight light, float shown_exposure, vec3 direction, float range) {
  LitfogAirlight air = litfog_light_airlight_ray(light, eye, direction, range);
  return light.color_intensity.rgb * (litfog_airlight_unit() * higher_orders_peak(light_index, air));
}

// Its derivative by the fog's opacity, at the end of the ray.
vec3 gain_at(int light_index, LitfogLight light, vec3 direction, float range) {
  LitfogAirlight air = litfog_light_airlight_ray(light, eye, direction, range);
  return light.color_intensity.rgb * (litfog_airlight_unit() * higher_orders_gain(light_index, air));
}
#else
// A light's airlight along a ray up to a range. What it adds to the display, by its shown_exposure_at(), decides the
// number of nodes.
vec3 light_along(int light_index, LitfogLight light, float shown_exposure, vec3 direction, float range) {
  LitfogLight shown = light;
  shown.color_intensity.rgb *= shown_exposure;
  vec3 along = litfog_light_airlight(shown, eye, direction, range) *
               (lit_fraction(light_index, light, direction, range) / shown_exposure);
  if (!has_far_peak) return along;
  LitfogAirlight air = litfog_light_airlight_ray(light, eye, direction, range);
  return along + light.color_intensity.rgb * (litfog_airlight_unit() * litfog_far_peak(air));
}

// The derivative of a light's airlight by the fog's opacity, at the end of a ray.
vec3 gain_at(int light_index, LitfogLight light, vec3 direction, float range) {
  vec3 position = eye + direction * range;
  vec4 ray = litfog_ray(light.position_extent.xyz, position);
  float density = litfog_fog_density(eye.y, position.y);
  float scale = light.attenuation.w;
  // -f' of the light's fog over that of the scene's. The more scattered light is lost, the less it matters.
  float weight = litfog_is_exp(litfog_fog_mode())
                     ? scale * exp(min((1.0 - scale) * density * range, 8.0))
                     : scale * scale * exp(min((1.0 - scale * scale) * pow(density * range, 2.0), 8.0));
  float through = litfog_lamp_factor(light, position.y, ray.w);
  vec3 lit = litfog_light_along(light, ray) * (litfog_airlight_unit() * through * weight) *
             lit_fraction_at(light_index, position);
  LitfogPhase phase = litfog_fog_phase();
  return litfog_is_isotropic(phase) ? lit : lit * litfog_phase(phase, 1.0 + dot(direction, ray.xyz));
}
#endif

// The fraction of a light's airlight that a grid of every grid_step-th pixel keeps, along a ray at a distance from the
// light. With t = h / range it keeps k / range (35 - 35 t^2 + 21 t^4 - 5 t^6) / 16 of k / h, the softening of
// multilevel summation (Hardy et al. 2015, "Multilevel Summation Method for Electrostatic Force Evaluation"). That has
// no peak, and meets k / h with three derivatives at t = 1. Near the light h stops at the falloff's width. A beam's
// airlight jumps across its apex, and texels close to it miss a thin one, so next to nothing of a beam is kept there.
float kept_fraction(vec4 entry, float distance_squared, int grid_step) {
  float range = left_out_range(entry.z, entry.w, grid_step);
  if (grid_step == 1 || range <= 0.0) return 1.0;
  float width = entry.w * entry.w;
  float q = min((distance_squared + width) / (range * range + width), 1.0);
  if (width == 0.0) return 1.0 - pow(1.0 - q, 4.0) * (1.0 + 4.0 * q);
  return sqrt(q) * (35.0 - q * (35.0 - q * (21.0 - 5.0 * q))) / 16.0;
}

// The square of the distance at which a ray passes a light, or from the eye to one behind.
float squared_passing_distance(vec3 position, vec3 direction) {
  vec3 to_light = position - eye;
  vec3 offset = max(dot(to_light, direction), 0.0) * direction - to_light;
  return dot(offset, offset);
}

// The exposure's gain, reduced where the fog shines by itself, because a display shows less of what a lamp adds there.
// It is not reduced for cookies, whose fewer nodes would then err by up to a step where 16 lamps add up.
float shown_exposure_at(vec3 direction, vec4 seen) {
  if (profile == LITFOG_PROFILE_COOKIE) return exposure_gain;
  float opacity = litfog_fog_opacity(eye.y, eye.y + direction.y * seen.x, seen.x, 1.0);
  vec3 slope = display_slope(litfog_ambient_fog_color.rgb * opacity);
  return max(max(slope.r, slope.g), slope.b) / darkest_slope;
}

// Adds a fraction of a light's airlight and, except in the finest grid, its gain.
//
// shown_exposure  shown_exposure_at() of seen
void add_light(int light_index, float fraction, vec3 direction, vec4 seen, float shown_exposure) {
  LitfogLight light = litfog_buffered_light(light_index);
  light.axis_profile.w = profile;
  vec4 opacities = seen_opacities(eye, direction, seen, light.attenuation.w);
  light.color_intensity.rgb *= fraction;
  float gain_shown = shown_exposure * largest_phase(light, direction, seen.x, seen.w) *
                     largest_gain(light, direction, seen.x, seen.w);
  float equal_opacities = max(min(most_equal_bright, most_equal_bright / gain_shown), most_equal_dim / gain_shown);
  int first = 0;
  do {
    int run = 1;  // number of quarters that share an airlight
    float ranges = seen[first];
    for (; first + run < 4 && opacities[first + run] - opacities[first] < equal_opacities; ++run) {
      ranges += seen[first + run];
    }
    airlight.rgb += 0.25 * float(run) * light_along(light_index, light, shown_exposure, direction, ranges / float(run));
    first += run;
  } while (first < 4);
  if (pixel_step > 1) gain.rgb += gain_at(light_index, light, direction, mean_of(seen));
}
