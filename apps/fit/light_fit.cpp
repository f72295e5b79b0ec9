// SPDX-License-Identifier: Apache-2.0
#include "fit/light_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <numbers>
#include <numeric>

#include "files/light_json.h"
#include "litfog/color_temperature.h"
#include "litfog/photometry/axial_beam.h"
#include "litfog/photometry/elliptical_beam.h"
#include "text/shown_number.h"

namespace litfog::fit {

namespace {

/// A cone drawn out to the ellipses that were replaced by circles of the same solid angle: each of its circles becomes
/// the ellipse of the same solid angle whose half axes are in proportion between the given ones, so that its flux
/// stays.
std::vector<IsocandelaEllipse> stretched(const Cone& cone, const std::vector<BeamEllipse>& ellipses) {
  constexpr int kLines = 128;
  constexpr double kPi = std::numbers::pi;
  const std::size_t count = ellipses.size();
  const FullAngles& last = ellipses.back().angles;
  const auto ellipse_at = [&](double step) {  // 0 on the axis, i + 1 at ellipse i; beyond them in the last's proportion
    const std::size_t outer = std::min(std::size_t(step), count - 1);
    const FullAngles inner = outer == 0 ? FullAngles(0) : ellipses[outer - 1].angles;
    const FullAngles& angles = ellipses[outer].angles;
    const double t = std::min(step - double(outer), 1.0), scale = std::max(step / double(count), 1.0) / 2;
    return IsocandelaEllipse{.intensity = 0,
                             .horizontal = std::min(scale * std::lerp(inner.horizontal, angles.horizontal, t), kPi),
                             .vertical = std::min(scale * std::lerp(inner.vertical, angles.vertical, t), kPi)};
  };
  const auto circle_of = [](const IsocandelaEllipse& e) { return equal_circle(e.horizontal, e.vertical); };
  double low = 0, high = 2 * kPi * double(count) / std::max(last.horizontal, last.vertical);
  const double cutoff = cutoff_angle(cone);
  for (int i = 0; i < 60; ++i) {  // the step at which the cone ends, or the ellipses reach 180 degrees
    const double middle = std::midpoint(low, high);
    (circle_of(ellipse_at(middle)) < cutoff ? low : high) = middle;
  }
  std::vector<IsocandelaEllipse> lines;
  for (int i = 1; i <= kLines; ++i) {
    IsocandelaEllipse& line = lines.emplace_back(ellipse_at(low * i / kLines));
    line.intensity = cone_at(cone, std::cos(circle_of(line)));
  }
  return lines;
}

/// Flux of a cookie whose peak is 1: its texels times their solid angles.
double flux_of(const Cookie& cookie) {
  const auto edge = [&cookie](int i) { return 2 * i / double(cookie.size) - 1; };
  const auto corner = [](double x, double y) { return std::atan2(x * y, std::sqrt(x * x + y * y + 1)); };
  double flux = 0;
  std::size_t texel = 0;
  for (int line = 0; line < 6 * cookie.size; ++line) {
    const double top = edge(line % cookie.size), bottom = edge(line % cookie.size + 1);
    for (int column = 0; column < cookie.size; ++column) {
      const double left = edge(column), right = edge(column + 1);
      flux += double(cookie.texels[texel++]) *
              (corner(right, bottom) - corner(left, bottom) - corner(right, top) + corner(left, top));
    }
  }
  return flux;
}

/// Makes the cone's error of flux one of the whole luminaire.
void compare_with_luminaire(const LightTarget& target, ConeProfileFit& fit) {
  const double flux = peak_of(target.cone->samples) * flux_within(fit.cone, std::numbers::pi);
  fit.flux_error = flux / luminous_flux(target.luminaire->distribution) - 1;
}

/// Sets the radius that is stated, or the opening's or the default as far as the light's law can have it. A falloff
/// table states how bright the light is near the lamp: without a stated radius it stays as it is.
void set_source_radius(Light& light, const LightTarget& target) {
  const auto& [constant, linear, quadratic] = light.attenuation;
  if (target.source_radius) {
    light.source_radius = *target.source_radius;
    if (const auto error = find_error(light)) {
      throw InputError(
          target.source_radius_location, "source_radius_m", shown_number(error->value),
          fmt::format("{}; C is {} and Q is {} /m^2", error->rule, shown_number(constant), shown_number(quadratic)));
    }
    return;
  }
  if (quadratic == 0 || !target.range->samples.empty()) return;
  light.source_radius = std::min(unstated_source_radius(target), std::sqrt(constant / quadratic));
  if (find_error(light)) light.source_radius = 0;
}

/// What is known of the light as it is written.
void set_candela(LightFit& fit) {
  const LightTarget& target = fit.target;
  fit.illuminance_error = largest_error(target.illuminance, [&fit](double range) {
    return illuminance_at(fit.light, range, fit.cookie ? 0 : fit.peak_angle);
  });
  const double peak = luminance(candela(fit.light));
  if (!std::isfinite(peak)) return;
  fit.peak = peak;
  fit.flux = peak * (fit.cookie ? flux_of(*fit.cookie) : flux_within(fit.light.cone, std::numbers::pi));
  const auto data = target.luminaire ? luminous_flux(target.luminaire->distribution) : target.flux;
  if (data) fit.flux_error = *fit.flux / *data - 1;
  if (!target.light_peak || fit.cookie) return;
  if (target.luminaire) {
    const double intensity = peak * cone_at(fit.light.cone, std::cos(fit.peak_angle));
    fit.peak_error = intensity / target.luminaire_peak.intensity - 1;
  } else if (fit.light.attenuation.linear == 0) {
    fit.peak_error = peak / *target.light_peak - 1;
  }
}

}  // namespace

LightFit fit_light(LightTarget target) {
  LightFit fit;
  fit.light.name = target.name;
  fit.light.color = target.size * target.color;
  fit.light.density_scale = target.density_scale;
  fit.light.flash = target.flash;
  fit.light.attenuation = {1, 0, 0};
  if (target.range) {
    fit.range = fit_attenuation(*target.range);
    fit.light.attenuation = fit.range->attenuation;
    fit.light.threshold = fit.range->threshold;
  }
  if (target.cone) {
    fit.cone = fit_cone(*target.cone);
    fit.light.cone = fit.cone->best().cone;
  }
  set_source_radius(fit.light, target);
  if (target.luminaire) {
    const double cosine = dot(target.luminaire_peak.direction, target.axis);
    fit.peak_angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    for (ConeProfileFit& profile : fit.cone->profiles) compare_with_luminaire(target, profile);
  }
  if (!target.ellipses.empty()) {
    const auto lines = stretched(fit.light.cone, target.ellipses);
    fit.elliptical_beam = elliptical_beam(lines);
    target.asymmetry = AxialBeam(*fit.elliptical_beam, kPhotometricAxis).asymmetry();
  }
  fit.target = std::move(target);
  if (fit.target.cookie_size > 0 && fit.beam()) {
    fit.cookie = bake_cookie(*fit.beam(), fit.target.cookie_size, fit.target.axis);
  }
  set_candela(fit);
  return fit;
}

double illuminance_at(const Light& light, double range, double angle) {
  const Light near = photometric(light);
  return kWhiteLux * luminance(near.color) * attenuation_at(near.attenuation, range) *
         cone_at(near.cone, std::cos(angle));
}

std::optional<IlluminanceError> largest_error(const std::vector<RangeSpec::Illuminance>& stated,
                                              const std::function<double(double range)>& lux) {
  std::optional<IlluminanceError> largest;
  for (const auto& [range, stated_lux] : stated) {
    const double error = lux(range) / stated_lux - 1;
    if (!largest || std::abs(error) > std::abs(largest->error)) largest = {range, error};
  }
  return largest;
}

double unstated_source_radius(const LightTarget& target) {
  return target.opening_radius > 0 ? target.opening_radius : kDefaultSourceRadius;
}

const IntensityDistribution* LightFit::beam() const {
  if (target.luminaire) return &target.luminaire->distribution;
  return elliptical_beam ? &*elliptical_beam : nullptr;
}

bool LightFit::is_proven() const {
  return (!range || range->status == AttenuationFitStatus::optimal) &&
         (!cone || cone->best().status == ConeFitStatus::optimal);
}

std::optional<double> LightFit::beam_error() const {
  if (!beam()) return std::nullopt;
  if (!cookie) {
    const std::vector<AxialSample> circles = AxialBeam(*beam(), target.axis).profile();
    const double mean = std::ranges::max_element(circles, {}, &AxialSample::mean)->mean;
    return beam_error_of([&](double angle) { return mean * cone_at(light.cone, std::cos(angle)); });
  }
  const double largest = find_peak(*beam()).intensity;
  return beam_error_of([&](double, const glm::dvec3& direction) { return largest * cookie_at(*cookie, direction); });
}

double LightFit::beam_error_of(const std::function<double(double angle)>& candela) const {
  return beam_error_of([&](double angle, const glm::dvec3&) { return candela(angle); });
}

double LightFit::beam_error_of(const std::function<double(double angle, const glm::dvec3& direction)>& candela) const {
  constexpr int kTurns = 72;
  const glm::dmat3 frame = luminaire_from_light(target.axis);
  const std::vector<AxialSample> circles = AxialBeam(*beam(), target.axis).profile();
  double square = 0, total = 0;
  for (std::size_t i = 1; i < circles.size(); ++i) {
    const double angle = std::midpoint(circles[i - 1].angle, circles[i].angle);
    const double area = std::cos(circles[i - 1].angle) - std::cos(circles[i].angle);
    for (int k = 0; k < kTurns; ++k) {
      const glm::dvec3 direction = direction_of(PhotometryType::c, 2 * std::numbers::pi * k / kTurns, angle);
      const double data = intensity_at(*beam(), frame * direction);
      const double error = candela(angle, direction) - data;
      square += area * error * error;
      total += area * data * data;
    }
  }
  return std::sqrt(square / total);
}

std::vector<std::string> active_constraints(const Cone& cone, const litfog::ConeTarget& target) {
  std::vector<std::string> active;
  if (target.half_angle) active.emplace_back("half angle given");
  for (const ConeParameter& parameter : fitted_parameters(cone.profile)) {
    const double value = cone.*parameter.member;
    if (value != parameter.least && value != parameter.most) continue;
    active.push_back(fmt::format("{} = {}", parameter.name(), files::file_value(cone, parameter)));
  }
  return active;
}

const char* name_of(AttenuationFitStatus status) {
  switch (status) {
    case AttenuationFitStatus::optimal:
      return "optimal";
    case AttenuationFitStatus::unproven:
      return "unproven";
    case AttenuationFitStatus::infeasible:
      break;
  }
  return "infeasible";
}

const char* name_of(ConeFitStatus status) { return status == ConeFitStatus::optimal ? "optimal" : "unproven"; }

}  // namespace litfog::fit
