// SPDX-License-Identifier: Apache-2.0
#include "litfog/view_frustum.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <span>
#include <utility>

#include "require.h"

namespace litfog {
namespace {

constexpr double kHalfPi = std::numbers::pi / 2;
constexpr double kRounding = 1e-12;  // of coordinates, from the eye

/// The spherical sector that a light can light. Half angle at most 90 degrees: else it is not convex.
struct Sector {
  glm::dvec3 apex;
  glm::dvec3 axis;
  double range;
  double cos_half_angle;
  double sin_half_angle;

  /// One of its points that lie farthest along a direction: on the cap, on its rim, or the apex.
  glm::dvec3 farthest_along(const glm::dvec3& direction) const {
    const double along = glm::dot(direction, axis);
    const double length = glm::length(direction);
    if (along >= length * cos_half_angle) return apex + direction * (range / length);
    const glm::dvec3 rough = direction - axis * along;
    const glm::dvec3 across = rough - axis * glm::dot(rough, axis);  // near the axis `rough` is rounding errors alone
    const double width = glm::length(across);
    if (along * cos_half_angle + width * sin_half_angle <= 0) return apex;
    const glm::dvec3 outward = width > 0 ? across / width : glm::dvec3(0);
    return apex + range * (cos_half_angle * axis + sin_half_angle * outward);
  }

  /// Whether a point is deeper than a margin in the cone that a half angle over 90 degrees leaves dark.
  bool has_in_dark_cone(const glm::dvec3& point, double margin) const {
    const double along = glm::dot(point - apex, axis);
    const double width = glm::length(point - apex - axis * along);
    return width * cos_half_angle - along * sin_half_angle > margin;
  }
};

struct Point {
  glm::dvec3 position;
  glm::dvec3 farthest_along(const glm::dvec3&) const { return position; }
};

/// Up to four points whose convex hull holds the point of a body next to the origin that is known so far.
class Simplex {
 public:
  void add(const glm::dvec3& point) { points_[std::size_t(size_++)] = point; }

  /// The hull's point next to the origin; drops the points that it does not need.
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
  /// The point next to the origin of the plane (point, line, space) through a subset, and whether it lies between them.
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

  std::array<glm::dvec3, 4> points_;
  int size_ = 0;
};

/// Whether a polytope is within a margin of a convex body: never false where it is. Both from the eye.
template <typename Body>
bool is_within(std::span<const glm::dvec3, 8> corners, const Body& body, double margin, double rounding) {
  constexpr int kMostSteps = 64;  // the bodies then touch, but for rounding
  Simplex simplex;
  glm::dvec3 apart = corners[0] - body.farthest_along(corners[0]);  // a difference of their points
  for (int step = 0; step < kMostSteps; ++step) {
    const double distance = glm::length(apart);
    if (distance <= margin + rounding) return true;
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

}  // namespace

std::optional<ValueError> check(const View& view) {
  if (const auto error = check_position(view.eye, {"eye.x", "eye.y", "eye.z"})) return error;
  if (const auto error = check_direction(view.forward, "forward")) return error;
  if (const auto error = check_direction(view.up, "up")) return error;
  const double dot = glm::dot(view.forward, view.up);
  if (!(std::abs(dot) <= kDirectionTolerance))
    return ValueError{"up", dot, "must be orthogonal to forward within 1e-6"};
  constexpr const char* kRule = "must be at most 10 in magnitude";
  const std::pair<const char*, double> edges[] = {
      {"left", view.left}, {"right", view.right}, {"bottom", view.bottom}, {"top", view.top}};
  for (const auto& [name, tangent] : edges) {
    if (!(std::abs(tangent) <= kMaxViewTangent)) return ValueError{name, tangent, kRule};
  }
  if (!(view.left < view.right)) return ValueError{"right", view.right, "must be above left"};
  if (!(view.bottom < view.top)) return ValueError{"top", view.top, "must be above bottom"};
  if (!(view.nearest > 0)) return ValueError{"nearest", view.nearest, "must be > 0"};
  if (!(view.farthest > view.nearest && view.farthest <= kMaxPosition)) {
    return ValueError{"farthest", view.farthest, "must be above nearest and at most 16777216"};
  }
  return std::nullopt;
}

glm::dmat3 axes_of(const View& view) {
  const glm::dvec3 forward = glm::normalize(view.forward);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, view.up));
  return {right, glm::cross(right, forward), forward};
}

ViewFrustum::ViewFrustum(const View& view) : eye_(view.eye) {
  require(check(view));
  const glm::dmat3 axes = axes_of(view);
  auto corner = corners_.begin();
  for (const double depth : {view.nearest, view.farthest}) {
    for (const double x : {view.left, view.right}) {
      for (const double y : {view.bottom, view.top}) *corner++ = axes * glm::dvec3(x * depth, y * depth, depth);
    }
  }
  for (const glm::dvec3& each : corners_) size_ = std::max(size_, glm::length(each));
}

bool ViewFrustum::can_see(const glm::dvec3& center, double radius) const {
  require(check_position(center, {"center.x", "center.y", "center.z"}));
  if (!(radius >= 0)) require(ValueError{"radius", radius, "must be >= 0"});
  return is_within(corners_, Point{center - eye_}, radius, kRounding * (size_ + glm::length(center - eye_)));
}

bool ViewFrustum::can_see(const LightBounds& light) const {
  require(check(light));
  if (light.range == 0) return false;
  const glm::dvec3 apex = light.position - eye_;
  const double distance = glm::length(apex);
  const double rounding = kRounding * (size_ + distance);
  if (!is_within(corners_, Point{apex}, light.range, rounding)) return false;
  if (light.half_angle == std::numbers::pi) return true;
  const Sector sector{.apex = apex,
                      .axis = glm::normalize(light.direction),
                      .range = std::min(light.range, 2 * (size_ + distance)),  // beyond all corners
                      .cos_half_angle = std::cos(light.half_angle),
                      .sin_half_angle = std::sin(light.half_angle)};
  if (light.half_angle <= kHalfPi) return is_within(corners_, sector, 0, rounding);
  return !std::ranges::all_of(corners_,
                              [&](const glm::dvec3& corner) { return sector.has_in_dark_cone(corner, rounding); });
}

}  // namespace litfog
