// SPDX-License-Identifier: Apache-2.0
#include "fit/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "files/angle_deg.h"
#include "fit/verdict.h"
#include "litfog/color_temperature.h"
#include "text/shown_number.h"

namespace litfog::fit {
namespace {

std::string percent(double fraction, int digits) { return shown_rounded(100 * fraction, digits) + " %"; }
std::string shown_angle(double radians) { return shown_rounded(files::degrees(radians), 3); }

class Advice {
 public:
  template <typename... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    sentences_.push_back(fmt::format(format, std::forward<Arguments>(arguments)...));
  }
  std::vector<std::string> sentences() && { return std::move(sentences_); }

 private:
  std::vector<std::string> sentences_;
};

void advise_on_color(const glm::dvec3& color, Advice& advice) {
  constexpr double kLikelyBytes = 20;  // a blue of luminance 1 has 14
  const double brightest = std::max({color.r, color.g, color.b});
  if (brightest <= kLikelyBytes) return;
  advice.add("The color reaches {}, and 1 is the display's white: it is linear RGB, not sRGB of 8 bits.",
             shown_rounded(brightest, 6));
}

/// Candela and lux weigh the colours of light, which a light's colour multiplies.
void advise_on_luminance(const LightTarget& target, Advice& advice) {
  constexpr double kSame = 0.01;
  const double value = luminance(target.color);
  if (!target.light_peak || std::abs(value - 1) < kSame) return;
  advice.add("The color's luminance is {}: the light gives that fraction of its candela. Divide the color by it.",
             shown_rounded(value, 6));
}

void advise_on_source_radius(const LightFit& fit, Advice& advice) {
  const LightTarget& target = fit.target;
  const double radius = fit.light.source_radius, wanted = unstated_source_radius(target);
  if (target.source_radius || radius == 0) return;
  if (!target.luminaire || opening_radius(target.luminaire->opening) == 0) {
    advice.add(
        "The size of the lamp is not known: a source radius of {} m is taken. A spec's source_radius_m states it.",
        shown_rounded(radius, 3));
  } else if (radius < wanted) {
    advice.add("A source radius of {} m, of the luminous opening, is more than the attenuation allows: {} m is taken.",
               shown_rounded(wanted, 3), shown_rounded(radius, 3));
  }
}

void advise_on_range(const AttenuationTarget& target, const AttenuationFit& fit, Advice& advice) {
  const bool is_measured = target.samples.size() > 3;
  const double largest = std::abs(fit.largest_error);
  if (is_measured && !target.is_robust && fit.rms_error > 0.01 && largest > 3 * fit.rms_error) {
    advice.add("One sample is off by {} times the rms error: if it is an outlier, try --robust.",
               shown_rounded(largest / fit.rms_error, 3));
  } else if (fit.rms_error > 0.1) {
    advice.add("The range fit is off by {} (rms): no 1/(C + L r + Q r^2) falls as the table does.",
               percent(fit.rms_error, 2));
  }
  if (is_measured && !fit.covariance) {
    advice.add("The samples do not determine C, L and Q: other values fit as well.");
  }
}

void advise_on_edge(const LightTarget& target, const ConeProfileFit& best, Advice& advice) {
  const ConeTarget& cone = *target.cone;
  if (cone.samples.empty() && !(cone.beam_angle && cone.field_angle)) {
    advice.add(
        "One angle does not determine the beam's edge: the profile's is an assumption{}. Give the other angle, or "
        "samples.",
        target.flux ? ", and with it the peak that follows from the flux" : "");
  }
  const double edge = cutoff_level(best.cone);
  if (edge <= 0.01 || cone.half_angle) return;
  advice.add(
      "The cone ends at {} degrees with {} of the peak, an edge that is visible in fog: half_angle_deg moves "
      "it.",
      shown_angle(cutoff_angle(best.cone)), percent(edge, 2));
}

void advise_on_flux(const ConeFit& cone, Advice& advice) {
  const std::optional<double>& error = cone.best().flux_error;
  if (!error || std::abs(*error) <= 0.1) return;
  const auto nearest = std::ranges::min_element(cone.profiles, {}, [](const ConeProfileFit& each) {
    return std::abs(each.flux_error.value_or(std::numeric_limits<double>::infinity()));
  });
  const bool is_other_nearer = std::abs(*nearest->flux_error) < 0.5 * std::abs(*error);
  advice.add("The cone's flux is off by {:+.0f} %{}{}.", 100 * *error,
             *error < 0 ? ": it leaves out much of the beam's spill" : "",
             is_other_nearer ? fmt::format(". Of --profile {} it is off by {:+.0f} %",
                                           facts_of(nearest->cone.profile).name, 100 * *nearest->flux_error)
                             : "");
}

/// Where the mean over the turn of a nearly round beam is brightest, if its middle has less than half of that. Radians.
std::optional<double> ring_angle(const LightTarget& target) {
  if (!target.luminaire || target.asymmetry > kGood.asymmetry) return std::nullopt;
  const auto& samples = target.cone->samples;
  const auto brightest = std::ranges::max_element(samples, {}, &ConeSample::intensity);
  if (brightest == samples.end() || samples.front().intensity >= 0.5 * brightest->intensity) return std::nullopt;
  return brightest->angle;
}

/// The brightness of the second beam, as a fraction of the first, of a lamp that lights both ways.
std::optional<double> second_beam(const LightTarget& target) {
  constexpr double kLeast = 0.25;  // fraction of the first beam
  if (!target.luminaire || (target.axis != kPhotometricAxis && target.axis != -kPhotometricAxis)) return std::nullopt;
  double level = std::numeric_limits<double>::infinity(), second = 0;
  for (const ConeSample& sample : target.cone->samples) {
    if (sample.angle > std::numbers::pi / 2) second = std::max(second, sample.intensity);
    if (std::abs(sample.angle - std::numbers::pi / 2) < files::radians(30)) level = std::min(level, sample.intensity);
  }
  const double fraction = second / peak_of(target.cone->samples);
  return fraction >= kLeast && level < 0.5 * second ? std::optional(fraction) : std::nullopt;
}

void advise_on_shape(const LightFit& fit, Advice& advice) {
  if (const auto fraction = second_beam(fit.target)) {
    advice.add("A second beam, {:.0f} % as bright, goes the other way: --axis {} fits it, as a light of its own.",
               100 * *fraction, fit.target.axis == kPhotometricAxis ? "up" : "down");
  }
  if (fit.beam() && fit.target.asymmetry > kRoundBeam) {
    advice.add("The beam is not rotationally symmetric: any cone loses {:.0f} % of it (rms). --cookie keeps its shape.",
               100 * fit.target.asymmetry);
  }
  if (const auto angle = ring_angle(fit.target)) {
    advice.add(
        "The beam is a ring, brightest {} degrees off the axis: no cone is dark in its middle. --cookie keeps its "
        "shape.",
        shown_angle(*angle));
  } else if (fit.target.luminaire && fit.peak_angle > files::radians(5)) {
    advice.add("The beam's peak is {} degrees off the cone's axis: --axis peak moves the axis there.",
               shown_angle(fit.peak_angle));
  }
}

void advise_on_cone(const LightFit& fit, Advice& advice) {
  constexpr double kPlainMiss = 0.05;  // fraction of an angle
  const ConeProfileFit& best = fit.cone->best();
  advise_on_edge(fit.target, best, advice);
  if (best.field_angle_error && std::abs(*best.field_angle_error) > kPlainMiss) {
    advice.add("The cone misses the 10 % angle by {:+.1f} %.", 100 * *best.field_angle_error);
  }
  advise_on_flux(*fit.cone, advice);
  if (best.rms > 0.05) {
    advice.add("Neither profile follows the beam well (rms error {:.2g} of the peak).", best.rms);
  }
  advise_on_shape(fit, advice);
}

}  // namespace

std::vector<std::string> advice_on(const LightFit& fit) {
  Advice advice;
  advise_on_color(fit.target.color, advice);
  advise_on_luminance(fit.target, advice);
  if (fit.range) {
    advise_on_source_radius(fit, advice);
    advise_on_range(*fit.target.range, *fit.range, advice);
  } else {
    advice.add("No range is given: the light does not fall off. Give its extent or a falloff table.");
  }
  if (fit.cone) {
    advise_on_cone(fit, advice);
  } else {
    advice.add("No cone is given: a point light.");
  }
  return std::move(advice).sentences();
}

}  // namespace litfog::fit
