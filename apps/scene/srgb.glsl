// SPDX-License-Identifier: Apache-2.0
// IEC 61966-2-1, of a value clamped to [0, 1]. Also compiled as C++ (scene/srgb.cpp).

float srgb_from_linear(float linear) {
  float x = clamp(linear, 0.0f, 1.0f);
  return x <= 0.0031308f ? 12.92f * x : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f;
}
