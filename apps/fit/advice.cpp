// SPDX-License-Identifier: Apache-2.0
#include "fit/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "files/angle_deg.h"
#include "fit/two_lights.h"
#include "litfog/color_temperature.h"
#include "photometry/darkness.h"
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

/// The fit whose author is advised, and fits by other choices.
struct Trials {
  const LightFit& fit;
  const FitChoices& choices;
  const std::function<LightTarget(const FitChoices&)>& read;

  template <typename Value>
  LightFit with(Value FitChoices::*choice, const Value& value) const {
    FitChoices other = choices;
    other.*choice = value;
    return fit_light(read(other));
  }
};

/// An error must become this much smaller for a change to be worth a sentence. A second light costs drawing time.
constexpr double kWorthwhile = 0.95;
constexpr double kWorthASecondLight = 0.7;

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

/// Ellipses, which standards draw, have no peak of their own.
void advise_on_contours(const LightTarget& target, Advice& advice) {
  if (!target.luminaire || !target.luminaire->is_isocandela || target.file != target.luminaire->file) return;
  if (target.luminaire->distribution.type != PhotometryType::c) return;  // a grid
  advice.add(
      "{} cd is what the inner ellipse states. A standard's are minima, and the lamp may be brighter: a spec's "
      "range.peak_cd states its own peak.",
      shown_number(target.luminaire_peak.intensity));
}

/// A file that ends where its beam is bright: the light's beam is cut there. A table of ellipses ends at its last
/// contour by design.
void advise_on_cut(const LightTarget& target, Advice& advice) {
  constexpr double kBeamLevel = 0.5, kBright = 0.1;  // of the peak, at which the report has angles
  if (!target.luminaire) return;
  const auto& [type, horizontal, vertical, intensity] = target.luminaire->distribution;
  if (target.luminaire->is_isocandela && type == PhotometryType::c) return;
  double brightest = 0;
  for (std::size_t h = 0; h < horizontal.size(); ++h) {
    for (std::size_t v = 0; v < vertical.size(); ++v) {
      const double candela = intensity[h * vertical.size() + v];
      const bool is_inside = h > 0 && h + 1 < horizontal.size() && v > 0 && v + 1 < vertical.size();
      if (is_inside || candela <= brightest) continue;
      for (const auto& [right, up] : {std::pair(-kDarkEdge, 0.), {kDarkEdge, 0.}, {0., -kDarkEdge}, {0., kDarkEdge}}) {
        const glm::dvec3 beyond = direction_of(type, horizontal[h] + right, vertical[v] + up);
        if (intensity_at(target.luminaire->distribution, beyond) == 0) brightest = candela;
      }
    }
  }
  const double level = brightest / target.luminaire_peak.intensity;
  if (level <= kBright) return;
  advice.add(
      "The file ends where the beam has {} of its peak, and the light is dark beyond: the angles at {}10 % may be "
      "those of the file's end. If the lamp is lit beyond, give its intensities there.",
      percent(level, 2), level > kBeamLevel ? "50 % and " : "");
}

void advise_on_source_radius(const LightFit& fit, Advice& advice) {
  const LightTarget& target = fit.target;
  const double radius = fit.light.source_radius, wanted = unstated_source_radius(target);
  if (target.source_radius || radius == 0) return;
  if (target.opening_radius == 0) {
    advice.add(
        "The size of the lamp is not known: a source radius of {} m is taken. A spec's source_radius_m states it.",
        shown_rounded(radius, 3));
  } else if (radius < wanted) {
    advice.add("A source radius of {} m, of the luminous opening, is more than the attenuation allows: {} m is taken.",
               shown_rounded(wanted, 3), shown_rounded(radius, 3));
  }
}

/// A table of illuminance that no peak has.
void advise_on_illuminance(const LightTarget& target, Advice& advice) {
  if (target.illuminance.empty()) return;
  const auto candela_of = [](const RangeSpec::Illuminance& row) { return row.lux * row.range * row.range; };
  const auto [least, most] = std::ranges::minmax(target.illuminance, {}, candela_of);
  if (candela_of(most) <= (1 + kGood.peak) * candela_of(least)) return;
  advice.add(
      "The illuminance does not fall by the square of the range, as a lamp's does in clear air: it is that of {} cd at "
      "{} m and of {} cd at {} m.",
      shown_number(candela_of(least)), shown_number(least.range), shown_number(candela_of(most)),
      shown_number(most.range));
}

/// The rms error of a falloff table without one of its samples.
double rms_without(std::size_t sample, const AttenuationTarget& target, const AttenuationFit& fit) {
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < target.samples.size(); ++i) {
    if (i == sample) continue;
    const double error = std::expm1(fit.residuals[i]);
    sum += target.samples[i].weight * error * error;
    weights += target.samples[i].weight;
  }
  return weights > 0 ? std::sqrt(sum / weights) : 0;
}

void advise_on_outlier(const Trials& trials, Advice& advice) {
  const AttenuationTarget& target = *trials.fit.target.range;
  const auto& residuals = trials.fit.range->residuals;
  const auto farthest = std::ranges::max_element(residuals, {}, [](double residual) { return std::abs(residual); });
  const auto sample = std::size_t(farthest - residuals.begin());
  const double rms = rms_without(sample, target, *trials.fit.range);
  const double robust_rms = rms_without(sample, target, *trials.with(&FitChoices::is_robust, true).range);
  if (robust_rms >= kWorthwhile * rms) return;
  advice.add(
      "The sample at {} m is off by {:+.0f} %: if it is an outlier, try --robust, by which the others are off by "
      "{} (rms) in place of {}.",
      shown_number(target.samples[sample].range), 100 * std::expm1(*farthest), percent(robust_rms, 2), percent(rms, 2));
}

void advise_on_range(const Trials& trials, Advice& advice) {
  const AttenuationTarget& target = *trials.fit.target.range;
  const AttenuationFit& fit = *trials.fit.range;
  const bool is_measured = target.samples.size() > 3;
  if (is_measured && !target.is_robust && fit.rms_error > 0.01 && std::abs(fit.largest_error) > 3 * fit.rms_error) {
    advise_on_outlier(trials, advice);
  } else if (fit.rms_error > 0.1) {
    advice.add("The range fit is off by {} (rms): no 1/(C + L r + Q r^2) falls as the table does.",
               percent(fit.rms_error, 2));
  }
  if (is_measured && !fit.covariance) {
    advice.add("The samples do not determine C, L and Q: other values fit as well.");
  }
}

/// A profile that ends dark, if it was fitted, too.
std::string dark_profile(const ConeFit& fit) {
  for (const ConeProfileFit& profile : fit.profiles) {
    if (cutoff_level(profile.cone) > 0.01) continue;
    const std::string rms = percent(profile.rms, 2), best = percent(fit.best().rms, 2);
    return fmt::format(
        ": --profile {} has none, and is {}", facts_of(profile.cone.profile).name,
        rms == best ? "no farther off" : fmt::format("off by {} of the peak (rms) in place of {}", rms, best));
  }
  return "";
}

void advise_on_edge(const LightFit& fit, Advice& advice) {
  const LightTarget& target = fit.target;
  const ConeProfileFit& best = fit.cone->best();
  const ConeTarget& cone = *target.cone;
  if (cone.samples.empty() && !(cone.beam_angle && cone.field_angle)) {
    advice.add(
        "One angle does not determine the beam's edge: the profile's is an assumption{}. Give the other angle, or "
        "samples.",
        target.flux ? ", and with it the peak that follows from the flux" : "");
  }
  const double edge = cutoff_level(best.cone);
  if (edge <= 0.01 || cone.half_angle) return;
  advice.add("The cone ends at {} degrees with {} of the peak, an edge that is visible in fog{}.",
             shown_angle(cutoff_angle(best.cone)), percent(edge, 2), dark_profile(*fit.cone));
}

/// Whether two lights are so much nearer to a beam than one that they are worth the time to draw them.
bool are_worthwhile(const TwoLights& two, const LightFit& one) {
  return two.beam_error < kWorthASecondLight * *one.beam_error() &&
         std::abs(two.flux_error) < kWorthASecondLight * std::abs(*one.flux_error);
}

void advise_against_spill(const LightFit& fit, const TwoLights& two, Advice& advice) {
  if (are_worthwhile(two, fit)) return;
  advice.add(
      "Two lights are hardly better than one: they are off by {} of the beam (rms) and {:+.1f} % of the flux, and one "
      "by {} and {:+.1f} %.",
      percent(two.beam_error, 3), 100 * two.flux_error, percent(*fit.beam_error(), 3), 100 * *fit.flux_error);
}

void advise_on_flux(const LightFit& fit, Advice& advice) {
  const ConeFit& cone = *fit.cone;
  const std::optional<double>& error = cone.best().flux_error;
  if (!error || std::abs(*error) <= 0.1) return;
  const auto nearest = std::ranges::min_element(cone.profiles, {}, [](const ConeProfileFit& each) {
    return std::abs(each.flux_error.value_or(std::numeric_limits<double>::infinity()));
  });
  const bool is_other_nearer = std::abs(*nearest->flux_error) < 0.5 * std::abs(*error);
  constexpr double kNearlyDark = -0.9;  // error of the flux, and of the intensity where the beam is brightest
  const bool is_dark = *error < kNearlyDark && fit.peak_error && *fit.peak_error < kNearlyDark;
  advice.add("{}{}.",
             is_dark
                 ? fmt::format("The light is nearly dark: its cone has {} of the beam's flux", percent(1 + *error, 2))
                 : fmt::format("The cone's flux is off by {:+.0f} %{}", 100 * *error,
                               *error < 0 ? ": it leaves out much of the beam's spill" : ""),
             is_other_nearer ? fmt::format(". With --profile {} the flux is off by {:+.0f} %",
                                           facts_of(nearest->cone.profile).name, 100 * *nearest->flux_error)
                             : "");
  const auto two = *error < 0 ? fit_two_lights(fit) : std::nullopt;
  if (!two || !are_worthwhile(*two, fit)) return;
  advice.add(
      "--spill writes a second light for the rest. Both have {} of the file's {} lm, and are off by {} of the beam "
      "(rms) in place of {}.",
      shown_rounded(*two->beam.flux, 4), shown_rounded(luminous_flux(fit.target.luminaire->distribution), 4),
      percent(two->beam_error, 2), percent(*fit.beam_error(), 2));
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

/// What a cookie would keep of a beam that is not round.
void advise_on_cookie(const Trials& trials, Advice& advice) {
  const LightFit& fit = trials.fit;
  const auto ring = ring_angle(fit.target);
  if (!fit.beam() || fit.cookie || (!ring && fit.target.asymmetry <= kRoundBeam)) return;
  const double error = *fit.beam_error(),
               left = *trials.with(&FitChoices::cookie_size, kUnstatedCookieSize).beam_error();
  if (left >= kWorthwhile * error) return;
  const std::string shape =
      ring ? fmt::format("The beam is a ring, brightest {} degrees off the axis", shown_angle(*ring))
           : std::string("The beam is not rotationally symmetric");
  advice.add("{}: --cookie keeps its shape, and is off by {} of it (rms).", shape, percent(left, 2));
}

void advise_on_axis(const Trials& trials, Advice& advice) {
  using Kind = AxisChoice::Kind;
  const LightFit& fit = trials.fit;
  if (const auto fraction = second_beam(fit.target); fraction && fit.flux) {
    const bool is_down = fit.target.axis == kPhotometricAxis;
    const LightFit other = trials.with(&FitChoices::axis, AxisChoice{is_down ? Kind::up : Kind::down});
    const double data = luminous_flux(fit.target.luminaire->distribution), both = *fit.flux + *other.flux;
    if (std::abs(both - data) < kWorthwhile * std::abs(*fit.flux - data)) {
      advice.add(
          "A second beam, {:.0f} % as bright, goes the other way: --axis {} fits it, as a light of its own. Both "
          "have {} of the file's {} lm.",
          100 * *fraction, is_down ? "up" : "down", shown_rounded(both, 4), shown_rounded(data, 4));
    }
  }
  if (!fit.target.luminaire || fit.cookie || fit.peak_angle <= files::radians(5) || ring_angle(fit.target)) return;
  const double error = *fit.beam_error();
  const double left = *trials.with(&FitChoices::axis, AxisChoice{Kind::peak}).beam_error();
  if (left >= kWorthwhile * error) return;
  advice.add(
      "The beam's peak is {} degrees off the cone's axis: --axis peak moves the axis there, and the cone is off by "
      "{} of the beam (rms) in place of {}.",
      shown_angle(fit.peak_angle), percent(left, 2), percent(error, 2));
}

}  // namespace

std::vector<std::string> advice_on(const LightFit& fit, const std::optional<TwoLights>& two, const FitChoices& choices,
                                   const std::function<LightTarget(const FitChoices&)>& read) {
  const Trials trials{fit, choices, read};
  Advice advice;
  advise_on_contours(fit.target, advice);
  advise_on_cut(fit.target, advice);
  advise_on_color(fit.target.color, advice);
  advise_on_luminance(fit.target, advice);
  advise_on_illuminance(fit.target, advice);
  if (fit.range) {
    advise_on_range(trials, advice);
  } else {
    advice.add("No range is given: the light does not fall off. Give its extent or a falloff table.");
  }
  if (two) {
    advise_against_spill(fit, *two, advice);
  } else if (fit.cone) {
    advise_on_axis(trials, advice);
    advise_on_cookie(trials, advice);
    if (!fit.cookie) {
      advise_on_flux(fit, advice);
      advise_on_edge(fit, advice);
    }
  } else {
    advice.add("No cone is given: a point light.");
  }
  if (fit.range) advise_on_source_radius(fit, advice);
  return std::move(advice).sentences();
}

}  // namespace litfog::fit
