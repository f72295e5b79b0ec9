// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "litfog/light_bounds.h"
#include "litfog/value_error.h"

namespace litfog {

/// Largest tangent of the angle from forward to an edge of a view: 84.3 degrees, up to which floats separate clusters.
inline constexpr double kMaxViewTangent = 10;

/// The part of space that a perspective picture shows. World space, metres; the picture may be off centre (stereo,
/// tiles).
struct View {
  glm::dvec3 eye{0.0};                 ///< each coordinate at most kMaxPosition in magnitude
  glm::dvec3 forward{0.0, 0.0, -1.0};  ///< its length is 1 within kDirectionTolerance
  glm::dvec3 up{0.0, 1.0, 0.0};        ///< its length is 1, and it is orthogonal to forward, within kDirectionTolerance
  // Tangents of the angles at which the picture's edges lie, from forward to the right and up: [-kMaxViewTangent,
  // kMaxViewTangent], left < right, bottom < top.
  double left = -1;
  double right = 1;
  double bottom = -1;
  double top = 1;
  double nearest = 0.1;      ///< depth along forward, > 0
  double farthest = 10'000;  ///< (nearest, kMaxPosition]

  friend bool operator==(const View&, const View&) = default;
};

/// What is wrong with a view, or nothing. The value of a wrong forward or up is its length; if up is not orthogonal, it
/// is their dot product.
std::optional<ValueError> find_error(const View& view);

/// Columns right, up and forward, orthonormal to rounding. The view must pass find_error().
glm::dmat3 axes_of(const View& view);

/// The truncated pyramid that a view shows, for culling.
///
/// An answer of false is always right. An answer of true may be wrong in the cases that can_light() names for a box
/// (light_bounds.h)                                                                          (view_frustum_test.cpp).
class ViewFrustum {
 public:
  /// throws  std::invalid_argument naming field, value and rule
  explicit ViewFrustum(const View& view);

  /// Whether a sphere meets the frustum.
  ///
  /// radius  metres, >= 0; 0 is a point
  /// throws  std::invalid_argument naming field, value and rule
  bool can_see(const glm::dvec3& centre, double radius) const;

  /// Whether a light can light anything in the frustum.
  ///
  /// throws  std::invalid_argument naming field, value and rule
  bool can_see(const LightBounds& light) const;

 private:
  glm::dvec3 eye_;
  std::array<glm::dvec3, 8> corners_;  // relative to the eye
  double size_ = 0;                    // largest distance of corners_ from the eye
};

}  // namespace litfog
