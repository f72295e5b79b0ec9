// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "litfog/fit/attenuation_fit.h"
#include "litfog/fit/cone_fit.h"
#include "reference/random_light.h"

namespace litfog::test {

/// Targets of all magnitudes, most of which find_error() accepts.
inline AttenuationTarget draw_attenuation_target(Random& random) {
  const double decades = random.pick(std::array{1.0, 5.0, 29.0}), middle = random.uniform(-29, 29);
  const auto draw_range = [&] {
    return std::pow(10, std::clamp(middle + random.uniform(-decades, decades), -29.9, 29.9));
  };
  std::vector<double> ranges;
  for (int k = int(random.uniform(0, 8)); k > 0; --k) ranges.push_back(draw_range());
  if (random.chance(0.2)) ranges.push_back(0);
  std::sort(ranges.begin(), ranges.end());
  ranges.erase(std::unique(ranges.begin(), ranges.end()), ranges.end());
  const double darkest = random.pick(std::array{1.0, 5.0, 100.0}), weights = random.pick(std::array{0.0, 1.0, 100.0});
  AttenuationTarget target{.threshold = random.chance(0.5) ? 0.05 : std::pow(10, -random.uniform(1e-9, 100)),
                           .is_robust = random.chance(0.3)};
  for (const double range : ranges) {
    target.samples.push_back({range, random.chance(0.2) ? 1 : std::pow(10, -random.uniform(0, darkest)),
                              std::pow(10, random.uniform(-weights, weights))});
  }
  if (random.chance(0.5)) target.extent = draw_range();
  if (random.chance(0.4)) target.constant = random.pick(std::array{0.0, 1.0, std::pow(10, random.uniform(-99, 99))});
  return target;
}

/// Beams as measured, and what is none: noise, lobes, rings.
inline std::vector<ConeSample> draw_cone_samples(Random& random) {
  const double last = random.log_uniform(std::numbers::pi / 90, std::numbers::pi);
  const int count = 3 + int(random.uniform(0, 20));
  const double width = last * random.uniform(0.1, 1);
  const int kind = int(random.uniform(0, 5));
  std::vector<ConeSample> samples;
  double angle = random.chance(0.8) ? 0 : random.uniform(0, last / 10);
  for (int i = 0; i < count; ++i) {
    const double x = angle / width;
    double fraction = random.uniform(0, 1);                                                              // anything
    if (kind == 0) fraction = std::exp(-x * x * 2);                                                      // Gaussian
    if (kind == 1) fraction = 1 / (1 + std::pow(x * 2, 4)) + 0.02;                                       // with spill
    if (kind == 2) fraction = std::max(0.0, 1 - x) * (1 + random.uniform(-0.1, 0.1));                    // noisy
    if (kind == 3) fraction = 0.1 + std::exp(-x * x * 4) + 0.8 * std::exp(-(x - 1.5) * (x - 1.5) * 20);  // a ring
    samples.push_back({angle, fraction * 12345, random.chance(0.5) ? 1 : random.log_uniform(0.1, 10)});
    angle += last / count * random.uniform(0.5, 1.4);
    if (angle > std::numbers::pi) break;
  }
  return samples;
}

}  // namespace litfog::test
