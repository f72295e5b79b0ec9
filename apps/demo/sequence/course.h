// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "command/command.h"

namespace litfog::demo {

inline constexpr int kMaxFrames = 1000;  ///< in a sequence, whose animation is assembled in memory

/// How a course goes from one end to the other.
enum class Steps {
  even,
  ratio,  ///< each frame's value is the same multiple of the one before
};

/// What a value, a number or a point, is in each frame of a sequence:
///
///     400                  always the same
///     400,200,50           one frame each
///     400..50              from one to the other, both included
///     400..50:24           the same in 24 frames
template <typename Value>
struct Course {
  std::vector<Value> values;  ///< not empty; of a range its two ends
  bool is_range = false;
  std::optional<int> range_frames = {};
  Steps steps = Steps::even;

  bool is_constant() const { return values.size() == 1; }
  /// How many frames it asks for, if it does.
  std::optional<int> frames() const;
  /// frame  from 0
  /// count  of frames, 2 or more: frames(), if it asks for some
  Value at(int frame, int count) const;
};

/// Reads an option's value. Throws the usage error of one that is no course, or breaks the rule.
///
/// rule  of each number; Steps::ratio demands ends that are finite and above 0, too
Course<double> parse_course(const std::string& option, const std::string& text, const command::NumberRule& rule,
                            Steps steps = Steps::even);

/// Parses a course of points X,Y,Z: one, or the two ends of a range.
Course<glm::dvec3> parse_point_course(const std::string& option, const std::string& text);

/// Whether a text of JSON, or a word, is meant as a list or range of numbers, right or wrong.
bool is_meant_as_course(const std::string& text);

}  // namespace litfog::demo
