// SPDX-License-Identifier: Apache-2.0
// From a scene's light, linear and unbounded, to a display. Also compiled as C++ (render/display.cpp); render/display.h
// has the sources of the tone curves.

#ifndef __cplusplus
#include "scene/hash.glsl"
#include "scene/srgb.glsl"
#endif

// Negative values and NaN become black. A large number replaces infinity, whose ratios are NaN.
float exposed(float light, float gain) { return light > 0.0f ? min(light * gain, 1.0e30f) : 0.0f; }

// Names and figures as in the published definition.
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

// A toned value in sRGB, in 1/255, dithered against banding without a bias.
//
// index  the value's index in the picture: top row first, red first
float shown_level(float shown, uint index) {
  return min(floor(255.0f * srgb_from_linear(shown) + unit_float(hash(index))), 255.0f);
}
