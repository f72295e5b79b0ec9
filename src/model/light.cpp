// SPDX-License-Identifier: Apache-2.0
#include "litfog/light.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "float_limit.h"
#include "require.h"

namespace litfog {
namespace {

/// The attenuation's denominator that the source radius adds at the lamp, Q R^2.
double denominator_of_source(const Light& light) {
  return light.attenuation.quadratic * light.source_radius * light.source_radius;
}

double largest_component(const Light& light) { return std::max({light.color.r, light.color.g, light.color.b}); }

/// Needs find_error of all else to be nothing.
std::optional<ValueError> find_source_radius_error(const Light& light) {
  const auto wrong = [&](const char* rule) { return ValueError{"source_radius", light.source_radius, rule}; };
  if (!is_finite_and_not_negative(light.source_radius)) return wrong("must be finite and >= 0");
  if (light.source_radius == 0) return std::nullopt;
  if (light.attenuation.quadratic == 0) return wrong("must be 0 where attenuation.quadratic is 0");
  const double source = denominator_of_source(light);
  const bool is_too_large = !is_within(source, 0, light.attenuation.constant);
  if (is_too_large) return wrong("must be <= sqrt(attenuation.constant / quadratic)");
  const bool is_in_range = std::isnormal(light.threshold * source) && std::isnormal(source) &&
                           std::isfinite(1 / (light.source_radius * light.source_radius)) &&
                           std::isfinite(light.attenuation.linear / source) &&
                           std::isfinite(largest_component(light) * largest_flash(light.flash) / source);
  if (!is_in_range) return wrong("must leave color / (attenuation.quadratic source_radius^2) finite");
  return std::nullopt;
}

}  // namespace

std::optional<ValueError> find_error(const Light& light) {
  if (const auto error = check_color(light.color, {"color.r", "color.g", "color.b"})) return error;
  if (!is_finite_and_not_negative(light.density_scale)) {
    return ValueError{"density_scale", light.density_scale, "must be finite and >= 0"};
  }
  if (const auto error = find_error(light.attenuation)) return error;
  if (const auto error = find_threshold_error(light.threshold)) return error;
  if (const auto error = find_error(light.cone)) return error;
  if (const auto error = find_error(light.flash)) return error;
  const double brightest = largest_component(light) * largest_flash(light.flash);
  if (!std::isfinite(brightest)) return ValueError{"color", brightest, "must be finite in each flash"};
  return find_source_radius_error(light);
}

Light photometric(const Light& light) {
  require(find_error(light));
  if (light.source_radius == 0) return light;
  const double source = denominator_of_source(light);
  Light result = light;
  result.source_radius = 0;
  result.color /= source;
  result.attenuation = {1, light.attenuation.linear / source, 1 / (light.source_radius * light.source_radius)};
  result.threshold *= source;
  if (result.threshold >= 1) {
    result.color = glm::dvec3(0);
    result.threshold = light.threshold;
  }
  return result;
}

glm::dvec3 candela(const Light& light) {
  require(find_error(light));
  if (light.attenuation.quadratic == 0) return glm::dvec3(std::numeric_limits<double>::infinity());
  return kWhiteLux * light.color / light.attenuation.quadratic;
}

std::optional<ValueError> find_error(const PlacedLight& placed) {
  if (const auto error = find_position_error(placed.position, {"position.x", "position.y", "position.z"})) return error;
  if (const auto error = find_direction_error(placed.direction, "direction")) return error;
  return find_error(placed.light);
}

}  // namespace litfog
