// SPDX-License-Identifier: Apache-2.0
// From a scene's light, linear and unbounded, to what a display shows. C++ takes this text through render/display.cpp;
// render/display.h says where the tone curves are from.

#ifndef __cplusplus
#include "scene/hash.glsl"
#include "scene/srgb.glsl"
#endif

// What is below 0 or not a number is black. A large number stands for infinity, whose ratios are no numbers.
float exposed(float light, float gain) { return light > 0.0f ? min(light * gain, 1.0e30f) : 0.0f; }

// The names and figures are those of the published definition.
vec3 neutral(vec3 color) {
  const float f90 = 0.04f;
  const float start_compression = 0.8f - f90;
  const float desaturation = 0.15f;
  const float d = 1.0f - start_compression;
  float x = min(min(color.r, color.g), color.b);
  color -= x < 2.0f * f90 ? x - x * x / (4.0f * f90) : f90;
  float peak = max(max(color.r, color.g), color.b);
  if (peak < start_compression) return color;
  float new_peak = 1.0f - d * d / (peak + d - start_compression);
  color *= new_peak / peak;
  float g = 1.0f - 1.0f / (desaturation * (peak - new_peak) + 1.0f);
  return mix(color, vec3(new_peak), g);
}

// color  exposed
vec3 toned(bool is_neutral, vec3 color) { return is_neutral ? neutral(color) : min(color, 1.0f); }

// A toned value in sRGB, in 1/255, dithered against banding: the mean is the value.
//
// index  of the value in the picture: the top row comes first, and of a pixel its red
float shown_level(float shown, uint index) {
  return min(floor(255.0f * srgb_from_linear(shown) + unit_float(hash(index))), 255.0f);
}
