// SPDX-License-Identifier: Apache-2.0
#include "litfog/light_bounds.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lit_polytope.h"
#include "model/float_limit.h"
#include "model/require.h"

namespace litfog {

std::optional<ValueError> find_error(const LightBounds& bounds) {
  if (const auto error = find_position_error(bounds.position, {"position.x", "position.y", "position.z"})) return error;
  if (const auto error = find_direction_error(bounds.direction, "direction")) return error;
  if (!(bounds.range >= 0)) return ValueError{"range", bounds.range, "must be >= 0"};
  if (!is_within(bounds.half_angle, 0, std::numbers::pi)) {
    return ValueError{"half_angle", bounds.half_angle, "must be in [0, pi]"};
  }
  return std::nullopt;
}

bool can_light(const LightBounds& light, const glm::dvec3& low, const glm::dvec3& high) {
  require(find_error(light));
  constexpr std::array kNames{"low.x", "low.y", "low.z"};
  for (int i = 0; i < 3; ++i) {
    if (!(std::isfinite(low[i]) && std::isfinite(high[i]) && low[i] <= high[i])) {
      require(ValueError{kNames[std::size_t(i)], low[i], "must be finite and at most that of high, also finite"});
    }
  }
  const glm::dvec3 nearest = glm::clamp(light.position, low, high) - light.position;
  if (!(glm::length(nearest) <= light.range * (1 + kPolytopeRounding))) return false;
  Corners corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners[i] =
        glm::dvec3((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z) -
        light.position;
  }
  const glm::dvec3 farthest = glm::max(glm::abs(low - light.position), glm::abs(high - light.position));
  return can_light(light, glm::dvec3(0), corners, nearest, glm::length(farthest));
}

}  // namespace litfog
