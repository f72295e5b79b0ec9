// SPDX-License-Identifier: Apache-2.0
#include "window/airlight_curve.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "litfog/multiple_scattering.h"

namespace litfog::window {

AirlightCurve make_airlight_curve(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray,
                                  int samples) {
  const glm::dvec3 to_light = light.position - ray.origin;
  const double passing = std::max(2 * glm::dot(to_light, ray.direction), glm::length(to_light));
  AirlightCurve curve{.end = std::max(std::min(ray.length, passing), 0.1), .single = {}, .all = {}};
  std::vector<EyeRay> rays(std::size_t(samples), ray);
  for (std::size_t i = 0; i < rays.size(); ++i) rays[i].length = curve.end * double(i) / double(samples - 1);
  curve.single.resize(rays.size());
  airlight(light, atmosphere, rays, LampLeg::fogged, curve.single);
  if (find_scattering_error(atmosphere)) return curve;
  curve.all.resize(rays.size());
  multiple_scattering(light, atmosphere, make_scattering_table(atmosphere), rays, curve.all);
  for (std::size_t i = 0; i < rays.size(); ++i) curve.all[i] += curve.single[i];
  return curve;
}

}  // namespace litfog::window
