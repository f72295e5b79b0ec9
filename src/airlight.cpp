// SPDX-License-Identifier: Apache-2.0
#include "litfog/airlight.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "airlight_text.h"
#include "require.h"
#include "unchecked.h"

namespace litfog {
namespace {

/// Stands for no cookie.
struct NoCookie {
  double operator()(double) const { return 1; }
};
using Text = airlight_text::Text<NoCookie>;

/// A light as a ray sees it, in the fog of its class.
Text::LitfogAirlight seen_along(const PlacedLight& placed, const Fog& fog, const EyeRay& ray,
                                const Scattering& scattering) {
  const Light& light = placed.light;
  const glm::dvec3 direction = glm::normalize(ray.direction);
  const glm::dvec3 axis = glm::normalize(placed.direction);
  const glm::dvec3 to_light = placed.position - ray.origin;
  const double approach = glm::dot(to_light, direction);
  const glm::dvec3 offset = approach * direction - to_light;  // from the light to the closest approach
  Text::LitfogAirlight air{};
  air.density = std::min(unchecked::scaled(fog, light.density_scale).density, 1e12);
  air.mode = fog.mode == FogMode::exp ? 0 : 1;
  air.lamp_leg = scattering.lamp_leg == LampLeg::fogged ? 1 : 0;
  air.asymmetry = scattering.asymmetry;
  air.constant = light.attenuation.constant;
  air.linear = light.attenuation.linear;
  air.quadratic = light.attenuation.quadratic;
  air.extent = std::min(unchecked::compute_extent(light.attenuation, light.threshold), Text::litfog_far);
  if (light.cone.profile == ConeProfile::cosine) {
    air.profile = 1;
    air.cone_x = std::cos(light.cone.half_angle);
    air.cone_y = light.cone.exponent;
  } else if (light.cone.profile == ConeProfile::smoothstep) {
    air.profile = 2;
    air.cone_x = std::cos(light.cone.outer);
    air.cone_y = std::cos(light.cone.inner);
  }
  air.length = std::min(ray.length, Text::litfog_far);
  air.approach = approach;
  air.offset = glm::length(offset);
  air.axis_offset = glm::dot(offset, axis);
  air.axis_slope = glm::dot(direction, axis);
  air.nodes = Text{NoCookie{}}.litfog_airlight_nodes(air);
  return air;
}

}  // namespace

std::optional<ValueError> check(const Scattering& scattering) {
  if (!(std::abs(scattering.asymmetry) < 1)) return ValueError{"asymmetry", scattering.asymmetry, "must be in (-1, 1)"};
  return std::nullopt;
}

std::optional<ValueError> check(const EyeRay& ray) {
  constexpr const char* kRule = "must be at most 16777216 in magnitude";
  if (!(std::abs(ray.origin.x) <= kMaxPosition)) return ValueError{"origin.x", ray.origin.x, kRule};
  if (!(std::abs(ray.origin.y) <= kMaxPosition)) return ValueError{"origin.y", ray.origin.y, kRule};
  if (!(std::abs(ray.origin.z) <= kMaxPosition)) return ValueError{"origin.z", ray.origin.z, kRule};
  const double length = glm::length(ray.direction);
  if (!(std::abs(length - 1) <= kDirectionTolerance)) {
    return ValueError{"direction", length, "length must be 1 within 1e-6"};
  }
  if (!(ray.length >= 0)) return ValueError{"length", ray.length, "must be >= 0"};
  return std::nullopt;
}

double airlight(const PlacedLight& light, const Fog& fog, const EyeRay& ray, const Scattering& scattering) {
  require(check(light));
  require(check(fog));
  require(check(ray));
  require(check(scattering));
  return Text{NoCookie{}}.litfog_airlight(seen_along(light, fog, ray, scattering));
}

}  // namespace litfog
