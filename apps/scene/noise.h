// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "scene/hash_random.h"

namespace litfog::scene {

/// Quintic fade of Perlin 2002: first and second derivative vanish at 0 and 1, so normals show no lattice.
constexpr float fade(float t) { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); }

/// The lattice gradient of a cell corner: components in [-1, 1).
struct Gradient {
  float x, y;
};
constexpr Gradient lattice_gradient(std::uint32_t column, std::uint32_t row, std::uint32_t seed) {
  const std::uint32_t bits = hash(column, row, seed);
  return {float(bits & 0xffffu) * 0x1p-15f - 1.0f, float(bits >> 16) * 0x1p-15f - 1.0f};
}

/// Gradient noise along a row of the lattice. At a height y inside the cell row, the contribution of a cell's left and
/// right corner is linear in x: slope * x + offset. A picture's row then costs two multiply-adds per texel.
struct NoiseEdge {
  float slope, offset;
};
constexpr NoiseEdge noise_edge(Gradient low, Gradient high, float y) {
  const float weight = fade(y);
  return {low.x + (high.x - low.x) * weight, low.y * y + (high.y * (y - 1.0f) - low.y * y) * weight};
}
constexpr float noise_between(NoiseEdge left, NoiseEdge right, float x, float faded_x) {
  const float at_left = left.slope * x + left.offset;
  const float at_right = right.slope * (x - 1.0f) + right.offset;
  return at_left + (at_right - at_left) * faded_x;
}

/// Gradient noise at a point: about [-0.7, 0.7], mean 0, one feature per unit. Does not repeat within 2^31 units.
inline float gradient_noise(float x, float y, std::uint32_t seed) {
  const float column = std::floor(x);
  const float row = std::floor(y);
  const auto i = std::uint32_t(std::int32_t(column));
  const auto j = std::uint32_t(std::int32_t(row));
  const NoiseEdge left = noise_edge(lattice_gradient(i, j, seed), lattice_gradient(i, j + 1, seed), y - row);
  const NoiseEdge right = noise_edge(lattice_gradient(i + 1, j, seed), lattice_gradient(i + 1, j + 1, seed), y - row);
  return noise_between(left, right, x - column, fade(x - column));
}

/// Sum of octaves, each twice as fine and half as high as the one before.
inline float octave_noise(float x, float y, int octaves, std::uint32_t seed) {
  float sum = 0.0f;
  float amplitude = 1.0f;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += amplitude * gradient_noise(x, y, seed + std::uint32_t(octave));
    x *= 2.0f;
    y *= 2.0f;
    amplitude *= 0.5f;
  }
  return sum;
}

}  // namespace litfog::scene
