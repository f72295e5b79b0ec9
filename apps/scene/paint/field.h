// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace litfog::scene {

/// A square picture with one number per texel, which repeats in both directions. The side is a power of two.
class Field {
 public:
  explicit Field(int size, float value = 0.0f) : size_(size), values_(std::size_t(size) * std::size_t(size), value) {}
  int size() const { return size_; }
  std::size_t texels() const { return values_.size(); }
  float& operator[](std::size_t texel) { return values_[texel]; }
  float operator[](std::size_t texel) const { return values_[texel]; }
  std::size_t texel(int x, int y) const {
    const int mask = size_ - 1;
    return std::size_t((y & mask) * size_ + (x & mask));
  }
  float at(int x, int y) const { return values_[texel(x, y)]; }
  const std::vector<float>& values() const { return values_; }

 private:
  int size_;
  std::vector<float> values_;
};

/// Adds gradient noise of about +-0.7 * amplitude, with `across` by `along` features (powers of two, at most size / 2).
void add_noise(Field& field, int across, int along, float amplitude, std::uint32_t seed);

/// Adds octaves of gradient noise, each twice as fine and `decay` times as high as the one before, as far as the texels
/// resolve them.
void add_octaves(Field& field, int features, int octaves, float amplitude, std::uint32_t seed, float decay = 0.5f);

/// Adds an independent number in +-amplitude to every texel.
void add_grain(Field& field, float amplitude, std::uint32_t seed);

/// A field of octaves alone.
Field make_octaves(int size, int features, int octaves, std::uint32_t seed, float decay = 0.5f);

/// Calls visit(texel, dx, dy) for every texel whose middle lies within +-`reach` (texels, < size / 2) of a point; (dx,
/// dy) is the texel's distance from it. Wraps around the edges, so that the picture still repeats.
template <typename Visit>
void stamp(const Field& field, glm::vec2 middle, glm::vec2 reach, Visit visit) {
  const int x0 = int(std::ceil(middle.x - reach.x));
  const int x1 = int(std::floor(middle.x + reach.x));
  const int y0 = int(std::ceil(middle.y - reach.y));
  const int y1 = int(std::floor(middle.y + reach.y));
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      visit(field.texel(x, y), float(x) - middle.x, float(y) - middle.y);
    }
  }
}

}  // namespace litfog::scene
