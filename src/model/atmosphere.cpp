// SPDX-License-Identifier: Apache-2.0
#include "litfog/atmosphere.h"

#include <algorithm>
#include <cmath>

#include "model/require.h"

namespace litfog {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Whether the profile's last density goes on upwards.
bool is_open(const DensityProfile& profile) { return profile_density_at(profile, kInfinity) > 0; }

/// A top, or the last knot where that is higher.
double at_last_knot(double top, const DensityProfile& profile) {
  return profile.count > 0 ? std::max(top, profile.used().back().height) : top;
}

}  // namespace

Atmosphere Atmosphere::seen_from(double height) const {
  Atmosphere air = *this;
  air.top -= height;
  for (std::size_t i = 0; i < profile.count; ++i) air.profile.knots[i].height -= height;
  return air;
}

double Atmosphere::top_above(double height) const {
  return is_open(profile) ? kInfinity : at_last_knot(top, profile) - height;
}

double Atmosphere::light_top() const {
  if (is_open(profile)) return profile.used().back().height + kHazeHeight;
  return at_last_knot(top == kInfinity ? kHazeHeight : top, profile);
}

std::optional<ValueError> find_error(const Atmosphere& atmosphere) {
  if (const auto error = find_error(atmosphere.fog)) return error;
  if (const auto error = find_error(atmosphere.profile)) return error;
  if (atmosphere.profile.count > 0 && atmosphere.fog.mode == FogMode::exp2) {
    return ValueError{"profile.count", double(atmosphere.profile.count), "must be 0 in exp2 fog"};
  }
  if (const auto error = find_error(atmosphere.phase)) return error;
  if (!(atmosphere.albedo >= 0 && atmosphere.albedo <= 1)) {
    return ValueError{"albedo", atmosphere.albedo, "must be in [0, 1]"};
  }
  if (std::isnan(atmosphere.top)) return ValueError{"top", atmosphere.top, "must be a number"};
  return check_color(atmosphere.ambient_fog_color,
                     {"ambient_fog_color.r", "ambient_fog_color.g", "ambient_fog_color.b"});
}

}  // namespace litfog
