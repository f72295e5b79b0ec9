// SPDX-License-Identifier: Apache-2.0
#include "litfog/airlight.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "airlight_quadrature.h"
#include "airlight_text.h"
#include "model/float_limit.h"
#include "model/level_range.h"
#include "model/require.h"
#include "model/unchecked.h"
#include "require_rays.h"

namespace litfog {
namespace {

using airlight_text::NoCookie;
using airlight_text::Text;
using phase_text::pack;

void require_all(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray) {
  require(find_error(light));
  require(find_error(atmosphere));
  require(find_error(ray));
}

/// A light in the fog of its class, and what of it is the same for all rays.
struct SeenLight {
  SeenLight(const PlacedLight& placed, const Atmosphere& atmosphere, LampLeg leg)
      : light(placed),
        class_fog(unchecked::scaled(atmosphere.fog, placed.light.density_scale)),
        phase(atmosphere.phase),
        layers(atmosphere.profile),
        lamp_leg(leg),
        extent(unchecked::compute_extent(placed.light.attenuation, placed.light.threshold)) {}

  /// Whether no product of the fast form leaves double's range.
  bool is_ordinary() const {
    const auto [constant, linear, quadratic] = light.light.attenuation;
    const auto is_moderate = [](double x) { return x == 0 || (x >= 1e-20 && x <= 1e20); };
    return std::ranges::all_of(std::array{constant, linear, quadratic, light.light.threshold, class_fog.density},
                               is_moderate) &&
           std::ranges::all_of(layers.used(), is_moderate, &DensityKnot::density);
  }

  const PlacedLight& light;
  Fog class_fog;
  Phase phase;
  const DensityProfile& layers;
  LampLeg lamp_leg;
  double extent;
};

template <typename Real>
double integrated_airlight(const SeenLight& seen, const EyeRay& ray, Real agreement) {
  const Light& light = seen.light.light;
  const Real extent = level_range(convert<Real>(light.attenuation), static_cast<Real>(light.threshold)).high;
  const NoCookie no_cookie;
  const auto layers = convert<Real>(seen.layers);
  const Text<Real, NoCookie> text{no_cookie, layers};
  return double(integrate_airlight(
      text, text.seen_along(seen.light, extent, seen.class_fog, ray, seen.lamp_leg, pack<Real>(seen.phase)),
      agreement));
}

double exact_airlight(const SeenLight& seen, const EyeRay& ray) {
  return integrated_airlight(seen, ray, airlight_text::kReferenceAgreement);
}

double fast_airlight(const SeenLight& seen, const EyeRay& ray) {
  if (!seen.is_ordinary()) return exact_airlight(seen, ray);
  const NoCookie no_cookie;
  Text<double, NoCookie> text{no_cookie, seen.layers};
  return text.litfog_airlight(
      text.seen_along(seen.light, seen.extent, seen.class_fog, ray, seen.lamp_leg, pack<double>(seen.phase)));
}

/// axial_airlight of checked arguments, beyond the plateau panel by panel, each eight times as long as the one before.
/// It ends where f is e^-50: a falls, so that all beyond is less than that fraction of what comes from within 1/d.
long double integrate_axially(const Attenuation& narrow, const Fog& fog, double threshold) {
  const auto attenuation = convert<long double>(narrow);
  const long double density = fog.density;
  const long double extent = level_range(attenuation, static_cast<long double>(threshold)).high;
  const bool is_exp = fog.mode == FogMode::exp;
  if (density == 0 || extent == 0) return 0;
  if (std::isinf(density) || std::isinf(extent)) return 1 / std::max(1.0L, attenuation.constant);

  const long double knee = std::min(level_range(attenuation, 1.0L).high, extent);
  const long double end = std::min(extent, (is_exp ? 50 : 7.1L) / density);
  const auto integrand = [&](long double range) {
    const long double depth = density * range;
    const long double scattered = is_exp ? std::exp(-depth) : 2 * depth * std::exp(-depth * depth);
    return density * scattered *
           formulas::attenuation(range, attenuation.constant, attenuation.linear, attenuation.quadratic);
  };
  airlight_text::Bisection bisection(integrand, 1e-14L);
  long double sum = formulas::opacity(is_exp ? density * knee : density * knee * density * knee);
  const long double halved = level_range(attenuation, 1 / (2 * std::max(1.0L, attenuation.constant))).high;
  long double size = std::min(1 / density, halved - knee);
  for (long double low = knee; low < end; size *= 8) {
    const long double high = size < end - low ? low + size : end;
    sum += bisection.refine(low, high, bisection.estimate(low, high), 0, 40);
    low = high;
  }
  return sum;
}

}  // namespace

std::optional<ValueError> find_error(const EyeRay& ray) {
  if (const auto error = find_position_error(ray.origin, {"origin.x", "origin.y", "origin.z"})) return error;
  if (const auto error = find_direction_error(ray.direction, "direction")) return error;
  if (!(ray.length >= 0)) return ValueError{"length", ray.length, "must be >= 0"};
  return std::nullopt;
}

double airlight(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray, LampLeg lamp_leg) {
  require_all(light, atmosphere, ray);
  return fast_airlight(SeenLight(light, atmosphere, lamp_leg), ray);
}

void airlight(const PlacedLight& light, const Atmosphere& atmosphere, std::span<const EyeRay> rays, LampLeg lamp_leg,
              std::span<double> airlights) {
  assert(rays.size() == airlights.size());
  require(find_error(light));
  require(find_error(atmosphere));
  require_rays(rays);
  const SeenLight seen(light, atmosphere, lamp_leg);
  std::transform(rays.begin(), rays.end(), airlights.begin(),
                 [&](const EyeRay& ray) { return fast_airlight(seen, ray); });
}

double reference_airlight(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray, LampLeg lamp_leg) {
  require_all(light, atmosphere, ray);
  return exact_airlight(SeenLight(light, atmosphere, lamp_leg), ray);
}

double picture_airlight(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray, LampLeg lamp_leg) {
  require_all(light, atmosphere, ray);
  const SeenLight seen(light, atmosphere, lamp_leg);
  return seen.is_ordinary() ? integrated_airlight(seen, ray, kPictureAirlightMaxError) : exact_airlight(seen, ray);
}

double bound_airlight(const PlacedLight& light, const Atmosphere& atmosphere, const glm::dvec3& eye,
                      const glm::dvec3& direction, double half_angle, LampLeg lamp_leg) {
  constexpr double kMargin = 1e-12;
  const double largest_slope = std::sqrt(2 / std::numbers::e);  // of 1 - e^-(x^2)
  require_all(light, atmosphere, {eye, direction});
  if (!is_within(half_angle, 0, std::numbers::pi)) {
    require(ValueError{"half_angle", half_angle, "must be in [0, pi]"});
  }
  const double extent = unchecked::compute_extent(light.light.attenuation, light.light.threshold) * (1 + kMargin);
  const Fog thinnest = unchecked::scaled(atmosphere.thinnest_fog(), light.light.density_scale);
  const Fog thickest = unchecked::scaled(atmosphere.thickest_fog(), light.light.density_scale);
  const double density = thickest.density;
  if (density == 0 || extent == 0) return 0;

  const glm::dvec3 to_light = light.position - eye;
  const double range = glm::length(to_light);
  const double from_axis = std::atan2(glm::length(glm::cross(direction, to_light)), glm::dot(direction, to_light));
  const double outside = std::max(from_axis - half_angle - kMargin, 0.0);
  const double nearest = range * (outside < std::numbers::pi / 2 ? std::sin(outside) : 1);
  const double closest = std::max(nearest * (1 - kMargin), 0.0);
  if (closest >= extent) return 0;

  const double start = std::max(range * (1 - kMargin) - extent, 0.0);
  const double chord = 2 * std::sqrt(extent - closest) * std::sqrt(extent + closest);
  const double opacity = thickest.mode == FogMode::exp
                             ? fog_factor_at(thinnest, start) * opacity_at(thickest, chord)
                             : std::min(fog_factor_at(thickest, start), chord * density * largest_slope);
  const double lit = lamp_leg == LampLeg::fogged ? fog_factor_at(thinnest, closest) : 1;
  // One subnormal more: the products may be rounded down to 0.
  return largest_phase(atmosphere.phase) * attenuation_at(light.light.attenuation, closest) * opacity * lit *
             (1 + 8 * kMargin) +
         std::numeric_limits<double>::denorm_min();
}

double light_reach(const Light& light, const Fog& fog, double budget, LampLeg lamp_leg) {
  require(find_error(light));
  require(find_error(fog));
  if (!(budget > 0 && budget < 1)) require(ValueError{"budget", budget, "must be in (0, 1)"});
  const Fog class_fog = unchecked::scaled(fog, light.density_scale);
  const auto shown_at = [&](double range) {
    return attenuation_at(light.attenuation, range) *
           (lamp_leg == LampLeg::fogged ? fog_factor_at(class_fog, range) : 1);
  };
  double high = unchecked::compute_extent(light.attenuation, light.threshold);
  if (!(shown_at(high) < budget)) return high;
  double low = 0;
  if (shown_at(low) < budget) return low;
  high = std::min(high, std::numeric_limits<double>::max());
  if (!(shown_at(high) < budget)) return std::numeric_limits<double>::infinity();
  constexpr double kLeast = std::numeric_limits<double>::min();
  while (high > low * (1 + 1e-9) && high > kLeast) {
    const double middle =
        high > 4 * low ? std::max({std::sqrt(low) * std::sqrt(high), high * 0x1p-64, kLeast}) : low + (high - low) / 2;
    (shown_at(middle) < budget ? high : low) = middle;
  }
  return high;
}

double reach_budget(double step, std::size_t lights, double brightness, const Atmosphere& atmosphere) {
  if (!(step > 0 && is_finite_and_not_negative(step))) require(ValueError{"step", step, "must be finite and > 0"});
  if (!is_finite_and_not_negative(brightness)) {
    require(ValueError{"brightness", brightness, "must be finite and >= 0"});
  }
  require(find_error(atmosphere));
  const double most = 1 + airlight_unit(atmosphere) * largest_phase(atmosphere.phase);
  return std::clamp(step / most / double(lights) / brightness, std::numeric_limits<double>::min(), 0.5);
}

double axial_airlight(const Attenuation& attenuation, const Fog& fog, double threshold) {
  require(find_error(attenuation));
  require(find_error(fog));
  require(find_threshold_error(threshold));
  return double(integrate_axially(attenuation, fog, threshold));
}

double axial_airlight(const Light& light, const Fog& fog) {
  require(find_error(light));
  require(find_error(fog));
  const Fog class_fog = unchecked::scaled(fog, light.density_scale);
  return double(integrate_axially(light.attenuation, class_fog, light.threshold));
}

}  // namespace litfog
