// SPDX-License-Identifier: Apache-2.0
#include "litfog/fit/cone_fit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "fit/cone_point.h"
#include "fit/cone_search.h"
#include "fit/cosine_profile.h"
#include "fit/smoothstep_profile.h"
#include "model/float_limit.h"
#include "model/require.h"
#include "model/versine.h"

namespace litfog {
namespace {

using std::numbers::pi;

constexpr double kTolerance = 1e-3;  // fraction of the objective; the promised tolerance
constexpr double kEdgeCost = 4e-4;   // fraction of the objective, paid for a cut-off at the beam's end, not far out
constexpr double kExact = 1e-20;     // fraction of the fractions' own sum: ten digits of each
constexpr double kInvisible = 5e-4;  // fraction at which a cut-off does not show: 1.6 of 255 in sRGB

void fill_in_proof(const ConeOptimum& optimum, double exact, ConeProfileFit& fit) {
  const bool is_exact = optimum.best.objective <= exact;
  const bool is_proven = is_exact || optimum.lower_bound >= (1 - kTolerance) * fit.objective;
  fit.status = is_proven ? ConeFitStatus::optimal : ConeFitStatus::unproven;
  fit.lower_bound = std::min(optimum.lower_bound, fit.objective);
  fit.kkt_residual = is_exact ? 0 : optimum.best.kkt_residual;
  fit.iterations = optimum.iterations;
  fit.boxes = optimum.boxes;
}

std::size_t count_off_axis(const std::vector<ConePoint>& points) {
  return std::size_t(
      std::count_if(points.begin(), points.end(), [](const ConePoint& point) { return point.versine > 0; }));
}

ConeProfileFit fit_cosine(const std::vector<ConePoint>& points, const ConeTarget& target, double exact) {
  const CosineProfile profile(points, target.half_angle);
  const ConeOptimum optimum = ConeSearch(profile, exact).run();
  const double exponent = optimum.best.parameters[0];
  const auto range_of = [&points](std::size_t lit) {
    return std::array{lit > 0 ? points[lit - 1].angle : 0,
                      lit < points.size() ? std::min(points[lit].angle, pi / 2) : pi / 2};
  };
  double half_angle = angle_at_level(Cone::cosine(pi / 2, exponent), kInvisible);
  std::array<double, 2> range;
  if (target.half_angle) {
    half_angle = *target.half_angle;
    range = {half_angle, half_angle};
  } else {
    // Each additional lit sample of a faint spill lowers the objective, even if negligibly. So the first cut-off that
    // is good enough is taken, not the best.
    const std::size_t invisible = profile.lit_within(half_angle);
    const double limit = std::max(exact, (1 + kEdgeCost) * optimum.best.objective);
    const std::size_t lit = profile.first_cut(exponent, invisible, limit).value_or(optimum.best.lit);
    range = range_of(lit);
    if (lit != invisible) half_angle = (range[0] + range[1]) / 2;
  }
  ConeProfileFit fit = assess(Cone::cosine(half_angle, exponent), points, target);
  fill_in_proof(optimum, exact, fit);
  fit.cutoff_range = range;
  if (optimum.best.covariance && count_off_axis(points) > 1) {
    fit.covariance = {{{optimum.best.covariance->front(), 0}, {0, 0}}};
  }
  return fit;
}

ConeProfileFit fit_smoothstep(const std::vector<ConePoint>& points, const ConeTarget& target, double exact) {
  const SmoothstepProfile profile(points, target.half_angle);
  const ConeOptimum optimum = ConeSearch(profile, exact).run();
  bool is_identified = false;
  const auto [inner, outer] = profile.softest(optimum.best.parameters, exact, is_identified);
  const auto angle_of = [&points](double versine) {  // a sample's own angle, to the digit
    const auto same = std::ranges::find(points, versine, &ConePoint::versine);
    return same != points.end() ? same->angle : angle_of_versine(versine);
  };
  const Cone cone = Cone::smoothstep(angle_of(inner), target.half_angle ? *target.half_angle : angle_of(outer));
  ConeProfileFit fit = assess(cone, points, target);
  fill_in_proof(optimum, exact, fit);
  fit.cutoff_range = {cone.outer, cone.outer};
  const std::size_t count = target.half_angle ? 1 : 2;
  if (is_identified && optimum.best.covariance && count_off_axis(points) > count) {
    fit.covariance.emplace();
    for (std::size_t row = 0; row < count; ++row) {
      for (std::size_t column = 0; column < count; ++column) {
        const auto slope = [&](std::size_t i) { return std::sin(i == 0 ? cone.inner : cone.outer); };
        const double slopes = slope(row) * slope(column);
        if (slopes == 0) continue;  // at 0, a bound
        (*fit.covariance)[row][column] = (*optimum.best.covariance)[row * count + column] / slopes;
      }
    }
  }
  return fit;
}

/// The fit of a profile; null for a profile that is not fitted.
struct ConeFitter {
  ConeProfileFit (*fit)(const std::vector<ConePoint>& points, const ConeTarget& target, double exact) = nullptr;
  std::span<const ConeParameter> parameters = {};
};

ConeFitter fitter_of(ConeProfile profile) {
  const auto parameters = facts_of(profile).parameters;
  switch (profile) {
    case ConeProfile::none:
      break;
    case ConeProfile::cosine:
      return {fit_cosine, parameters.subspan(1)};  // without the half angle, which samples leave open
    case ConeProfile::smoothstep:
      return {fit_smoothstep, parameters};
  }
  return {};
}

std::vector<ConeProfileFacts> profiles_to_fit(const ConeTarget& target) {
  std::vector<ConeProfileFacts> profiles(kConeProfiles.begin(), kConeProfiles.end());
  std::erase_if(profiles, [&target](const ConeProfileFacts& each) {
    return !fitter_of(each.profile).fit || (target.profile && each.profile != *target.profile);
  });
  return profiles;
}

/// Moves values of a target that exceed a limit by a float's rounding to the limit.
ConeTarget at_limits(ConeTarget target) {
  for (const ConeProfileFacts& facts : profiles_to_fit(target)) {
    if (target.half_angle) target.half_angle = snapped(*target.half_angle, 0, facts.cutoff->most);
  }
  for (std::optional<double>* angle : {&target.beam_angle, &target.field_angle}) {
    if (*angle) *angle = snapped(**angle, 0, 2 * pi);
  }
  for (ConeSample& sample : target.samples) {
    sample.angle = snapped(sample.angle, 0, pi);
    sample.weight = snapped(sample.weight, 1e-100, 1e100);
  }
  return target;
}

}  // namespace

std::span<const ConeParameter> fitted_parameters(ConeProfile profile) { return fitter_of(profile).parameters; }

std::optional<TargetError> find_error(const ConeTarget& given) {
  const ConeTarget target = at_limits(given);
  const auto error = [](const char* field, double value, const char* rule, std::optional<std::size_t> sample = {}) {
    return TargetError{{field, value, rule}, sample};
  };
  const auto profiles = profiles_to_fit(target);
  if (profiles.empty()) return error("profile", double(*target.profile), "must be one that is fitted");
  for (const ConeProfileFacts& facts : profiles) {
    if (target.half_angle && !(*target.half_angle > 0 && *target.half_angle <= facts.cutoff->most)) {
      return error("half_angle", *target.half_angle, facts.cutoff->rule);
    }
  }
  if (target.beam_angle && !(*target.beam_angle > 0 && *target.beam_angle <= 2 * pi)) {
    return error("beam_angle", *target.beam_angle, "must be in (0, 2 pi]");
  }
  if (target.field_angle && !(*target.field_angle > 0 && *target.field_angle <= 2 * pi)) {
    return error("field_angle", *target.field_angle, "must be in (0, 2 pi]");
  }
  if (target.beam_angle && target.field_angle && !(*target.field_angle > *target.beam_angle)) {
    return error("field_angle", *target.field_angle, "must be larger than the beam angle");
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < target.samples.size(); ++i) {
    const auto& [angle, intensity, weight] = target.samples[i];
    if (!(angle >= 0 && angle <= pi)) return error("angle", angle, "must be in [0, pi]", i);
    if (i > 0 && !(angle > target.samples[i - 1].angle)) {
      return error("angle", angle, "must be larger than the one before", i);
    }
    if (!is_finite_and_not_negative(intensity)) return error("intensity", intensity, "must be finite and >= 0", i);
    if (!(weight == 0 || (weight >= 1e-100 && weight <= 1e100))) {
      return error("weight", weight, "must be 0 or in [1e-100, 1e100]", i);
    }
    if (weight > 0) ++count;
  }
  if (!target.beam_angle && !target.field_angle && count < 2) {
    return error("samples", double(count), "must be at least two with weight where no beam or field angle is given");
  }
  if (count > 0 && peak_of(target.samples) == 0) {
    return error("samples.intensity", 0, "must be > 0 for one of the samples with weight");
  }
  return std::nullopt;
}

std::vector<ConeSample> cone_samples(const std::vector<AxialSample>& profile) {
  std::vector<ConeSample> samples;
  for (const AxialSample& sample : profile) samples.push_back({sample.angle, sample.mean, 1});
  return samples;
}

double peak_of(const std::vector<ConeSample>& samples) {
  double peak = 0;
  for (const ConeSample& sample : samples) peak = std::max(peak, sample.weight > 0 ? sample.intensity : 0);
  return peak;
}

ConeFit fit_cone(const ConeTarget& given) {
  if (const auto error = find_error(given)) throw std::invalid_argument(to_string(*error));
  ConeTarget target = at_limits(given);
  std::erase_if(target.samples, [](const ConeSample& sample) { return sample.weight == 0; });
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<ConePoint> points = points_of(target);
  double exact = 0;
  for (const ConePoint& point : points) exact += kExact * point.loss(0);

  ConeFit fit;
  for (const ConeProfileFacts& facts : profiles_to_fit(target)) {
    const double objective = fit.profiles.emplace_back(fitter_of(facts.profile).fit(points, target, exact)).objective;
    if (fit.best().objective > exact && objective < fit.best().objective) fit.best_index = fit.profiles.size() - 1;
  }
  fit.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return fit;
}

}  // namespace litfog
