// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "command/command.h"

namespace litfog::demo {

inline constexpr int kMaxFrames = 1000;  ///< in a sequence; its animation is assembled in memory

/// How a course goes from one end to the other.
enum class Steps {
  even,
  ratio,  ///< each frame's value is the same multiple of the one before
};

/// A number or a point in each frame of a sequence:
///
///     400                  always the same
///     400,200,50           one frame each
///     400..50              from one to the other, both included
///     400..50:24           the same in 24 frames
template <typename Value>
struct Course {
  std::vector<Value> values;  ///< not empty; a range has its two ends
  bool is_range = false;
  std::optional<int> range_frames = {};
  Steps steps = Steps::even;

  bool is_constant() const { return values.size() == 1; }
  /// The number of frames that it asks for, if any.
  std::optional<int> frames() const;
  /// frame  from 0
  /// count  number of frames, 2 or more; equal to frames(), if that has a value
  Value at(int frame, int count) const;
};

/// Parses an option's value. Throws the usage error of one that is no course, or breaks the rule.
///
/// rule  for each number; Steps::ratio also demands ends that are finite and above 0
Course<double> parse_course(const std::string& option, const std::string& text, const command::NumberRule& rule,
                            Steps steps = Steps::even);

/// Parses a course of points X,Y,Z: one, or the two ends of a range.
Course<glm::dvec3> parse_point_course(const std::string& option, const std::string& text);

/// Whether a JSON text or a word is meant as a list or range of numbers, correct or not.
bool is_meant_as_course(const std::string& text);

}  // namespace litfog::demo
