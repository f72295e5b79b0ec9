// SPDX-License-Identifier: Apache-2.0
#include "litfog/fit/attenuation_fit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "fit/attenuation_reach.h"
#include "fit/falloff.h"
#include "litfog/light.h"
#include "model/float_limit.h"
#include "text/shown_number.h"

namespace litfog {
namespace {

constexpr double kMinAttenuation = 1e-100;
constexpr double kMinRange = 1e-30;
constexpr double kMaxRange = 1e30;
constexpr double kMaxFactor = 1e100;

/// Samples out of reach by less than this are left to the fit, because figures are seldom given to more digits.
constexpr double kReading = 1e-3;

constexpr std::size_t kMaxDescribed = 3;  // samples out of reach: a sentence, not a table

/// Moves values of a target that exceed a limit by a float's rounding to the limit.
AttenuationTarget at_limits(AttenuationTarget target) {
  target.threshold = snapped(target.threshold, kMinAttenuation, std::numeric_limits<double>::max());
  if (target.extent) target.extent = snapped(*target.extent, kMinRange, kMaxRange);
  if (target.constant) target.constant = snapped(*target.constant, 0, kMaxFactor);
  for (AttenuationSample& sample : target.samples) {
    sample.range = snapped(sample.range, kMinRange, kMaxRange);
    sample.attenuation = snapped(sample.attenuation, kMinAttenuation, 1);
    sample.weight = snapped(sample.weight, 1 / kMaxFactor, kMaxFactor);
  }
  return target;
}

std::optional<ValueError> find_error(const AttenuationSample& sample, const AttenuationSample* previous) {
  const auto [range, attenuation, weight] = sample;
  if (range != 0 && !is_within(range, kMinRange, kMaxRange)) {
    return ValueError{"range", range, "must be 0, or in [1e-30, 1e30]"};
  }
  if (previous != nullptr && !(range > previous->range)) {
    return ValueError{"range", range, "must be greater than the range before it"};
  }
  if (!is_within(attenuation, kMinAttenuation, 1)) {
    return ValueError{"attenuation", attenuation, "must be in [1e-100, 1]"};
  }
  if (weight != 0 && !is_within(weight, 1 / kMaxFactor, kMaxFactor)) {
    return ValueError{"weight", weight, "must be 0, or in [1e-100, 1e100]"};
  }
  return std::nullopt;
}

/// The target in the search's coordinates: its unit of length is a power of two, so that ranges and coefficients keep
/// their digits.
struct Scaled {
  Falloff falloff = {};
  double unit = 1;  ///< metres
};

Scaled scale(const AttenuationTarget& target) {
  Scaled scaled;
  double log_sum = 0, largest_weight = 0;
  int count = 0;
  for (const auto& [range, attenuation, weight] : target.samples) {
    largest_weight = std::max(largest_weight, weight);
    if (weight == 0 || range == 0) continue;
    log_sum += std::log2(range);
    ++count;
  }
  const double log_unit = target.extent ? std::log2(*target.extent) : count > 0 ? log_sum / count : 0;
  scaled.unit = std::exp2(std::floor(log_unit));
  for (const auto& [range, attenuation, weight] : target.samples) {
    if (weight == 0) continue;
    scaled.falloff.samples.push_back(
        {range / scaled.unit, -std::log(static_cast<long double>(attenuation)), weight / largest_weight});
  }
  scaled.falloff.constant = target.constant;
  if (target.extent) {
    scaled.falloff.end = {*target.extent / scaled.unit, 1 / static_cast<long double>(target.threshold)};
  }
  return scaled;
}

/// Recomputes L or Q, whichever has the larger term at the extent, so that the extent is exact despite rounding.
void meet_extent(Attenuation& attenuation, double extent, double threshold) {
  const long double e = extent, level = threshold;
  const long double rest = std::fma(-level, attenuation.constant, 1.0L) / level;  // 1 / level - C would cancel
  const long double linear = attenuation.linear * e, quadratic = attenuation.quadratic * e * e;
  if (linear > quadratic) {
    attenuation.linear = double((rest - quadratic) / e);
  } else {
    attenuation.quadratic = double((rest - linear) / e / e);
  }
}

/// The attenuation of a family that has an extent.
Attenuation attenuation_of(AttenuationFamily family, double constant, double extent, double threshold) {
  const double rest = 1 / threshold - constant;
  const double linear_fraction = family == AttenuationFamily::linear ? 1 : family == AttenuationFamily::mixed ? 0.5 : 0;
  Attenuation attenuation{constant, linear_fraction * rest / extent, (1 - linear_fraction) * rest / extent / extent};
  meet_extent(attenuation, extent, threshold);
  return attenuation;
}

std::size_t free_count(const AttenuationTarget& target) {
  return std::size_t(3) - (target.constant ? 1 : 0) - (target.extent ? 1 : 0);
}

FalloffSearch minimise(const Falloff& falloff) { return search(falloff, descend(falloff, linear_start(falloff))); }

/// The scale of the residuals other than outliers: see AttenuationFit::loss_scale.
double loss_scale_of(const Falloff& falloff, const Coefficients& q, std::size_t free) {
  std::vector<double> amounts;
  for (const auto& sample : falloff.samples) amounts.push_back(std::abs(falloff.residual(q, sample)));
  std::sort(amounts.begin(), amounts.end());
  amounts.erase(amounts.begin(), amounts.begin() + std::ptrdiff_t(std::min(free, amounts.size() - 1)));
  const std::size_t half = amounts.size() / 2;
  const double median = amounts.size() % 2 == 1 ? amounts[half] : (amounts[half - 1] + amounts[half]) / 2;
  return std::max(1e-6, 1.345 * 1.4826 * median);
}

FalloffSearch minimise_robustly(Falloff& falloff, std::size_t free) {
  FalloffMinimum minimum = minimise(falloff).minimum;
  std::size_t iterations = minimum.iterations;
  const auto descend_with = [&](double scale) {
    falloff.loss = Loss(scale);
    minimum = descend(falloff, minimum.coefficients);
    iterations += minimum.iterations;
  };
  // From squares to magnitudes in steps of a half: with outliers all residuals of the least-squares fit are large.
  const double first = loss_scale_of(falloff, minimum.coefficients, free);
  for (int i = 1; i <= 7; ++i) descend_with(std::ldexp(first, -i));
  descend_with(loss_scale_of(falloff, minimum.coefficients, free));
  minimum.iterations = iterations;
  return search(falloff, minimum);
}

void fill_in_residuals(const AttenuationTarget& target, AttenuationFit& fit, const Loss& loss) {
  double squares = 0, weights = 0;
  for (const auto& [range, attenuation, weight] : target.samples) {
    const double residual = std::log(attenuation_at(fit.attenuation, range) / attenuation);
    fit.residuals.push_back(residual);
    if (weight == 0) continue;
    const double error = std::expm1(residual);
    fit.objective += weight * loss.value(residual);
    squares += weight * error * error;
    weights += weight;
    if (std::abs(error) > std::abs(fit.largest_error)) fit.largest_error = error;
  }
  fit.rms_error = weights > 0 ? std::sqrt(squares / weights) : 0;
}

/// Describes the samples that no attenuation with the target's extent and constant meets: those farthest out of reach
/// by increasing range, and the number of the others. A table's error against its own best attenuation is no
/// contradiction.
std::string describe_out_of_reach(const AttenuationTarget& target, const Scaled& scaled) {
  const auto distance = [&](const AttenuationSample& sample) {
    return sample.weight > 0 ? distance_from_reach(target, sample) : 0;
  };
  if (std::none_of(target.samples.begin(), target.samples.end(),
                   [&](const AttenuationSample& sample) { return distance(sample) > kReading; })) {
    return "";
  }
  Falloff free = scaled.falloff;
  free.constant.reset();
  free.end.reset();
  const FalloffMinimum own = free.samples.size() > 1 ? minimise(free).minimum : FalloffMinimum{};
  const double spare = std::max(1.0, double(free.samples.size()) - 3);
  const double scatter = std::sqrt(own.objective / free.weight_sum() * double(free.samples.size()) / spare);
  std::vector<std::size_t> beyond;
  for (std::size_t i = 0; i < target.samples.size(); ++i) {
    const AttenuationSample& sample = target.samples[i];
    const long double y = -std::log(static_cast<long double>(sample.attenuation));
    const double off = free.samples.size() > 1
                           ? std::abs(free.residual(own.coefficients, {sample.range / scaled.unit, y, sample.weight}))
                           : 0;
    if (distance(sample) > std::max(kReading, 3 * std::max(scatter, off))) beyond.push_back(i);
  }
  const std::size_t shown = std::min(beyond.size(), kMaxDescribed);
  std::ranges::partial_sort(beyond, beyond.begin() + std::ptrdiff_t(shown), std::greater(),
                            [&](std::size_t i) { return distance(target.samples[i]); });
  std::sort(beyond.begin(), beyond.begin() + std::ptrdiff_t(shown));
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    text += (i > 0 ? "; " : "") + describe_reach(target, target.samples[beyond[i]]);
  }
  if (shown < beyond.size()) {
    text += "; " + std::to_string(beyond.size() - shown) + " more of the " + std::to_string(target.samples.size()) +
            " samples cannot be reached";
  }
  return text;
}

std::string format_percent(double fraction) {
  return shown_rounded(std::abs(fraction) < 1e-11 ? 0 : 100 * fraction, 3) + " %";
}

void fit_samples(const AttenuationTarget& target, AttenuationFit& fit) {
  Scaled scaled = scale(target);
  Falloff& falloff = scaled.falloff;
  FalloffSearch found = target.is_robust ? minimise_robustly(falloff, free_count(target)) : minimise(falloff);
  double kkt = kkt_residual(falloff, found.minimum.coefficients);
  const auto covariance = covariance_of(falloff, found.minimum.coefficients);
  const bool is_one_of_many = falloff.samples.size() < free_count(target) || !covariance;
  if (is_one_of_many && !target.constant) {
    // If there is one, the attenuation with the constant 1, at which a lamp's near brightness is its brightness.
    Falloff normalized = falloff;
    normalized.constant = 1;
    const FalloffMinimum other = minimise(normalized).minimum;
    if (other.objective <= found.minimum.objective + falloff.negligible()) {
      found.minimum.coefficients = other.coefficients;
      kkt = kkt_residual(normalized, other.coefficients);
    }
  }
  const Coefficients& q = found.minimum.coefficients;
  fit.attenuation = {q[0], q[1] / scaled.unit, q[2] / scaled.unit / scaled.unit};
  if (q == Coefficients{}) {  // C = 0 given and no sample below 1: the clamp ends at the last sample
    fit.attenuation.linear = 1 / target.samples.back().range;  // GCOV_EXCL_LINE: no search of 20,000 ended there
  }
  if (target.extent) meet_extent(fit.attenuation, *target.extent, target.threshold);
  fit.loss_scale = falloff.loss.scale();
  fit.kkt_residual = kkt;
  fit.iterations = found.minimum.iterations;
  fit.boxes = found.boxes;
  if (!is_one_of_many) {
    fit.covariance = covariance;
    const std::array<double, 3> units{1, scaled.unit, scaled.unit * scaled.unit};
    for (std::size_t i = 0; i < 9; ++i) (*fit.covariance)[i] /= units[i / 3] * units[i % 3];
  }
  fill_in_residuals(target, fit, falloff.loss);
  if (fit.status == AttenuationFitStatus::infeasible) return;

  const std::string out_of_reach = describe_out_of_reach(target, scaled);
  if (!out_of_reach.empty()) {
    fit.status = AttenuationFitStatus::infeasible;
    fit.sentence = out_of_reach;
    return;
  }
  fit.status = found.is_proven ? AttenuationFitStatus::optimal : AttenuationFitStatus::unproven;
  fit.sentence = found.is_proven ? "no better attenuation exists"
                                 : "the best attenuation found; the search ended before it could rule out a better one";
  fit.sentence += ": off by " + format_percent(fit.rms_error) + " (rms), by " + format_percent(fit.largest_error) +
                  " at one sample";
}

}  // namespace

const char* name_of(AttenuationConstraint constraint) {
  switch (constraint) {
    case AttenuationConstraint::extent:
      return "extent";
    case AttenuationConstraint::constant_given:
      return "constant given";
    case AttenuationConstraint::constant_zero:
      return "constant = 0";
    case AttenuationConstraint::linear_zero:
      return "linear = 0";
    case AttenuationConstraint::quadratic_zero:
      return "quadratic = 0";
  }
  return "";  // GCOV_EXCL_LINE: all are named
}

std::optional<TargetError> find_error(const AttenuationTarget& given) {
  const AttenuationTarget target = at_limits(given);
  const auto error = [](const char* field, double value, const char* rule) {
    return TargetError{{field, value, rule}, std::nullopt};
  };
  if (!(target.threshold >= kMinAttenuation && target.threshold < 1)) {
    return error("threshold", target.threshold, "must be in [1e-100, 1)");
  }
  if (target.extent && !is_within(*target.extent, kMinRange, kMaxRange)) {
    return error("extent", *target.extent, "must be in [1e-30, 1e30]");
  }
  if (target.constant && !is_within(*target.constant, 0, kMaxFactor)) {
    return error("constant", *target.constant, "must be in [0, 1e100]");
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < target.samples.size(); ++i) {
    if (const auto found = find_error(target.samples[i], i > 0 ? &target.samples[i - 1] : nullptr)) {
      return TargetError{*found, i};
    }
    if (target.samples[i].weight > 0) ++count;
  }
  if (!target.extent && count < 2) {
    return error("samples", double(count), "must be two or more of weight > 0 where there is no extent");
  }
  if (!target.samples.empty() && count == 0) {
    return error("samples", 0, "must be one or more of weight > 0 where there are any");
  }
  return std::nullopt;
}

LightEnd compute_end(double candela, double lux, double threshold) {
  // (1 / threshold - 1) candela / (kWhiteLux size), in an order that overflows later.
  return {.size = lux / (kWhiteLux * threshold), .extent = std::sqrt(candela / lux) * std::sqrt(1 - threshold)};
}

AttenuationFit fit_attenuation(const AttenuationTarget& given) {
  const AttenuationTarget asked = at_limits(given);
  if (const auto error = find_error(asked)) throw std::invalid_argument(to_string(*error));
  const auto start = std::chrono::steady_clock::now();
  AttenuationFit fit;
  fit.threshold = asked.threshold;
  AttenuationTarget target = asked;
  const double largest_constant = kMaxConstantFraction / asked.threshold;
  if (asked.extent && asked.constant && *asked.constant > largest_constant) {
    fit.status = AttenuationFitStatus::infeasible;
    fit.sentence = describe_constant_reach(asked, largest_constant);
    target.constant = largest_constant;
  }
  if (target.samples.empty()) {
    fit.attenuation = attenuation_of(target.family, target.constant.value_or(1), *target.extent, target.threshold);
    if (fit.sentence.empty()) fit.sentence = "the extent is met";
  } else {
    fit_samples(target, fit);
  }
  if (target.extent) fit.active.push_back(AttenuationConstraint::extent);
  if (target.constant) fit.active.push_back(AttenuationConstraint::constant_given);
  if (!target.constant && fit.attenuation.constant == 0) fit.active.push_back(AttenuationConstraint::constant_zero);
  if (fit.attenuation.linear == 0) fit.active.push_back(AttenuationConstraint::linear_zero);
  if (fit.attenuation.quadratic == 0) fit.active.push_back(AttenuationConstraint::quadratic_zero);
  fit.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return fit;
}

}  // namespace litfog
