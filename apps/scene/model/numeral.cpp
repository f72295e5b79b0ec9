// SPDX-License-Identifier: Apache-2.0
#include "scene/model/numeral.h"

#include <array>
#include <vector>

#include "scene/model/primitive.h"

namespace litfog::scene {
namespace {

constexpr float kWidth = 0.56f;
constexpr float kStroke = 0.15f;
constexpr float kPitch = 0.76f;

using Quad = std::array<glm::vec2, 4>;

constexpr Quad bar(float left, float bottom, float right, float top) {
  return {glm::vec2(left, bottom), glm::vec2(right, bottom), glm::vec2(right, top), glm::vec2(left, top)};
}

/// Strokes in a box from (0, 0) to (kWidth, 1), so cut that none covers another.
std::vector<Quad> strokes(int digit) {
  const float s = kStroke;
  const float w = kWidth;
  const float low = 0.5f - 0.5f * s;  // the middle stroke's edges
  const float high = 0.5f + 0.5f * s;
  const Quad top = bar(0, 1 - s, w, 1);
  const Quad middle = bar(0, low, w, high);
  const Quad bottom = bar(0, 0, w, s);
  const Quad left_up = bar(0, high, s, 1 - s);
  const Quad left_low = bar(0, s, s, low);
  const Quad right_up = bar(w - s, high, w, 1 - s);
  const Quad right_low = bar(w - s, s, w, low);
  switch (digit) {
    case 0:
      return {top, bottom, bar(0, s, s, 1 - s), bar(w - s, s, w, 1 - s)};
    case 1:
      return {bar(0.5f * (w - s), 0, 0.5f * (w + s), 1),
              {glm::vec2(0.06f, 0.72f), glm::vec2(0.5f * (w - s), 0.84f), glm::vec2(0.5f * (w - s), 1),
               glm::vec2(0.06f, 0.86f)}};
    case 2:
      return {top, right_up, middle, left_low, bottom};
    case 3:
      return {top, right_up, middle, right_low, bottom};
    case 4:
      return {bar(0, high, s, 1), bar(0, low, w - s, high), bar(w - s, 0, w, 1)};
    case 5:
      return {top, left_up, middle, right_low, bottom};
    case 6:
      return {top, left_up, middle, left_low, right_low, bottom};
    case 7:
      return {
          top,
          {glm::vec2(0.1f, 0), glm::vec2(0.1f + 1.15f * s, 0), glm::vec2(w, 1 - s), glm::vec2(w - 1.15f * s, 1 - s)}};
    case 8:
      return {top, left_up, right_up, middle, left_low, right_low, bottom};
    default:
      return {top, left_up, right_up, middle, right_low, bottom};
  }
}

}  // namespace

void add_numeral(Mesh& mesh, int number, int digits, const glm::mat4& mesh_from_numeral) {
  const bool two = number >= 10 || digits == 2;
  Mesh flat;
  const auto add_digit = [&](int digit, float left) {
    for (const Quad& quad : strokes(digit)) {
      std::array<glm::vec3, 4> corners;
      for (std::size_t i = 0; i < 4; ++i) corners[i] = glm::vec3(quad[i] + glm::vec2(left, -0.5f), 0.0f);
      add_face(flat, corners);
    }
  };
  if (two) add_digit(number / 10, -0.5f * (kPitch + kWidth));
  add_digit(number % 10, two ? 0.5f * (kPitch - kWidth) : -0.5f * kWidth);
  append(mesh, flat, mesh_from_numeral);
}

}  // namespace litfog::scene
