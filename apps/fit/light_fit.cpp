// SPDX-License-Identifier: Apache-2.0
#include "fit/light_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <numbers>
#include <numeric>

#include "files/angle_deg.h"
#include "fit/verdict.h"
#include "litfog/photometry/elliptical_beam.h"

namespace litfog::fit {

using litfog::AttenuationFitStatus;
using litfog::Cone;
using litfog::ConeFitStatus;
using litfog::ConeProfile;

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

/// Of a beam by its isocandela lines. A narrow beam is widened, which changes its asymmetry by less than a hundredth,
/// because asymmetry() steps in quarters of a degree.
double asymmetry_of(std::vector<IsocandelaEllipse> lines) {
  const double scale = std::max(1.0, files::radians(10) / std::max(lines.back().horizontal, lines.back().vertical));
  for (IsocandelaEllipse& line : lines) {
    line.horizontal *= scale;
    line.vertical *= scale;
  }
  return asymmetry(elliptical_beam(lines), kPhotometricAxis);
}

/// Where the mean over the turn of a nearly round beam is brightest, if its middle has less than half of that. Radians.
std::optional<double> ring_angle(const LightTarget& target) {
  if (!target.luminaire || target.asymmetry > kGood.asymmetry) return std::nullopt;
  const auto& samples = target.cone->samples;
  const auto brightest = std::ranges::max_element(samples, {}, &ConeSample::intensity);
  if (brightest == samples.end() || samples.front().intensity >= 0.5 * brightest->intensity) return std::nullopt;
  return brightest->angle;
}

}  // namespace

LightFit fit_light(LightTarget target, bool is_robust) {
  LightFit fit;
  fit.light.name = target.name;
  fit.light.color = target.color;
  fit.light.density_scale = target.density_scale;
  fit.light.attenuation = {1, 0, 0};
  if (target.range) {
    target.range->is_robust = is_robust;
    fit.range = fit_attenuation(*target.range);
    fit.light.attenuation = fit.range->attenuation;
    fit.light.threshold = fit.range->threshold;
  }
  if (target.cone) {
    fit.cone = fit_cone(*target.cone);
    fit.light.cone = fit.cone->best().cone;
  }
  if (target.luminaire) {
    const auto& distribution = target.luminaire->distribution;
    const double cosine = dot(find_peak(distribution).direction, target.axis);
    fit.peak_angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  }
  if (!target.ellipses.empty()) {
    const auto lines = stretched(fit.light.cone, target.ellipses);
    fit.elliptical_beam = elliptical_beam(lines);
    target.asymmetry = asymmetry_of(lines);
  }
  fit.target = std::move(target);
  return fit;
}

const IntensityDistribution* LightFit::beam() const {
  if (target.luminaire) return &target.luminaire->distribution;
  return elliptical_beam ? &*elliptical_beam : nullptr;
}

bool LightFit::is_proven() const {
  return (!range || range->status == AttenuationFitStatus::optimal) &&
         (!cone || cone->best().status == ConeFitStatus::optimal);
}

std::vector<std::string> LightFit::advice() const {
  std::vector<std::string> advice;
  const auto add = [&advice]<typename... Arguments>(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    advice.push_back(fmt::format(format, std::forward<Arguments>(arguments)...));
  };
  constexpr double kLikelyBytes = 10;  // no light is that bright on purpose
  if (const double brightest = std::max({light.color.r, light.color.g, light.color.b}); brightest > kLikelyBytes) {
    add("The color reaches {:.6g}, and 1 is the display's white: it is linear RGB, not sRGB of 8 bits.", brightest);
  }
  if (!range) add("No range is given: the light does not fall off. Give its extent or a falloff table.");
  if (range) {
    const auto& samples = target.range->samples;
    const bool is_measured = samples.size() > 3;
    if (is_measured && !target.range->is_robust && range->rms_error > 0.01 &&
        std::abs(range->largest_error) > 3 * range->rms_error) {
      add("One sample is off by {:.3g} times the rms error: if it is an outlier, try --robust.",
          std::abs(range->largest_error) / range->rms_error);
    } else if (range->rms_error > 0.1) {
      add("The range fit is off by {:.2g} % (rms): no 1/(C + L r + Q r^2) falls as the table does.",
          100 * range->rms_error);
    }
    if (is_measured && !range->covariance) {
      add("The samples do not determine C, L and Q: other values fit as well.");
    }
  }
  if (!cone) {
    add("No cone is given: a point light.");
    return advice;
  }
  const litfog::ConeProfileFit& best = cone->best();
  if (target.cone->samples.empty() && !(target.cone->beam_angle && target.cone->field_angle)) {
    add("One angle does not determine the beam's edge: the profile's is an assumption{}. Give the other angle, or "
        "samples.",
        target.flux ? ", and with it the peak that follows from the flux" : "");
  }
  if (best.cone.profile == ConeProfile::cosine && !target.cone->half_angle) {
    const double edge = std::pow(std::cos(best.cone.half_angle), best.cone.exponent);
    if (edge > 0.01) {
      add("The cone ends at {:.3g} degrees with {:.2g} % of the peak, an edge that is visible in fog: half_angle_deg "
          "moves it.",
          files::degrees(best.cone.half_angle), 100 * edge);
    }
  }
  constexpr double kPlainMiss = 0.05;  // of an angle
  if (best.field_angle_error && std::abs(*best.field_angle_error) > kPlainMiss) {
    add("The cone misses the 10 % angle by {:+.1f} %.", 100 * *best.field_angle_error);
  }
  if (best.flux_error && std::abs(*best.flux_error) > 0.1) {
    std::string sentence = fmt::format("The cone's flux is off by {:+.0f} %", 100 * *best.flux_error);
    if (*best.flux_error < 0) sentence += ": it leaves out much of the beam's spill";
    const auto& other = cone->profile == ConeProfile::cosine ? cone->smoothstep : cone->cosine;
    if (other && other->flux_error && std::abs(*other->flux_error) < 0.5 * std::abs(*best.flux_error)) {
      sentence += fmt::format(". Of --profile {} it is off by {:+.0f} %", name_of(other->cone.profile),
                              100 * *other->flux_error);
    }
    advice.push_back(sentence + ".");
  }
  if (best.rms > 0.05) add("Neither profile follows the beam well (rms error {:.2g} of the peak).", best.rms);
  if (beam() && target.asymmetry > kRoundBeam) {
    add("The beam is not rotationally symmetric: any cone loses {:.0f} % of it (rms). --cookie keeps its shape.",
        100 * target.asymmetry);
  }
  if (const auto angle = ring_angle(target)) {
    add("The beam is a ring, brightest {:.3g} degrees off the axis: no cone is dark in its middle. --cookie keeps its "
        "shape.",
        files::degrees(*angle));
  } else if (target.luminaire && peak_angle > files::radians(5)) {
    add("The beam's peak is {:.3g} degrees off the cone's axis: --axis peak moves the axis there.",
        files::degrees(peak_angle));
  }
  return advice;
}

std::vector<std::string> active_constraints(const Cone& cone, const litfog::ConeTarget& target) {
  std::vector<std::string> active;
  if (target.half_angle) active.emplace_back("half angle given");
  if (cone.profile == ConeProfile::cosine && cone.exponent == 0) active.emplace_back("exponent = 0");
  if (cone.profile == ConeProfile::smoothstep && cone.inner == 0) active.emplace_back("inner = 0");
  if (cone.profile == ConeProfile::smoothstep && cone.outer == std::numbers::pi) active.emplace_back("outer = 180");
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

const char* name_of(ConeProfile profile) { return profile == ConeProfile::cosine ? "cosine" : "smoothstep"; }

}  // namespace litfog::fit
