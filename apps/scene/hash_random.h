// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace litfog::scene {

/// Bijective 32-bit mixer ("lowbias32", Wellons 2018). The standard library's distributions differ between
/// implementations; models and materials must not.
constexpr std::uint32_t hash(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  return x ^ (x >> 16);
}

constexpr std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  return hash(x + hash(y + hash(seed)));
}

/// A number in [0, 1) of the upper 24 bits, which a float holds exactly.
constexpr float unit_float(std::uint32_t bits) { return float(bits >> 8) * 0x1p-24f; }

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
