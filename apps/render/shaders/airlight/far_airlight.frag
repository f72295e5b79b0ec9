// SPDX-License-Identifier: Apache-2.0
// Airlight of lights beyond their extents and their light of higher orders, in eight slabs of the ray through a texel,
// summed along the ray.

#include "generated/airlight_constants.glsl"
#include "cookie.glsl"
#include "airlight/far_airlight.glsl"
#include "litfog/shaders/far_airlight.glsl"
uniform vec3 eye;

#ifdef HAS_HIGHER_ORDERS
#include "airlight/higher_orders.glsl"
#endif
#include "pixel_direction.glsl"

uniform isamplerBuffer far_lights;
uniform int first_light;
uniform int light_count;
uniform float visible_step;  // of the display, linear
uniform int row_count;       // texel rows of eight slabs; the next eight slabs are above

const int slab_parts = 3;   // of a slab, in each of which a cone has one share
const float faint = 1.0;  // steps of the display in eight slabs: their place among these is not seen
const float dim = 64.0;   // steps in eight slabs: in layers these are not cut into parts

layout(location = 0) out vec4 sums[slabs_at_once];

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
    vec3 lamp = light.color_intensity.rgb * litfog_airlight_unit();
#ifdef HAS_HIGHER_ORDERS
    LitfogAirlight air = litfog_light_airlight_ray(light, eye, direction, litfog_far);
    vec4 source = texelFetch(scattering_sources, index);
    if (litfog_airlight_is_layered(air)) {
      LitfogAirlight beside = beside_peak(air);
      LitfogSlab fog_slab = litfog_slab(air);
      float hidden = litfog_depth_of_stretch(air, 0.0, begins[0]);
      LitfogLayeredStretch all =
          litfog_layered_stretch(air, fog_slab, begins[0], begins[slabs_at_once], hidden, source.z);
      float brightest = max(max(lamp.r, lamp.g), lamp.b) * source.x *
                        litfog_scattered_in_stretch(beside, all, source.w, beam_of(source), source.z);
      int parts = brightest < dim * visible_step ? 1 : slab_parts;
      for (int part = 0; part < slabs_at_once * parts; ++part) {
        int slab = part / parts;
        float begin = begins[slab];
        float size = (begins[slab + 1] - begin) / float(parts);
        begin += float(part % parts) * size;
        LitfogLayeredStretch stretch = litfog_layered_stretch(air, fog_slab, begin, begin + size, hidden, source.z);
        slabs[slab] +=
            lamp * (source.x * litfog_scattered_in_stretch(beside, stretch, source.w, beam_of(source), source.z));
        hidden += stretch.depth;
      }
    } else {
      float before = source.x * litfog_scattered_beyond(air, begins[0], litfog_far_peak_angle, source.w);
      float last = source.x * litfog_scattered_beyond(air, begins[slabs_at_once], litfog_far_peak_angle, source.w);
      if (max(max(lamp.r, lamp.g), lamp.b) * (before - last) < faint * visible_step) {
        // It is spread over the slabs as the fog before them dims light.
        float middle = begins[slabs_at_once / 2];
        vec3 left = lamp * ((before - last) * scattered_share(source, air, middle));
        float begin = exp(-air.density * begins[0]);
        float whole = max(begin - exp(-air.density * begins[slabs_at_once]), 1.0e-30);
        for (int slab = 0; slab < slabs_at_once; ++slab) {
          float end = exp(-air.density * begins[slab + 1]);
          slabs[slab] += left * ((begin - end) / whole);
          begin = end;
        }
      } else {
        for (int part = 0; part < slabs_at_once * slab_parts; ++part) {
          int slab = part / slab_parts;
          float begin = begins[slab];
          float size = (begins[slab + 1] - begin) / float(slab_parts);
          begin += float(part % slab_parts) * size;
          float next = source.x * litfog_scattered_beyond(air, begin + size, litfog_far_peak_angle, source.w);
          slabs[slab] += lamp * (scattered_share(source, air, begin + 0.5 * size) * (before - next));
          before = next;
        }
      }
    }
    if (!is_single) continue;
#endif
    for (int slab = 0; slab < slabs_at_once; ++slab) {
      slabs[slab] += lamp * litfog_far_airlight_between(light, phase, eye, direction, begins[slab], begins[slab + 1]);
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
