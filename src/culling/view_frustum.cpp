// SPDX-License-Identifier: Apache-2.0
#include "litfog/view_frustum.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "lit_polytope.h"
#include "model/require.h"

namespace litfog {

std::optional<ValueError> find_error(const View& view) {
  if (const auto error = find_position_error(view.eye, {"eye.x", "eye.y", "eye.z"})) return error;
  if (const auto error = find_direction_error(view.forward, "forward")) return error;
  if (const auto error = find_direction_error(view.up, "up")) return error;
  const double dot = glm::dot(view.forward, view.up);
  if (!(std::abs(dot) <= kDirectionTolerance)) {
    return ValueError{"up", dot, "must be orthogonal to forward within 1e-6"};
  }
  constexpr const char* kRule = "must be at most 10 in magnitude";
  const std::pair<const char*, double> edges[] = {
      {"left", view.left}, {"right", view.right}, {"bottom", view.bottom}, {"top", view.top}};
  for (const auto& [name, tangent] : edges) {
    if (!is_within(tangent, -kMaxViewTangent, kMaxViewTangent)) return ValueError{name, tangent, kRule};
  }
  if (!(view.left < view.right)) return ValueError{"right", view.right, "must be above left"};
  if (!(view.bottom < view.top)) return ValueError{"top", view.top, "must be above bottom"};
  if (!(view.nearest > 0)) return ValueError{"nearest", view.nearest, "must be > 0"};
  if (!(view.farthest > view.nearest && is_within(view.farthest, 0, kMaxPosition))) {
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
  require(find_error(view));
  const glm::dmat3 axes = axes_of(view);
  auto corner = corners_.begin();
  for (const double depth : {view.nearest, view.farthest}) {
    for (const double x : {view.left, view.right}) {
      for (const double y : {view.bottom, view.top}) *corner++ = axes * glm::dvec3(x * depth, y * depth, depth);
    }
  }
  for (const glm::dvec3& each : corners_) size_ = std::max(size_, glm::length(each));
}

bool ViewFrustum::can_see(const glm::dvec3& centre, double radius) const {
  require(find_position_error(centre, {"centre.x", "centre.y", "centre.z"}));
  if (!(radius >= 0)) require(ValueError{"radius", radius, "must be >= 0"});
  const glm::dvec3 from_eye = centre - eye_;
  return is_within(corners_, corners_[0], Point{from_eye}, radius, kPolytopeRounding * (size_ + glm::length(from_eye)));
}

bool ViewFrustum::can_see(const LightBounds& light) const {
  require(find_error(light));
  return can_see(light.position, light.range) && can_light(light, light.position - eye_, corners_, corners_[0], size_);
}

}  // namespace litfog
