// SPDX-License-Identifier: Apache-2.0
#include "litfog/light.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "require.h"

namespace litfog {

std::optional<ValueError> check(const Light& light) {
  if (const auto error = check_color(light.color, {"color.r", "color.g", "color.b"})) return error;
  if (!is_finite_and_not_negative(light.density_scale)) {
    return ValueError{"density_scale", light.density_scale, "must be finite and >= 0"};
  }
  if (const auto error = check(light.attenuation)) return error;
  if (const auto error = check_threshold(light.threshold)) return error;
  return check(light.cone);
}

std::optional<ValueError> check(const PlacedLight& placed) {
  constexpr const char* kRule = "must be at most 16777216 in magnitude";
  const auto is_in_reach = [](double coordinate) { return std::abs(coordinate) <= kMaxPosition; };
  if (!is_in_reach(placed.position.x)) return ValueError{"position.x", placed.position.x, kRule};
  if (!is_in_reach(placed.position.y)) return ValueError{"position.y", placed.position.y, kRule};
  if (!is_in_reach(placed.position.z)) return ValueError{"position.z", placed.position.z, kRule};
  const double length = glm::length(placed.direction);
  if (!(std::abs(length - 1) <= kDirectionTolerance)) {
    return ValueError{"direction", length, "length must be 1 within 1e-6"};
  }
  return check(placed.light);
}

}  // namespace litfog
