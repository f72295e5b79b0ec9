// SPDX-License-Identifier: Apache-2.0
#include "bench/rival.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

namespace litfog::bench {
namespace {

/// The function to maximise: (1 - f(r)) a(r), without the checks of the public functions.
struct Airlight {
  Attenuation attenuation;
  Fog fog;

  double operator()(double range) const {
    const double depth = fog.density * range;
    const double opacity = -std::expm1(fog.mode == FogMode::exp ? -depth : -depth * depth);
    const double denominator = attenuation.constant + range * (attenuation.linear + range * attenuation.quadratic);
    return opacity / std::max(denominator, 1.0);
  }
};

}  // namespace

double brent_intensity(const Attenuation& attenuation, const Fog& fog, double threshold) {
  const Airlight airlight{attenuation, fog};
  const double end = compute_extent(attenuation, threshold);
  constexpr int kBits = std::numeric_limits<double>::digits / 2;
  const auto [range, minimum] =
      boost::math::tools::brent_find_minima([&](double r) { return -airlight(r); }, 0.0, end, kBits);
  return std::max(-minimum, airlight(end));
}

}  // namespace litfog::bench
