// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <utility>

#include "litfog/light_bounds.h"

// Whether a light's sector meets a convex polytope of eight corners: a frustum, a box.

namespace litfog {

/// The corners of a convex polytope, in any order.
using Corners = std::array<glm::dvec3, 8>;

inline constexpr double kPolytopeRounding = 1e-12;  ///< relative rounding of coordinates

/// The spherical sector that a light can light, convex if the half angle is at most 90 degrees.
struct Sector {
  glm::dvec3 apex;
  glm::dvec3 axis;
  double range;
  double cos_half_angle;
  double sin_half_angle;

  /// A point of the sector farthest along a direction: on the cap, on its rim, or the apex.
  glm::dvec3 farthest_along(const glm::dvec3& direction) const {
    const double along = glm::dot(direction, axis);
    const double length = glm::length(direction);
    if (along >= length * cos_half_angle) return apex + direction * (range / length);
    const glm::dvec3 rough = direction - axis * along;
    const glm::dvec3 across = rough - axis * glm::dot(rough, axis);  // because near the axis `rough` is only rounding
    const double width = glm::length(across);
    if (along * cos_half_angle + width * sin_half_angle <= 0) return apex;
    const glm::dvec3 outward = width > 0 ? across / width : glm::dvec3(0);
    return apex + range * (cos_half_angle * axis + sin_half_angle * outward);
  }

  /// The sector's point nearest to a point, up to rounding. The half angle must be at most 90 degrees.
  glm::dvec3 nearest_to(const glm::dvec3& point) const {
    const glm::dvec3 offset = point - apex;
    const double along = glm::dot(offset, axis);
    const double distance = glm::length(offset);
    if (along >= distance * cos_half_angle) return distance <= range ? point : apex + offset * (range / distance);
    const glm::dvec3 across = offset - axis * along;
    const double width = glm::length(across);
    const glm::dvec3 edge = cos_half_angle * axis + (width > 0 ? across * (sin_half_angle / width) : glm::dvec3(0));
    return apex + std::clamp(glm::dot(offset, edge), 0.0, range) * edge;
  }

  /// Whether a point lies deeper than a margin inside the dark cone of a half angle over 90 degrees.
  bool has_in_dark_cone(const glm::dvec3& point, double margin) const {
    const double along = glm::dot(point - apex, axis);
    const double width = glm::length(point - apex - axis * along);
    return width * cos_half_angle - along * sin_half_angle > margin;
  }
};

struct Point {
  glm::dvec3 position;
  glm::dvec3 nearest_to(const glm::dvec3&) const { return position; }
  glm::dvec3 farthest_along(const glm::dvec3&) const { return position; }
};

/// Up to four points of a body, whose convex hull contains the known point nearest to the origin.
class Simplex {
 public:
  void add(const glm::dvec3& point) { points_[std::size_t(size_++)] = point; }

  /// The hull's point nearest to the origin. Drops the points on which it does not depend.
  glm::dvec3 reduce_to_nearest() {
    unsigned best = 0;
    glm::dvec3 nearest{0};
    double best_square = 0;
    for (unsigned subset = 1; subset < (1u << size_); ++subset) {
      const auto [is_inside, point] = nearest_of_plane(subset);
      const double square = glm::dot(point, point);
      if (is_inside && (best == 0 || square < best_square)) {
        best = subset;
        nearest = point;
        best_square = square;
      }
    }
    int kept = 0;
    for (int i = 0; i < size_; ++i) {
      if ((best >> i & 1) != 0) points_[std::size_t(kept++)] = points_[std::size_t(i)];
    }
    size_ = kept;
    return nearest;
  }

 private:
  /// The point nearest to the origin on the point, line, plane or space through a subset, and whether it lies between
  /// the subset's points.
  std::pair<bool, glm::dvec3> nearest_of_plane(unsigned subset) const {
    std::array<glm::dvec3, 4> p;
    int count = 0;
    for (int i = 0; i < size_; ++i) {
      if ((subset >> i & 1) != 0) p[std::size_t(count++)] = points_[std::size_t(i)];
    }
    const glm::dvec3 a = p[1] - p[0];
    const glm::dvec3 b = p[2] - p[0];
    switch (count) {
      case 1:
        return {true, p[0]};
      case 2: {
        const double t = -glm::dot(p[0], a) / glm::dot(a, a);
        return {t >= 0 && t <= 1, p[0] + t * a};
      }
      case 3: {
        const glm::dvec3 normal = glm::cross(a, b);
        const double square = glm::dot(normal, normal);
        const double s = -glm::dot(glm::cross(p[0], b), normal) / square;
        const double t = -glm::dot(glm::cross(a, p[0]), normal) / square;
        return {s >= 0 && t >= 0 && s + t <= 1, normal * (glm::dot(p[0], normal) / square)};
      }
      default: {
        const glm::dvec3 weights = glm::inverse(glm::dmat3(a, b, p[3] - p[0])) * -p[0];
        const bool is_inside = weights.x >= 0 && weights.y >= 0 && weights.z >= 0;
        return {is_inside && weights.x + weights.y + weights.z <= 1, glm::dvec3(0)};
      }
    }
  }

  std::array<glm::dvec3, 4> points_{};
  int size_ = 0;
};

/// Whether a polytope is within a margin of a convex body. Conservative: never false if it is. By the algorithm of
/// Gilbert, Johnson and Keerthi (1988): each step finds a proof of separation, a common point, or a smaller distance.
///
/// start     a point of the polytope; the nearer to the body, the fewer steps
/// rounding  metres: bodies farther apart than the margin by up to this may count as within it
template <typename Body>
bool is_within(const Corners& corners, const glm::dvec3& start, const Body& body, double margin, double rounding) {
  constexpr int kMaxSteps = 64;  // then the bodies touch, up to rounding
  Simplex simplex;
  glm::dvec3 apart = start - body.nearest_to(start);  // a difference of points of both bodies
  for (int step = 0; step < kMaxSteps; ++step) {
    const double distance = glm::length(apart);
    if (distance <= margin + rounding) break;
    // All differences lie beyond the plane across `apart` through this one.
    const glm::dvec3 corner =
        *std::ranges::min_element(corners, {}, [&](const glm::dvec3& each) { return glm::dot(each, apart); });
    const glm::dvec3 difference = corner - body.farthest_along(apart);
    if (glm::dot(difference, apart) > (margin + rounding) * distance) return false;
    simplex.add(difference);
    apart = simplex.reduce_to_nearest();
  }
  return true;
}

/// Whether a light that has passed find_error() can light anything in a polytope that is not all beyond its range.
/// Conservative: never false if it can. The corners are at most `size` from the origin. `apex` is the light's position
/// in the corners' space, which may be relative to the eye; `start` as in is_within().
inline bool can_light(const LightBounds& light, const glm::dvec3& apex, const Corners& corners, const glm::dvec3& start,
                      double size) {
  if (light.range == 0) return false;
  if (light.half_angle >= std::numbers::pi) return true;
  const double distance = glm::length(apex);
  const double rounding = kPolytopeRounding * (size + distance);
  const Sector sector{.apex = apex,
                      .axis = glm::normalize(light.direction),
                      .range = std::min(light.range, 2 * (size + distance)),  // beyond all corners
                      .cos_half_angle = std::cos(light.half_angle),
                      .sin_half_angle = std::sin(light.half_angle)};
  if (light.half_angle <= std::numbers::pi / 2) return is_within(corners, start, sector, 0, rounding);
  const auto is_dark = [&](const glm::dvec3& corner) { return sector.has_in_dark_cone(corner, rounding); };
  return !std::ranges::all_of(corners, is_dark);
}

}  // namespace litfog
