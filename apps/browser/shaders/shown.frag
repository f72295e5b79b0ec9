// SPDX-License-Identifier: Apache-2.0
// The last pass: adds the lamps' airlight along each pixel's ray, and shows the sum as a display does, or measures it.

#include "litfog/shaders/glow.glsl"
#include "fog_top.glsl"
#include "light_list.glsl"
#include "pixel_direction.glsl"

uniform sampler2D picture;  // lit.frag
uniform vec3 eye;
uniform bool has_airlight;
uniform float exposure_gain;
uniform bool is_neutral;
uniform int stride;        // of the picture's pixels, each way, every how many there is one here
uniform bool is_measured;  // the light itself is wanted, by which an exposure is chosen

out vec4 color;

// Of the display's white: all lamps that are left out add up to less than half a step, which is smallest in the dark.
const float glow_budget = 0.5 / 255.0 / 12.92;

vec3 lamps_glow(vec3 direction, float range) {
  vec3 sum = vec3(0.0);
  int count = int(litfog_fog.z);
  for (int i = 0; i < count; ++i) {
    LitfogLight light = light_at(i);
    LitfogAirlight air = litfog_glow_ray(light, eye, direction, range, 0.0);
    float eye_range = distance(light.position_extent.xyz, eye);
    float weight = litfog_largest_fog_weight(air.mode, air.density, 2.0 / 3.0 * eye_range, eye_range / 3.0);
    // The closest point of the ray is at the lamp's closest approach or, if that lies behind the eye, at the eye.
    float nearest = length(vec2(air.offset, min(air.approach, 0.0)));
    float denominator = litfog_denominator(nearest, air.constant, air.linear, air.quadratic);
    vec3 most = light.color_intensity.rgb *
                litfog_largest_airlight(weight, denominator, air.quadratic, 2.0 * air.extent);
    if (max(max(most.r, most.g), most.b) * exposure_gain * float(count) < glow_budget) continue;
    sum += litfog_glow(light, eye, direction, range, 0.0);
  }
  return sum;
}

// render::toned() of ToneCurve::neutral states the source.
vec3 neutral(vec3 light) {
  const float f90 = 0.04;
  const float start_compression = 0.8 - f90;
  const float desaturation = 0.15;
  const float d = 1.0 - start_compression;
  float x = min(min(light.r, light.g), light.b);
  light -= x < 2.0 * f90 ? x - x * x / (4.0 * f90) : f90;
  float peak = max(max(light.r, light.g), light.b);
  if (peak < start_compression) return light;
  float new_peak = 1.0 - d * d / (peak + d - start_compression);
  light *= new_peak / peak;
  float g = 1.0 - 1.0 / (desaturation * (peak - new_peak) + 1.0);
  return mix(light, vec3(new_peak), g);
}

// IEC 61966-2-1.
vec3 srgb(vec3 light) {
  return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, greaterThan(light, vec3(0.0031308)));
}

// In [-0.5, 0.5): interleaved gradient noise (Jorge Jimenez 2014, "Next Generation Post Processing in Call of Duty:
// Advanced Warfare").
float dither(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5; }

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) * stride + stride / 2;
  vec4 seen = texelFetch(picture, pixel, 0);
  vec3 light = seen.rgb;
  if (has_airlight) {
    vec3 direction = pixel_direction(pixel);
    float end = fog_before_sky(direction);
    light += lamps_glow(direction, seen.a * end > 1.0 ? 1.0 / seen.a : end);
  }
  if (is_measured) {
    color = vec4(light, 1.0);
    return;
  }
  light = min(light * exposure_gain, 1.0e30);
  vec3 shown = is_neutral ? neutral(light) : min(light, 1.0);
  color = vec4(srgb(clamp(shown, 0.0, 1.0)) + dither(gl_FragCoord.xy) / 255.0, 1.0);
}
