// SPDX-License-Identifier: Apache-2.0
// The shafts that surfaces cut out of a lamp's airlight: the lamp's shadow map is looked up at steps along the ray.
// Only the fraction of the airlight that is lit comes from the steps, each weighted by the integrand. The airlight
// itself is the integral without steps, so where nothing is in shadow nothing changes.

#include "shadow/shadow_caster.glsl"

uniform int shaft_steps;

const int halvings = 4;  // bisections of a step, to find the edge of a shaft

// Whether light reaches a position in the fog: from 0 to 1 over a texel at the edge of a shaft.
float lit_at(ShadowCaster caster, vec3 position) {
  vec3 from_lamp = caster.frame_from_world * (position - caster.position);
  int map = map_towards(caster, from_lamp);
  vec3 place = map_from_frame(from_lamp, map);
  if (place.z <= 0.0) return 1.0;  // behind a beam
  // Before a surface the fog is lit up to a texel's size from it. Beyond the lamp's reach there are no surfaces, but
  // fog: an empty map holds 1.
  float compared = min(length(from_lamp) * (1.0 - texel_size(caster)) / caster.reach, 1.0);
  vec2 uv = 0.5 + 0.5 * place.xy / (place.z * caster.half_size);
  return texture(shadow_maps, vec4(uv, float(caster.first_layer + map), compared));
}

// Whether surfaces cut shafts out of a light's airlight.
bool cuts_shafts(int light_index) { return texelFetch(caster_of_light, light_index).x >= 0; }

// Whether a light reaches a position; 1 if it casts no shadows.
float lit_fraction_at(int light_index, vec3 position) {
  int caster = texelFetch(caster_of_light, light_index).x;
  return caster < 0 ? 1.0 : lit_at(shadow_caster(caster), position);
}

float inverse_sinh(float x) { return sign(x) * log(abs(x) + sqrt(x * x + 1.0)); }

float lit_fraction(int light_index, LitfogLight light, vec3 direction, float range) {
  int caster_index = texelFetch(caster_of_light, light_index).x;
  if (caster_index < 0) return 1.0;
  ShadowCaster caster = shadow_caster(caster_index);
  LitfogAirlight air = litfog_light_airlight_ray(light, eye, direction, range);
  // From the closest approach. What a wide beam leaves dark within it has no weight.
  LitfogAirlightStretch lit_part = litfog_airlight_lit(air);
  float low = lit_part.low;
  float high = lit_part.high;
  if (!(high > low)) return 1.0;
  // Steps are even near the lamp and grow with the distance from it, as the shafts widen and their light falls.
  float fades = min(litfog_airlight_level(air, 2.0 * max(air.constant, 1.0)), 1.0 / air.density);
  float width = max(air.offset, 0.05 * min(fades, high - low));
  float start = inverse_sinh(low / width);
  float step = (inverse_sinh(high / width) - start) / float(shaft_steps);
  float sum = 0.0;
  float lit_sum = 0.0;
  float weight_before = 0.0;
  float lit_before = 0.0;
  for (int i = 0; i < shaft_steps; ++i) {
    float t = start + (float(i) + 0.5) * step;
    float along = width * sinh(t);
    float weight = litfog_airlight_integrand(air, along) * cosh(t);
    float lit = lit_at(caster, eye + direction * (air.approach + along));
    sum += weight;
    lit_sum += weight * lit;
    float change = lit - lit_before;
    if (i > 0 && abs(change) > 0.5) {  // a shaft's edge is between the middles of this and the last step
      float edge = 0.5;
      for (int k = 2; k < 2 + halvings; ++k) {
        float there = lit_at(caster, eye + direction * (air.approach + width * sinh(t - step + edge * step)));
        edge += (abs(there - lit_before) < 0.5 ? 1.0 : -1.0) * exp2(-float(k));
      }
      lit_sum += change * (0.5 - edge) * (edge < 0.5 ? weight_before : weight);
    }
    weight_before = weight;
    lit_before = lit;
  }
  return sum > 0.0 ? lit_sum / sum : 1.0;
}
