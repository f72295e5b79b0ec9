// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "litfog/batch.h"
#include "litfog/solve.h"

namespace litfog::bench {

/// The lights of a benchmark, one column per parameter.
template <typename Real>
struct LightColumns {
  std::vector<Real> constant, linear, quadratic, threshold, density;

  std::size_t size() const { return constant.size(); }
  BasicAttenuation<Real> attenuation(std::size_t i) const { return {constant[i], linear[i], quadratic[i]}; }
  BasicBatchLights<Real> view() const { return {constant, linear, quadratic, threshold, density}; }
};

/// The stated mix: extent 5 to 5,000 m and visibility (5 % contrast) 50 to 10,000 m, log-uniform; C below, at and above
/// 1 (uniform in [0, 1), 1, uniform in (1, 5]), a third each; beyond C linear only, quadratic only and both (in a
/// uniform fraction of the extent's attenuation), a third each; threshold 0.05. A seed gives the same lights on every
/// machine.
LightColumns<double> draw_light_mix(FogMode mode, std::size_t count, std::uint64_t seed);

/// The lights with parameters rounded to floats, which need references of their own.
LightColumns<float> to_float(const LightColumns<double>& lights);

/// Repeats the lights up to a count.
template <typename Real>
LightColumns<Real> repeated(const LightColumns<Real>& lights, std::size_t count) {
  LightColumns<Real> result;
  const auto repeat = [&](const std::vector<Real>& from, std::vector<Real>& to) {
    to.reserve(count);
    while (to.size() < count) {
      const std::size_t part = count - to.size() < from.size() ? count - to.size() : from.size();
      to.insert(to.end(), from.begin(), from.begin() + std::ptrdiff_t(part));
    }
  };
  repeat(lights.constant, result.constant);
  repeat(lights.linear, result.linear);
  repeat(lights.quadratic, result.quadratic);
  repeat(lights.threshold, result.threshold);
  repeat(lights.density, result.density);
  return result;
}

}  // namespace litfog::bench
