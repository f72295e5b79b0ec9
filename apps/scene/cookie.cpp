// SPDX-License-Identifier: Apache-2.0
#include "scene/cookie.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "scene/cube_face.h"
#include "scene/light_frame.h"

namespace litfog::scene {
namespace {

constexpr int kPatternSize = 256;  // a texel is a third of a degree

double smooth_edge(double cos_outer, double cos_inner, double x) {
  const double t = std::clamp((x - cos_outer) / (cos_inner - cos_outer), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Spots in rings around the axis, as the mirrors of a ball lie.
double disco(const glm::dvec3& direction) {
  constexpr int kRings = 15;
  constexpr double kRing = std::numbers::pi / kRings;
  const double from_axis = std::acos(std::clamp(-direction.z, -1.0, 1.0));
  const double ring = (std::min(std::floor(from_axis / kRing), kRings - 1.0) + 0.5) * kRing;
  const double spots = std::max(1.0, std::round(2 * std::numbers::pi * std::sin(ring) / kRing));
  const double turn = 2 * std::numbers::pi / spots;
  const double spot = std::round(std::atan2(direction.y, direction.x) / turn) * turn;
  const glm::dvec3 middle(std::sin(ring) * std::cos(spot), std::sin(ring) * std::sin(spot), -std::cos(ring));
  return smooth_edge(std::cos(0.36 * kRing), std::cos(0.26 * kRing), glm::dot(direction, middle));
}

/// Two beams to the sides.
double beacon(const glm::dvec3& direction) {
  return smooth_edge(std::cos(glm::radians(24.0)), std::cos(glm::radians(8.0)), std::abs(direction.x));
}

/// A cookie of the shares of its texels' unit directions.
template <typename ShareAt>
Cookie painted(int size, const ShareAt& share_at) {
  Cookie cookie{.size = size, .texels = {}};
  const auto middle = [size](int i) { return (2.0 * i + 1) / size - 1; };
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        cookie.texels.push_back(float(share_at(glm::normalize(cube_direction(face, middle(column), middle(row))))));
      }
    }
  }
  return cookie;
}

}  // namespace

double cookie_at(const Cookie& cookie, const glm::dvec3& direction) {
  const auto [face, u, v] = cube_place(direction);
  const double last = cookie.size - 1;
  const double x = std::clamp((u + 1) / 2 * cookie.size - 0.5, 0.0, last);
  const double y = std::clamp((v + 1) / 2 * cookie.size - 0.5, 0.0, last);
  const int left = int(x), top = int(y);
  const auto texel = [&](int column, int row) {
    const int i =
        (face * cookie.size + std::min(row, cookie.size - 1)) * cookie.size + std::min(column, cookie.size - 1);
    return double(cookie.texels[std::size_t(i)]);
  };
  return glm::mix(glm::mix(texel(left, top), texel(left + 1, top), x - left),
                  glm::mix(texel(left, top + 1), texel(left + 1, top + 1), x - left), y - top);
}

Cookie make_cookie(std::string_view pattern) {
  assert(std::ranges::find(kCookiePatterns, pattern) != std::end(kCookiePatterns));
  return painted(kPatternSize, pattern == "disco" ? disco : beacon);
}

Cookie resized(const Cookie& cookie, int size) {
  return painted(size, [&](const glm::dvec3& direction) { return cookie_at(cookie, direction); });
}

glm::dmat3 cookie_from_world(const glm::dvec3& direction, double roll) {
  const double c = std::cos(roll), s = std::sin(roll);
  return glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1) * basis_from_world(direction);
}

}  // namespace litfog::scene
