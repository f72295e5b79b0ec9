// SPDX-License-Identifier: Apache-2.0
#include "litfog/atmosphere.h"

#include <cmath>

#include "model/require.h"

namespace litfog {

Atmosphere Atmosphere::seen_from(double height) const {
  Atmosphere air = *this;
  air.top -= height;
  for (std::size_t i = 0; i < profile.count; ++i) air.profile.knots[i].height -= height;
  return air;
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
