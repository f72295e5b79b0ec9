// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "litfog/light_bounds.h"
#include "litfog/view_frustum.h"
#include "reference/double_limits.h"
#include "reference/random_airlight.h"
#include "reference/random_light.h"

namespace litfog::test {

inline std::string to_string(const View& view, const LightBounds& light) {
  char text[1024];
  std::snprintf(text, sizeof text,
                "eye %.17g %.17g %.17g, forward %.17g %.17g %.17g, up %.17g %.17g %.17g, left %.17g, right %.17g, "
                "bottom %.17g, top %.17g, nearest %.17g, farthest %.17g; position %.17g %.17g %.17g, direction %.17g "
                "%.17g %.17g, range %.17g, half angle %.17g",
                view.eye.x, view.eye.y, view.eye.z, view.forward.x, view.forward.y, view.forward.z, view.up.x,
                view.up.y, view.up.z, view.left, view.right, view.bottom, view.top, view.nearest, view.farthest,
                light.position.x, light.position.y, light.position.z, light.direction.x, light.direction.y,
                light.direction.z, light.range, light.half_angle);
  return text;
}

/// Views near and far from the origin; some askew, flat, narrow or thin.
inline View draw_view(Random& random) {
  View view;
  const double far = random.chance(0.3) ? random.log_uniform(10, 1e6) : 0;
  view.eye = random.uniform(0, far) * draw_direction(random);
  view.forward = random.chance(0.2) ? glm::dvec3(0, 0, -1) : draw_direction(random);
  view.up = random.chance(0.2) && view.forward.y == 0 ? glm::dvec3(0, 1, 0) : draw_perpendicular(random, view.forward);
  const double width = random.chance(0.2) ? random.log_uniform(1e-4, 8) : random.uniform(0.3, 1.5);
  const double height = random.chance(0.2) ? random.log_uniform(1e-4, 8) : width * random.uniform(0.4, 1);
  const double aside = random.chance(0.3) ? random.uniform(-2, 2) : 0;
  view.left = aside - width;
  view.right = aside + width;
  const double above = random.chance(0.3) ? random.uniform(-2, 2) : 0;
  view.bottom = above - height;
  view.top = above + height;
  view.nearest = random.log_uniform(0.01, 10);
  view.farthest = view.nearest * (random.chance(0.1) ? random.uniform(1.001, 2) : random.log_uniform(20, 1e5));
  return view;
}

inline glm::dvec3 draw_point_in(Random& random, const View& view) {
  const double depth = random.chance(0.5) ? random.log_uniform(view.nearest, view.farthest)
                                          : random.uniform(view.nearest, view.farthest);
  return view.eye + axes_of(view) * (depth * glm::dvec3(random.uniform(view.left, view.right),
                                                        random.uniform(view.bottom, view.top), 1));
}

/// A light in, around or behind a view, of sizes from a cluster's to more than the view's.
inline LightBounds draw_bounds(Random& random, const View& view) {
  LightBounds light;
  const glm::dvec3 near = draw_point_in(random, view);
  const double depth = glm::distance(near, view.eye);
  light.position = random.chance(0.05)  ? view.eye
                   : random.chance(0.1) ? 2.0 * view.eye - near  // behind
                   : random.chance(0.3) ? near
                                        : near + depth * random.log_uniform(0.01, 2) * draw_direction(random);
  light.direction = random.chance(0.1) ? view.forward : draw_direction(random);
  light.range = random.chance(0.05) ? kInfinity : depth * random.log_uniform(1e-3, 3);
  light.half_angle = random.chance(0.3)   ? std::numbers::pi
                     : random.chance(0.1) ? std::numbers::pi / 2
                     : random.chance(0.1) ? random.uniform(std::numbers::pi / 2, std::numbers::pi)
                     : random.chance(0.1) ? random.log_uniform(1e-6, 0.1)
                                          : random.uniform(0.05, std::numbers::pi / 2);
  return light;
}

/// A point that a light can light, on its boundary as often as inside; within `most` where it has no end.
inline glm::dvec3 draw_point_in(Random& random, const LightBounds& light, double most) {
  const double range = std::min(light.range, most) * (random.chance(0.3) ? 1 : std::cbrt(random.uniform(0, 1)));
  const double lowest = std::cos(light.half_angle);
  const double cosine = random.chance(0.3) ? lowest : random.uniform(lowest, 1);
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return light.position + range * (cosine * light.direction + sine * draw_perpendicular(random, light.direction));
}

/// The corners of what a view shows, from its eye.
inline std::array<glm::dvec3, 8> corners_of(const View& view) {
  const glm::dmat3 axes = axes_of(view);
  std::array<glm::dvec3, 8> corners;
  std::size_t i = 0;
  for (const double depth : {view.nearest, view.farthest}) {
    for (const double x : {view.left, view.right}) {
      for (const double y : {view.bottom, view.top}) corners[i++] = axes * glm::dvec3(x * depth, y * depth, depth);
    }
  }
  return corners;
}

/// Whether a point is in what a view shows, by definition.
inline bool is_in(const View& view, const glm::dvec3& point) {
  const glm::dmat3 axes = axes_of(view);
  const glm::dvec3 offset = point - view.eye;
  const double depth = glm::dot(offset, axes[2]);
  const double x = glm::dot(offset, axes[0]);
  const double y = glm::dot(offset, axes[1]);
  return depth >= view.nearest && depth <= view.farthest && x >= view.left * depth && x <= view.right * depth &&
         y >= view.bottom * depth && y <= view.top * depth;
}

/// A proof that a polytope and a light have no point in common: the largest gap between two planes across one
/// direction, one before all of the polytope and one behind all of the light; < 0 where no such planes were found. By
/// trying directions, not by the library's method. Half angles up to 90 degrees, or balls.
class GapSearch {
 public:
  GapSearch(const View& view, const LightBounds& light) : light_(light), corners_(corners_of(view)) {
    const glm::dmat3 axes = axes_of(view);
    starts_ = {axes[2],
               -axes[2],
               glm::normalize(axes[0] - view.left * axes[2]),
               glm::normalize(view.right * axes[2] - axes[0]),
               glm::normalize(axes[1] - view.bottom * axes[2]),
               glm::normalize(view.top * axes[2] - axes[1])};
    start_from(light.position - view.eye);
  }

  GapSearch(const glm::dvec3& low, const glm::dvec3& high, const LightBounds& light) : light_(light) {
    for (std::size_t i = 0; i < 8; ++i) {
      const glm::dvec3 corner{i % 2 == 0 ? low.x : high.x, i / 2 % 2 == 0 ? low.y : high.y,
                              i / 4 == 0 ? low.z : high.z};
      corners_[i] = corner - light.position;
    }
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 normal{0};
      normal[axis] = 1;
      starts_.push_back(normal);
      starts_.push_back(-normal);
    }
    start_from(glm::dvec3(0));
  }

  double size() const { return size_; }

  double gap_along(const glm::dvec3& direction) const {
    double nearest = kInfinity;
    for (const glm::dvec3& corner : corners_) nearest = std::min(nearest, glm::dot(corner - apex_, direction));
    return nearest - support(direction);
  }

  /// Climbs from the best of many directions: the gap has one maximum where it is positive.
  double largest(Random& random) const {
    glm::dvec3 best = starts_.front();
    double gap = gap_along(best);
    const auto attempt = [&](const glm::dvec3& direction) {
      const double found = gap_along(direction);
      if (!(found > gap)) return false;
      gap = found;
      best = direction;
      return true;
    };
    for (const glm::dvec3& start : starts_) attempt(start);
    for (int i = 0; i < 100; ++i) attempt(draw_direction(random));
    double step = 0.5;
    for (int i = 0; i < 1500 && step > 1e-12; ++i) {
      const bool is_better = attempt(glm::normalize(best + step * draw_direction(random)));
      step *= is_better ? 1.5 : 0.93;
    }
    return gap;
  }

 private:
  void start_from(const glm::dvec3& apex) {
    apex_ = apex;
    glm::dvec3 centre{0};
    for (const glm::dvec3& corner : corners_) {
      size_ = std::max(size_, glm::length(corner));
      centre += corner / 8.0;
    }
    size_ += glm::length(apex_);
    for (const glm::dvec3& corner : corners_) starts_.push_back(glm::normalize(corner - apex_ + glm::dvec3(1e-30)));
    starts_.push_back(glm::normalize(centre - apex_ + glm::dvec3(1e-30)));
    starts_.push_back(-light_.direction);
  }

  double support(const glm::dvec3& direction) const {
    const double range = std::min(light_.range, 4 * size_);
    if (light_.half_angle == std::numbers::pi) return range;
    const double angle =
        std::atan2(glm::length(glm::cross(direction, light_.direction)), glm::dot(direction, light_.direction));
    return range * std::max(0.0, std::cos(std::max(0.0, angle - light_.half_angle)));
  }

  LightBounds light_;
  std::array<glm::dvec3, 8> corners_;
  glm::dvec3 apex_;
  double size_ = 0;
  std::vector<glm::dvec3> starts_;
};

}  // namespace litfog::test
