// SPDX-License-Identifier: Apache-2.0
#include "fit/attenuation_reach.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "text/number_text.h"
#include "text/shown_number.h"

namespace litfog {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Interval {
  double low, high;
};

/// The denominators that can be reached at a range. With an extent the terms C, L E and Q E^2 add up to 1/t, and with
/// x = r / E the denominator is that sum with weights 1, x and x^2.
Interval reachable_denominators(const AttenuationTarget& target, double range) {
  const double constant = target.constant.value_or(0);
  if (!target.extent) return {constant, target.constant && range == 0 ? constant : kInfinity};
  const double top = 1 / target.threshold;
  const double x = range / *target.extent;
  if (!target.constant) return {top * std::min(1.0, x * x), top * std::max(1.0, x * x)};
  const double linear = constant + (top - constant) * x, quadratic = constant + (top - constant) * x * x;
  return {std::min(linear, quadratic), std::max(linear, quadratic)};
}

/// The ranges, as fractions of the extent, at which an attenuation can be reached; low > high if there are none.
/// A denominator between the constant and 1/t is reached at ranges from that of L alone to that of Q alone.
Interval reachable_ranges(const AttenuationTarget& target, double attenuation) {
  const double wanted = 1 / attenuation;
  const double top = 1 / target.threshold;
  if (!target.constant) {
    const double quadratic = std::sqrt(target.threshold / attenuation);
    return wanted < top ? Interval{0, quadratic} : Interval{quadratic, kInfinity};
  }
  const double linear = (wanted - *target.constant) / (top - *target.constant);
  if (!(linear >= 0)) return {1, 0};
  const double quadratic = std::sqrt(linear);
  if (attenuation == 1) return {0, quadratic};  // clamped to 1 up to there
  return {std::min(linear, quadratic), std::max(linear, quadratic)};
}

/// Rounds to few digits, or to as many as needed to stay between low and high.
std::string format_within(double value, double low, double high, int few = 4) {
  std::array<char, 32> text;
  for (int digits = few; digits < 17; ++digits) {
    // The neighbours of the rounded number on its decimal grid are tried too.
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - digits + 1);
    for (const double candidate : {value, value + unit, value - unit}) {
      const auto end =
          std::to_chars(text.data(), text.data() + text.size(), candidate, std::chars_format::general, digits).ptr;
      double rounded = 0;
      std::from_chars(text.data(), end, rounded);
      constexpr int kMaxShown = 9;  // shown_number() rounds beyond this
      if (!(rounded >= low && rounded <= high)) continue;
      return digits <= kMaxShown ? shown_number(rounded) : std::string(text.data(), end);
    }
  }
  return number_text(value);  // GCOV_EXCL_LINE: if low and high are neighbours
}

}  // namespace

double distance_from_reach(const AttenuationTarget& target, const AttenuationSample& sample) {
  const auto [low, high] = reachable_denominators(target, sample.range);
  const double y = -std::log(sample.attenuation);
  return std::max({0.0, std::log(std::max(1.0, low)) - y, y - std::log(std::max(1.0, high))});
}

std::string describe_constant_reach(const AttenuationTarget& target, double largest) {
  return "constant " + shown_number(*target.constant) + " cannot be reached with an extent of " +
         shown_number(*target.extent) + " m at threshold " + shown_number(target.threshold) + ": from 0 to " +
         format_within(largest, 0, largest, 7) + " can";
}

std::string describe_reach(const AttenuationTarget& target, const AttenuationSample& sample) {
  std::string text = "attenuation " + shown_number(sample.attenuation);
  const std::string at_range = " at " + shown_number(sample.range) + " m";
  const std::string with_constant = target.constant ? " constant " + shown_number(*target.constant) : "";
  if (target.constant && !(1 / sample.attenuation >= *target.constant)) {
    return text + " cannot be reached with" + with_constant + ": at most " +
           format_within(1 / *target.constant, 0, 1 / *target.constant) + " can";
  }
  if (!target.extent) {
    return text + at_range + " cannot be reached with" + with_constant + ": " +
           shown_number(std::min(1.0, 1 / *target.constant)) + " can";
  }
  text += at_range + " cannot be reached with an extent of " + shown_number(*target.extent) + " m" +
          (target.constant ? " and" + with_constant : "") + ": ";
  auto [low, high] = reachable_ranges(target, sample.attenuation);
  low *= *target.extent;
  high *= *target.extent;
  if (low == high) return text + "only " + shown_number(low) + " m can";
  const std::string from = low > 0 ? format_within(low, low, high) : "0";
  if (high == kInfinity) return text + "from " + from + " m on can";
  return text + "between " + from + " and " + format_within(high, low, high) + " m can";
}

}  // namespace litfog
