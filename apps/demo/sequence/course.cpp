// SPDX-License-Identifier: Apache-2.0
#include "demo/sequence/course.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "command/number.h"
#include "drawing/scene_options.h"

namespace litfog::demo {
namespace {

/// Removes digits that come from rounding: 0.3 and 0 instead of 0.30000000000000004 and 3e-17.
///
/// size  of the larger end
double without_rounding_digits(double number, double size) {
  constexpr double kMaxExactPower = 1e22;                                  // power of ten
  const double parts = std::pow(10.0, 14 - std::floor(std::log10(size)));  // per unit: 15 digits of the larger end
  if (!(parts >= 1 && parts <= kMaxExactPower)) return number;
  return std::round(number * parts) / parts + 0.0;  // no -0
}

double mixed(double from, double to, double fraction, Steps steps) {
  if (fraction == 0) return from;
  if (fraction == 1) return to;
  if (steps == Steps::ratio) return from * std::pow(to / from, fraction);
  return without_rounding_digits(std::lerp(from, to, fraction), std::max(std::abs(from), std::abs(to)));
}

glm::dvec3 mixed(const glm::dvec3& from, const glm::dvec3& to, double fraction, Steps) {
  return {std::lerp(from.x, to.x, fraction), std::lerp(from.y, to.y, fraction), std::lerp(from.z, to.z, fraction)};
}

/// The two ends of FROM..TO and the number of frames of a ":N" after them.
struct Range {
  std::string from;
  std::string to;
  std::optional<int> frames;
};

std::optional<Range> parse_range(const std::string& option, const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == text.npos) return std::nullopt;
  const std::size_t colon = std::min(text.find(':', dots), text.size());
  Range range{text.substr(0, dots), text.substr(dots + 2, colon - dots - 2), {}};
  if (colon == text.size()) return range;
  range.frames = command::parse_integer(std::string_view(text).substr(colon + 1));
  if (!range.frames || *range.frames < 2 || *range.frames > kMaxFrames) {
    command::fail_option(option, text, fmt::format("must have from 2 to {} frames after ':'", kMaxFrames));
  }
  return range;
}

}  // namespace

template <typename Value>
std::optional<int> Course<Value>::frames() const {
  if (is_range) return range_frames;
  return is_constant() ? std::nullopt : std::optional(int(values.size()));
}

template <typename Value>
Value Course<Value>::at(int frame, int count) const {
  if (is_range) return mixed(values[0], values[1], double(frame) / (count - 1), steps);
  return is_constant() ? values[0] : values[std::size_t(frame)];
}

template struct Course<double>;
template struct Course<glm::dvec3>;

Course<double> parse_course(const std::string& option, const std::string& text, const command::NumberRule& rule,
                            Steps steps) {
  const auto parse = [&](std::string_view word) {
    const auto number = command::parse_number(word, rule);
    if (!number) command::fail_option(option, word, rule.text);
    return *number;
  };
  if (const auto range = parse_range(option, text)) {
    const double from = parse(range->from);
    const double to = parse(range->to);
    if (steps == Steps::ratio && !(from > 0 && to > 0 && std::isfinite(from) && std::isfinite(to))) {
      command::fail_option(option, text, "must begin and end at finite numbers > 0: its steps are ratios");
    }
    return {.values = {from, to}, .is_range = true, .range_frames = range->frames, .steps = steps};
  }
  Course<double> course{.values = {}, .steps = steps};
  for (const std::string_view part : command::split_at_commas(text)) course.values.push_back(parse(part));
  if (course.values.size() > std::size_t(kMaxFrames)) {
    command::fail_option(option, text, fmt::format("must be at most {} numbers", kMaxFrames));
  }
  return course;
}

Course<glm::dvec3> parse_point_course(const std::string& option, const std::string& text) {
  if (const auto range = parse_range(option, text)) {
    return {.values = {drawing::parse_point(option, range->from), drawing::parse_point(option, range->to)},
            .is_range = true,
            .range_frames = range->frames};
  }
  return {.values = {drawing::parse_point(option, text)}};
}

bool is_meant_as_course(const std::string& text) {
  const auto is_number = [](const std::string& word) { return command::parse_number(word).has_value(); };
  const std::size_t dots = text.find("..");
  const bool is_range = dots != text.npos;
  if (text.starts_with('[')) return is_range;
  if (is_range && is_number(text.substr(dots + 2, text.find(':', dots) - dots - 2))) return true;
  const std::size_t end = std::min(text.find(','), dots);
  return end != text.npos && is_number(text.substr(0, end));
}

}  // namespace litfog::demo
