// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace litfog::scene {

// The standard library's distributions differ between implementations; models and materials must not.
using uint = std::uint32_t;
#define LITFOG_FUNCTION constexpr
#include "scene/hash.glsl"  // undefines it

constexpr std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  return hash(x + hash(y + hash(seed)));
}

/// A seeded sequence of numbers, the same on every machine: the hashes of a counter.
/// Draw once per statement: the order in which a call evaluates its arguments differs between compilers.
class HashRandom {
 public:
  explicit HashRandom(std::uint32_t seed) : key_(hash(seed)) {}
  std::uint32_t bits() { return hash(counter_++ + key_); }
  float unit() { return unit_float(bits()); }
  float between(float low, float high) { return low + (high - low) * unit(); }

 private:
  std::uint32_t key_;
  std::uint32_t counter_ = 0;
};

}  // namespace litfog::scene
