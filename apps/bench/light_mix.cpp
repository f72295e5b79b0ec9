// SPDX-License-Identifier: Apache-2.0
#include "bench/light_mix.h"

#include "reference/random_light.h"

namespace litfog::bench {

LightColumns<double> draw_light_mix(FogMode mode, std::size_t count, std::uint64_t seed) {
  test::Random random(seed);
  LightColumns<double> lights;
  for (std::size_t i = 0; i < count; ++i) {
    const int kind = int(random.uniform(0, 9));  // at random, so that no branch predictor learns the order
    const double extent = random.log_uniform(5, 5000);
    const double visibility = random.log_uniform(50, 10'000);
    const double below = random.uniform(0, 1);
    const double fraction = kind / 3 == 0 ? 1 : kind / 3 == 1 ? 0 : random.uniform(0, 1);
    const double constant = kind % 3 == 0 ? below : kind % 3 == 1 ? 1 : 5 - 4 * below;
    const double excess = 1 / kDefaultThreshold - constant;
    lights.constant.push_back(constant);
    lights.linear.push_back(fraction * excess / extent);
    lights.quadratic.push_back((1 - fraction) * excess / (extent * extent));
    lights.threshold.push_back(kDefaultThreshold);
    lights.density.push_back(Fog::from_visibility(mode, visibility).density);
  }
  return lights;
}

LightColumns<float> to_float(const LightColumns<double>& lights) {
  const auto column = [](const std::vector<double>& values) {
    return std::vector<float>(values.begin(), values.end());
  };
  return {column(lights.constant), column(lights.linear), column(lights.quadratic), column(lights.threshold),
          column(lights.density)};
}

}  // namespace litfog::bench
