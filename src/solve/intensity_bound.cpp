// SPDX-License-Identifier: Apache-2.0
#include "litfog/intensity_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "litfog/batch.h"
#include "model/level_range.h"
#include "model/require.h"

namespace litfog {
namespace {

using Limits = std::numeric_limits<double>;

/// x raised by the header's margin, and to the next double in case x is subnormal.
double raise(long double x) {
  constexpr double kMargin = 8 * kBatchIntensityMaxUlp * Limits::epsilon();
  return std::nextafter(double(x * (1 + kMargin)), Limits::infinity());
}

/// The supremum of r a(r) over [0, extent] for a light with an end.
long double find_exp_reach(const BasicAttenuation<long double>& attenuation, long double extent) {
  const auto [constant, linear, quadratic] = attenuation;
  const long double knee = level_range(attenuation, 1.0L).high;
  const long double stationary = constant == 0 ? 0 : std::sqrt(constant / quadratic);  // infinite where Q = 0
  const long double range = std::min(std::max(stationary, knee), extent);
  return range / std::max(1.0L, constant + range * (linear + quadratic * range));
}

}  // namespace

IntensityBound::IntensityBound(const Attenuation& attenuation, double threshold)
    : highest_attenuation_(0), exp_reach_(0), exp2_reach_(0) {
  require(find_error(attenuation));
  require(find_threshold_error(threshold));
  const auto wide = convert<long double>(attenuation);  // E^2 and C/Q can leave double's range
  const long double extent = level_range(wide, static_cast<long double>(threshold)).high;
  if (extent == 0) return;
  highest_attenuation_ = std::min(1.0, raise(1 / wide.constant));
  exp_reach_ = std::isinf(extent) ? Limits::infinity() : raise(find_exp_reach(wide, extent));
  exp2_reach_ = raise(extent * std::sqrt(static_cast<long double>(threshold)));
}

double IntensityBound::at(const Fog& fog) const {
  if (fog.density == 0 || highest_attenuation_ == 0) return 0;  // infinity * 0 is NaN
  const double depth = fog.density * (fog.mode == FogMode::exp ? exp_reach_ : exp2_reach_);
  // One subnormal more: the products may be rounded down to 0.
  return std::min(highest_attenuation_, (fog.mode == FogMode::exp ? depth : depth * depth) + Limits::denorm_min());
}

}  // namespace litfog
