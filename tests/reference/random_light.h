// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>

#include "litfog/attenuation.h"
#include "litfog/fog.h"

namespace litfog::test {

/// A light and its fog: the arguments of a solve.
struct SolveCase {
  Attenuation attenuation;
  Fog fog;
  double threshold;
};

inline std::string to_string(const SolveCase& c) {
  char text[256];
  std::snprintf(text, sizeof text, "%s fog, density %a = %.17g, constant %a = %.17g, linear %a = %.17g, ",
                name_of(c.fog.mode), c.fog.density, c.fog.density, c.attenuation.constant, c.attenuation.constant,
                c.attenuation.linear, c.attenuation.linear);
  std::string result = text;
  std::snprintf(text, sizeof text, "quadratic %a = %.17g, threshold %a = %.17g", c.attenuation.quadratic,
                c.attenuation.quadratic, c.threshold, c.threshold);
  return result + text;
}

/// How many random cases a test draws that draws so many by default: the environment's LITFOG_TEST_SCALE times as many.
inline int scaled_count(int by_default) {
  const char* const scale = std::getenv("LITFOG_TEST_SCALE");
  if (!scale) return by_default;
  char* end = nullptr;
  const double times = std::strtod(scale, &end);
  if (*end != '\0' || !(times >= 1 && times * by_default <= std::numeric_limits<int>::max())) {
    throw std::invalid_argument(std::string("LITFOG_TEST_SCALE = ") + scale +
                                ": must be at least 1, for fewer than 2^31 cases");
  }
  return int(times * by_default);
}

/// The same values on every machine and library: the standard's engine, no distribution of the library's.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// For fuzzers: draws are eight bytes each, as long as there are any. The bytes have to outlive this.
  explicit Random(std::string_view bytes) : engine_(1), bytes_(bytes) {}

  std::uint64_t bits() {
    if (bytes_.empty()) return engine_();
    std::uint64_t bits = 0;
    std::memcpy(&bits, bytes_.data(), std::min(bytes_.size(), sizeof bits));
    bytes_.remove_prefix(std::min(bytes_.size(), sizeof bits));
    return bits;
  }
  double uniform(double low, double high) { return low + (high - low) * (double(bits() >> 11) * 0x1p-53); }
  double log_uniform(double low, double high) {
    return std::clamp(std::exp(uniform(std::log(low), std::log(high))), low, high);  // e^log(5) is below 5
  }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  int below(int count) { return int(bits() % std::uint64_t(count)); }

  template <typename Container>
  auto pick(const Container& container) {
    return container[bits() % std::size(container)];
  }

  /// Any positive finite T by its bits; one in eight is subnormal.
  template <typename T>
  T any_positive() {
    using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
    const Bits largest = std::bit_cast<Bits>(std::numeric_limits<T>::max());
    const Bits smallest_normal = std::bit_cast<Bits>(std::numeric_limits<T>::min());
    const Bits drawn = Bits(bits());
    return std::bit_cast<T>(Bits(1 + (chance(0.125) ? drawn % (smallest_normal - 1) : drawn % largest)));
  }

 private:
  std::mt19937_64 engine_;
  std::string_view bytes_;
};

/// Evenly over the sphere.
inline glm::dvec3 draw_direction(Random& random) {
  const double z = random.uniform(-1, 1);
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  const double radius = std::sqrt(1 - z * z);
  return glm::normalize(glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), z));
}

/// Lights as they occur, with some of their kinds' corners: C = 0, C = 1, clamped, linear or quadratic only.
inline SolveCase draw_ordinary_case(Random& random, FogMode mode) {
  const double constant = random.chance(0.1) ? 0 : random.chance(0.2) ? 1 : random.log_uniform(0.05, 5);
  const double linear = random.chance(0.15) ? 0 : random.log_uniform(1e-6, 1);
  const double quadratic = linear > 0 && random.chance(0.15) ? 0 : random.log_uniform(1e-8, 1);
  return {{constant, linear, quadratic}, {mode, random.log_uniform(1e-5, 1)}, random.log_uniform(2e-3, 0.19)};
}

}  // namespace litfog::test
