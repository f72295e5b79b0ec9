// SPDX-License-Identifier: Apache-2.0
#include "litfog/airlight.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "airlight_quadrature.h"
#include "airlight_text.h"
#include "level_range.h"
#include "require.h"
#include "unchecked.h"

namespace litfog {
namespace {

using airlight_text::NoCookie;
using airlight_text::Text;

void require_all(const PlacedLight& light, const Fog& fog, const EyeRay& ray, const Scattering& scattering) {
  require(check(light));
  require(check(fog));
  require(check(ray));
  require(check(scattering));
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
  require_all(light, fog, ray, scattering);
  Text<double, NoCookie> text{NoCookie{}};
  const double extent = unchecked::compute_extent(light.light.attenuation, light.light.threshold);
  const Fog class_fog = unchecked::scaled(fog, light.light.density_scale);
  const auto air = text.seen_along(light, extent, class_fog, ray, scattering);
  return std::isinf(class_fog.density) ? text.at_the_eye(air) : text.litfog_airlight(air);
}

double reference_airlight(const PlacedLight& light, const Fog& fog, const EyeRay& ray, const Scattering& scattering) {
  require_all(light, fog, ray, scattering);
  const Text<long double, NoCookie> text{NoCookie{}};
  const auto attenuation = convert<long double>(light.light.attenuation);
  const long double extent = level_range(attenuation, static_cast<long double>(light.light.threshold)).high;
  const Fog class_fog = unchecked::scaled(fog, light.light.density_scale);
  return double(integrate_airlight(text, text.seen_along(light, extent, class_fog, ray, scattering)));
}

}  // namespace litfog
