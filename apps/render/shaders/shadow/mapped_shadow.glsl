// SPDX-License-Identifier: Apache-2.0
// The fraction of a light that reaches a fragment past other surfaces, by the light's shadow map (Lance Williams 1978,
// "Casting Curved Shadows on Curved Surfaces"): compared at four positions half a texel from the fragment's, each the
// mean of the four texels around it (William Reeves, David Salesin and Robert Cook 1987, "Rendering Antialiased Shadows
// with Depth Maps").
//
// A texel holds the distance to the surface at its own centre, up to a texel from the position compared. There the
// plane of the fragment's own triangle may be nearer to the light. The difference follows from the plane, so a flat
// surface does not shadow itself at any angle.

#include "shadow/shadow_caster.glsl"

uniform int uniform_casters[uniform_light_count];  // one per uniform light
uniform int first_moon_map;                        // the directional light's casters, the finest first
uniform int end_of_moon_maps;

const float rounding = 4.8e-7;    // rounding of positions: some units in the last place
const float raster_place = 0.02;  // texels by which a rasteriser may misplace an edge

vec3 receiver_normal = cross(dFdx(rasterised_position), dFdy(rasterised_position));

// How much a plane faces a map, limited so that division by it is finite, even for a triangle seen edge-on or a
// degenerate one.
float limited(float facing, float most_facing) {
  float least = max(1.0e-4 * most_facing, 1.0e-30);
  return abs(facing) < least ? least : facing;
}

// slope  change of the surface's distance over a texel, metres
float mean_of_taps(ShadowCaster caster, int map, vec2 place, float range, vec2 slope, float bias) {
  vec2 uv = 0.5 + 0.5 * place / caster.half_size;
  float step = 0.5 / float(textureSize(shadow_maps, 0).x);
  float layer = float(caster.first_layer + map);
  float lit = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec2 side = vec2(i & 1, i >> 1) * 2.0 - 1.0;
    float compared = (range + 0.5 * dot(slope, side) - bias) / caster.reach;
    lit += texture(shadow_maps, vec4(uv + side * step, layer, compared));
  }
  return 0.25 * lit;
}

float shadow_of(int caster_index) {
  if (caster_index < 0) return 1.0;
  ShadowCaster caster = shadow_caster(caster_index);
  vec3 position = fragment_position();
  vec3 from_lamp = caster.frame_from_world * (position - caster.position);
  float range = length(from_lamp);
  if (range >= caster.reach) return 1.0;  // no light there
  int map = map_towards(caster, from_lamp);
  vec3 place = map_from_frame(from_lamp, map);
  if (place.z <= 0.0) return 1.0;  // behind a beam

  // The triangle's plane has the distance R(a) = h sqrt(1 + a^2) / (n . (a, 1)) in the direction (a, 1) of the map. Its
  // slope is R (a / (1 + a^2) - n_xy / (n . (a, 1))).
  vec2 a = place.xy / place.z;
  vec3 n = map_from_frame(caster.frame_from_world * receiver_normal, map);
  float most_facing = length(n) * sqrt(1.0 + dot(a, a));
  float facing = limited(dot(n, vec3(a, 1.0)), most_facing);
  float texel = texel_size(caster);
  vec2 slope = range * (a / (1.0 + dot(a, a)) - n.xy / facing) * texel;
  float bias = (1.0 + raster_place) * (abs(slope.x) + abs(slope.y)) + range * texel * texel +
               rounding * (length(position) + range) * abs(most_facing / facing);
  return mean_of_taps(caster, map, a, range, slope, bias);
}

// Fraction of the pass's light i that reaches the fragment.
float lamp_shadow(int i) { return shadow_of(uniform_casters[first_light_in_pass + i]); }
// Fraction of a light in the tables that reaches the fragment.
float listed_lamp_shadow(int light) { return shadow_of(texelFetch(caster_of_light, light).x); }

// Fraction of the directional light, by the finest map that shows the fragment. In a parallel map a plane's slope is
// the same everywhere.
float moon_shadow() {
  if (!has_moon) return 1.0;
  vec3 position = fragment_position();
  float rim = 1.0 - 4.0 / float(textureSize(shadow_maps, 0).x);
  for (int i = first_moon_map; i < end_of_moon_maps; ++i) {
    ShadowCaster map = shadow_caster(i);
    vec3 place = map_from_frame(map.frame_from_world * (position - map.position), 0);
    if (max(abs(place.x), abs(place.y)) > rim * map.half_size) continue;
    vec3 n = map_from_frame(map.frame_from_world * receiver_normal, 0);
    float most_facing = length(n);
    float facing = limited(n.z, most_facing);
    float texel = texel_size(map);
    vec2 slope = -n.xy / facing * texel;
    float bias = (1.0 + raster_place) * (abs(slope.x) + abs(slope.y)) + raster_place * texel +
                 rounding * (length(position) + length(map.position)) * abs(most_facing / facing);
    return mean_of_taps(map, 0, place.xy, place.z, slope, bias);
  }
  return 1.0;
}
