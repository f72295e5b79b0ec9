// SPDX-License-Identifier: Apache-2.0
// Airlight of lights beyond their extents and their light of higher orders, in eight slabs of the ray through a texel,
// summed along the ray.

#include "generated/airlight_constants.glsl"
#include "cookie.glsl"
#include "airlight/far_airlight.glsl"
#include "litfog/shaders/light_airlight.glsl"
#include "litfog/shaders/light_buffer.glsl"
#include "airlight/far_peak.glsl"
#ifdef HAS_HIGHER_ORDERS
#include "airlight/higher_orders.glsl"
#endif
#include "pixel_direction.glsl"

uniform vec3 eye;
uniform isamplerBuffer far_lights;
uniform int first_light;
uniform int light_count;
uniform int row_count;  // texel rows of eight slabs; the next eight slabs are above

const int slab_parts = 3;      // of a slab, in each of which a cone has one share
const float faint = 0.001;  // of eight slabs: so little light that its place among them is not seen

layout(location = 0) out vec4 sums[slabs_at_once];

// What fog leaves of light on the way between two points of different heights.
float left_by_layers(float scale, vec3 from, vec3 to) {
  return exp(-scale * litfog_fog_density(from.y, to.y) * distance(from, to));
}

// The fog's -f'(s) f(r), 1/m. Without layers its density is that of the light's class.
float fog_weight(float density, float seen, float range) {
  if (litfog_is_exp(litfog_fog_mode())) return density * exp(-density * (seen + range));
  float x = density * seen;
  float y = density * range;
  return 2.0 * density * x * exp(-x * x - y * y);
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  int first_slab = place.y / row_count * slabs_at_once;
  vec3 direction = pixel_direction(ivec2(place.x, place.y % row_count) * far_step);
  LitfogPhase phase = litfog_fog_phase();
  float begins[slabs_at_once + 1];
  for (int i = 0; i <= slabs_at_once; ++i) begins[i] = slab_begin(first_slab + i, eye.y, direction.y);
  vec3 slabs[slabs_at_once];
  for (int i = 0; i < slabs_at_once; ++i) slabs[i] = vec3(0.0);
  for (int i = 0; i < light_count; ++i) {
    int index = texelFetch(far_lights, first_light + i).x;
    bool is_single = index >= 0;
    if (!is_single) index = -1 - index;
    LitfogLight light = litfog_buffered_light(index);
    light.axis_profile.w = profile;
    float density = litfog_light_fog_density(light);
    float extent = light.position_extent.w;
    vec3 to_light = light.position_extent.xyz - eye;
    float approach = dot(to_light, direction);
    float square = dot(to_light, to_light) - approach * approach;
    float half_chord = sqrt(max(extent * extent - square, 0.0));
    vec3 lamp = light.color_intensity.rgb * litfog_airlight_unit();
#ifdef HAS_HIGHER_ORDERS
    LitfogAirlight air = litfog_light_airlight_ray(light, eye, direction, litfog_far);
    vec4 source = texelFetch(scattering_sources, index);
    if (litfog_airlight_is_layered(air)) {
      LitfogAirlight beside = beside_peak(air);
      LitfogSlab slab_of_fog = litfog_slab(air);
      for (int part = 0; part < slabs_at_once * slab_parts; ++part) {
        int slab = part / slab_parts;
        float begin = begins[slab];
        float size = (begins[slab + 1] - begin) / float(slab_parts);
        begin += float(part % slab_parts) * size;
        slabs[slab] += lamp * scattered_in_layers(source, beside, slab_of_fog, litfog_layered_stretch(air, slab_of_fog, begin, begin + size));
      }
    } else {
      float before = source.x * litfog_scattered_beyond(air, begins[0], far_peak_angle);
      float last = source.x * litfog_scattered_beyond(air, begins[slabs_at_once], far_peak_angle);
      if (max(max(lamp.r, lamp.g), lamp.b) * (before - last) < faint) {
        // It is spread over the slabs as the fog before them dims light.
        float middle = begins[slabs_at_once / 2];
        vec3 left = lamp * ((before - last) * scattered_share(source, air, middle));
        float begin = exp(-density * begins[0]);
        float whole = max(begin - exp(-density * begins[slabs_at_once]), 1.0e-30);
        for (int slab = 0; slab < slabs_at_once; ++slab) {
          float end = exp(-density * begins[slab + 1]);
          slabs[slab] += left * ((begin - end) / whole);
          begin = end;
        }
      } else {
        for (int part = 0; part < slabs_at_once * slab_parts; ++part) {
          int slab = part / slab_parts;
          float begin = begins[slab];
          float size = (begins[slab + 1] - begin) / float(slab_parts);
          begin += float(part % slab_parts) * size;
          float next = source.x * litfog_scattered_beyond(air, begin + size, far_peak_angle);
          slabs[slab] += lamp * (scattered_share(source, air, begin + 0.5 * size) * (before - next));
          before = next;
        }
      }
    }
    if (!is_single) continue;
#endif
    float left = left_by_layers(light.attenuation.w, eye, eye + begins[0] * direction);
    for (int slab = 0; slab < slabs_at_once; ++slab) {
      float begin = begins[slab];
      float end = begins[slab + 1];
      float seen = 0.5 * (begin + end);
      float weight;  // of the slab, but for the lamp's leg in layers
      if (litfog_knot_count() > 0) {
        // A slab may lie in a layer in part: its place is that of the fog in its halves.
        float scale = light.attenuation.w;
        float at_middle = left_by_layers(scale, eye, eye + seen * direction);
        float at_end = left_by_layers(scale, eye, eye + end * direction);
        weight = max(left - at_end, 0.0) / (end - begin);
        float shift = (2.0 * at_middle - left - at_end) / max(left - at_end, 1.0e-30);
        seen += 0.25 * (end - begin) * clamp(shift, -1.0, 1.0);  // of thin fog there are roundings alone
        left = at_end;
      }
      float within = max(min(end, approach + half_chord) - max(begin, approach - half_chord), 0.0);
      vec4 ray = litfog_ray(to_light, direction * seen);
      float range = max(ray.w, extent);
      if (litfog_knot_count() > 0) {
        weight *= left_by_layers(light.attenuation.w, eye + seen * direction, light.position_extent.xyz);
      } else {
        weight = fog_weight(density, seen, range);
      }
      float arriving = litfog_cone(light, ray.xyz) *
                       litfog_attenuation(range, light.attenuation.x, light.attenuation.y, light.attenuation.z);
      float scattered = (end - begin - within) * weight * arriving;
      if (!litfog_is_isotropic(phase)) scattered *= litfog_phase(phase, max(1.0 + dot(direction, ray.xyz), far_peak_versine));
      slabs[slab] += lamp * scattered;
    }
  }
  vec4 sum = vec4(0.0);
#define ADD_SLAB(i) \
  sum.rgb += slabs[i]; \
  sums[i] = sum;
  ADD_SLAB(0)
  ADD_SLAB(1)
  ADD_SLAB(2)
  ADD_SLAB(3)
  ADD_SLAB(4)
  ADD_SLAB(5)
  ADD_SLAB(6)
  ADD_SLAB(7)
#undef ADD_SLAB
}
