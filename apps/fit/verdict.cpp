// SPDX-License-Identifier: Apache-2.0
#include "fit/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "text/shown_number.h"

namespace litfog::fit {
namespace {

struct Finding {
  Grade grade;
  std::string text;
};

std::string percent(double fraction) { return shown_rounded(100 * fraction, 3) + " %"; }
std::string change(double fraction) { return shown_change(100 * fraction, 3) + " %"; }

class Findings {
 public:
  void add(Grade grade, std::string text) { findings_.push_back({grade, std::move(text)}); }

  /// Unless the error is rounding's noise: less than half of a hundredth of a percent.
  void add_error(double GradeLimits::*limit, double error, std::string text) {
    const double size = std::abs(error);
    constexpr double kNoise = 5e-5;
    if (size < kNoise) return;
    add(size <= kGood.*limit ? Grade::good : size <= kFair.*limit ? Grade::fair : Grade::poor, std::move(text));
  }

  /// The worst grade, and all that have it.
  Verdict verdict() const {
    Verdict verdict{Grade::good, ""};
    for (const Finding& finding : findings_) verdict.grade = std::max(verdict.grade, finding.grade);
    for (const Finding& finding : findings_) {
      if (finding.grade == verdict.grade) verdict.why += (verdict.why.empty() ? "" : "; ") + finding.text;
    }
    if (findings_.empty()) verdict.why = "what is stated is met";
    return verdict;
  }

 private:
  std::vector<Finding> findings_;
};

/// What holds an attenuation: "extent and constant", "extent, constant and samples".
std::string given_of(const AttenuationTarget& target) {
  std::vector<std::string> given;
  if (target.extent) given.emplace_back("extent");
  if (target.constant) given.emplace_back("constant");
  if (!target.samples.empty()) given.emplace_back("samples");
  const std::string last = given.back();
  given.pop_back();
  return given.empty() ? last : fmt::format("{} and {}", fmt::join(given, ", "), last);
}

void judge_range(Findings& findings, const AttenuationTarget& target, const AttenuationFit& fit) {
  if (fit.status == AttenuationFitStatus::infeasible) {
    findings.add(Grade::poor, fmt::format("no attenuation has the {} given", given_of(target)));
  } else if (fit.status == AttenuationFitStatus::unproven) {
    findings.add(Grade::fair, "a better attenuation is not ruled out");
  }
  if (target.samples.empty()) return;
  findings.add_error(&GradeLimits::range_rms, fit.rms_error,
                     fmt::format("attenuation off by {} (rms)", percent(fit.rms_error)));
  findings.add_error(&GradeLimits::range_largest, fit.largest_error,
                     fmt::format("a sample of the attenuation off by {}", change(fit.largest_error)));
}

/// Whether what lies between a cone's samples counts, too: theirs are many, or a photometric file's.
bool is_measured(const LightTarget& target) {
  constexpr std::size_t kFewSamples = 3;
  return target.luminaire || target.cone->samples.size() > kFewSamples;
}

void judge_cone(Findings& findings, const ConeTarget& target, const ConeProfileFit& fit, bool is_measured) {
  if (fit.status == ConeFitStatus::unproven) findings.add(Grade::fair, "a better cone is not ruled out");
  findings.add_error(&GradeLimits::cone_rms, fit.rms,
                     fmt::format("cone off by {} of the peak (rms)", percent(fit.rms)));
  const auto add = [&findings](double GradeLimits::*limit, const std::optional<double>& error, const char* what) {
    if (error) findings.add_error(limit, *error, fmt::format("{} off by {}", what, change(*error)));
  };
  if (is_measured) add(&GradeLimits::flux, fit.flux_error, "flux");
  if (is_measured || target.beam_angle) add(&GradeLimits::beam_angle, fit.beam_angle_error, "50 % angle");
  if (is_measured || target.field_angle) add(&GradeLimits::field_angle, fit.field_angle_error, "10 % angle");
}

/// What is stated of the peak, as a table of illuminance or otherwise.
void judge_peak(Findings& findings, const std::optional<IlluminanceError>& illuminance,
                const std::optional<double>& peak_error) {
  if (illuminance) {
    findings.add_error(
        &GradeLimits::peak, illuminance->error,
        fmt::format("illuminance at {} m off by {}", shown_number(illuminance->range), change(illuminance->error)));
  } else if (peak_error) {
    findings.add_error(&GradeLimits::peak, *peak_error,
                       fmt::format("intensity off by {} at the beam's peak", change(*peak_error)));
  }
}

}  // namespace

Verdict judge(const LightFit& fit) {
  Findings findings;
  if (fit.range) judge_range(findings, *fit.target.range, *fit.range);
  if (fit.cone) judge_cone(findings, *fit.target.cone, fit.cone->best(), is_measured(fit.target));
  if (fit.beam()) {
    const double asymmetry = fit.target.asymmetry;
    findings.add_error(&GradeLimits::asymmetry, asymmetry,
                       fmt::format("{} of the beam (rms) not symmetric", percent(asymmetry)));
  }
  judge_peak(findings, fit.illuminance_error, fit.peak_error);
  return findings.verdict();
}

Verdict judge(const TwoLights& lights) {
  Findings findings;
  for (const LightFit* light : {&lights.hot_spot, &lights.spill}) {
    if (light->cone->best().status == ConeFitStatus::unproven)
      findings.add(Grade::fair, "a better cone is not ruled out");
  }
  findings.add_error(&GradeLimits::flux, lights.flux_error, fmt::format("flux off by {}", change(lights.flux_error)));
  findings.add_error(&GradeLimits::asymmetry, lights.beam_error,
                     fmt::format("{} of the beam (rms) not in the two lights", percent(lights.beam_error)));
  judge_peak(findings, lights.illuminance_error, lights.peak_error);
  return findings.verdict();
}

const char* name_of(Grade grade) {
  switch (grade) {
    case Grade::good:
      return "good";
    case Grade::fair:
      return "fair";
    case Grade::poor:
      break;
  }
  return "poor";
}

std::string grade_table() {
  constexpr std::pair<const char*, double GradeLimits::*> kErrors[] = {
      {"attenuation, rms", &GradeLimits::range_rms},
      {"attenuation, largest", &GradeLimits::range_largest},
      {"cone, rms, of the peak", &GradeLimits::cone_rms},
      {"flux", &GradeLimits::flux},
      {"angle at 50 %", &GradeLimits::beam_angle},
      {"angle at 10 %", &GradeLimits::field_angle},
      {"asymmetry of the beam, error of two lights", &GradeLimits::asymmetry},
      {"intensity at the beam's peak, illuminance", &GradeLimits::peak}};
  std::string table = fmt::format("  {:<44}{:>6}  {:>6}, else it is poor\n", "", "good", "fair");
  for (const auto& [error, limit] : kErrors) {
    table += fmt::format("  {:<44}{:>4.0f} %  {:>4.0f} %\n", error, 100 * kGood.*limit, 100 * kFair.*limit);
  }
  return table;
}

}  // namespace litfog::fit
