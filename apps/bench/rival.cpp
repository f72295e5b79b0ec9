// SPDX-License-Identifier: Apache-2.0
#include "bench/rival.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

namespace litfog::bench {
namespace {

/// What is searched: (1 - f(r)) a(r), without the checks of the public functions.
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

double golden_section_intensity(const Attenuation& attenuation, const Fog& fog, double threshold) {
  const Airlight airlight{attenuation, fog};
  const double end = compute_extent(attenuation, threshold);
  constexpr double kRatio = 0.61803398874989485;  // (sqrt(5) - 1) / 2
  double low = 0;
  double high = end;
  double left = high - kRatio * (high - low);
  double right = low + kRatio * (high - low);
  double at_left = airlight(left);
  double at_right = airlight(right);
  while (high - low > 1e-8 * end) {
    if (at_left < at_right) {
      low = left;
      left = right;
      at_left = at_right;
      right = low + kRatio * (high - low);
      at_right = airlight(right);
    } else {
      high = right;
      right = left;
      at_right = at_left;
      left = high - kRatio * (high - low);
      at_left = airlight(left);
    }
  }
  return std::max({at_left, at_right, airlight(end)});
}

double brent_intensity(const Attenuation& attenuation, const Fog& fog, double threshold) {
  const Airlight airlight{attenuation, fog};
  const double end = compute_extent(attenuation, threshold);
  constexpr int kBits = std::numeric_limits<double>::digits / 2;
  const auto [range, minimum] =
      boost::math::tools::brent_find_minima([&](double r) { return -airlight(r); }, 0.0, end, kBits);
  return std::max(-minimum, airlight(end));
}

}  // namespace litfog::bench
