// SPDX-License-Identifier: Apache-2.0
#include "render/light/hidden_range.h"

#include <cmath>
#include <limits>

#include "litfog/attenuation.h"

namespace litfog::render {

double visible_step(double exposure) {
  constexpr double kDarkestSlope = 12.92;  // IEC 61966-2-1
  return std::exp2(-exposure) / (255 * kDarkestSlope);
}

double hidden_range(const Fog& fog, double brightness, double budget) {
  if (!(brightness > budget)) return 0;
  if (!(fog.density > 0)) return std::numeric_limits<double>::infinity();
  constexpr double kRounding = 1 + 1e-6;  // also covers the rounding of the shaders' floats
  const double depth = std::log(brightness / budget);
  return kRounding * (fog.mode == FogMode::exp ? depth : std::sqrt(depth)) / fog.density;
}

double largest_irradiance(const Light& light, const glm::dvec3& position, double extent, const Fog& fog,
                          FogLighting fog_lighting, const LightingPath& path, const scene::Bounds& box) {
  const double range = path.evaluation == Evaluation::fragment ? nearest_distance(position, box) : 0;
  if (range > extent) return 0;
  const double factor =
      fog_lighting == FogLighting::airlight ? fog_factor_at(scaled(fog, light.density_scale), range) : 1;
  if (path.range == RangeLaw::radial) return factor * (std::isinf(extent) ? 1 : 1 - range * range / (extent * extent));
  return factor * attenuation_at(light.attenuation, range);
}

bool can_light_from(const PlacedLight& light, double half_angle, const glm::dvec3& eye, const scene::Bounds& box,
                    double range) {
  const glm::dvec3 middle = (glm::dvec3(box.low) + glm::dvec3(box.high)) / 2.0 - eye;
  const double distance = glm::length(middle);
  const double radius = glm::distance(glm::dvec3(box.low), glm::dvec3(box.high)) / 2;
  const double delta = glm::distance(eye, light.position);
  if (!(radius < distance && delta < range)) return true;
  constexpr double kRounding = 1e-4;  // radians; also covers the rounding of the shaders' floats
  const double angle = std::atan2(glm::length(glm::cross(middle, light.direction)), glm::dot(middle, light.direction));
  return angle <= half_angle + std::asin(radius / distance) + std::asin(delta / range) + kRounding;
}

}  // namespace litfog::render
