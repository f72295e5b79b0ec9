// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include "litfog/fog.h"
#include "litfog/light.h"

namespace litfog::render {

/// Upper bounds of a light's airlight, in the largest component of its colour and the direction in which the fog
/// scatters most; both legs lead through the fog. s is the distance from the eye, r that from the light, L from the eye
/// to the light. litfog/shaders/airlight_bound.glsl bounds the fog's weight -f'(s) f(r) and the attenuation's integral.
class AirlightBound {
 public:
  static constexpr double kFarthestReach = 1e9;  ///< metres, for lights without an end: floats hold its square

  /// extent  of the light, metres
  /// fog     of the scene
  AirlightBound(const PlacedLight& light, double extent, const Fog& fog, double largest_phase, const glm::dvec3& eye);

  /// Range from the light beyond which rays pass it with at most a budget of airlight, 0 where all do, by solving
  /// litfog_largest_airlight() for the denominator. Metres.
  double reach(double budget) const;

  /// Distance R from the eye beyond which the rest of no ray has more than a budget of airlight. Metres, 0 where no ray
  /// has more, infinity where some always do.
  ///
  /// Proof. At s >= R, s + r is at least L and at least 2 R - L; s^2 / 2 + r^2 is at least L^2 / 3 and, for
  /// R >= 2 L / 3, at least R^2 / 2 + (R - L)^2. By these the weight is bounded.
  double end(double budget) const;

  /// What the light adds beyond its extent to a ray from a distance S from the eye on.
  ///
  /// Proof. With R the larger of the extent and S - L, r >= R. The weights -f'(s) of the eye's leg sum to at most f(S),
  /// so that the light adds at most a(R) f(R) f(S). Where -f'(s) f(r) is at most w, it also adds at most w pi / (Q R):
  /// a(r) <= 1 / (Q r^2), and the integral of 1 / r^2 over what is outside the ball of radius R is largest on the line
  /// that touches it.
  double beyond_extent(double distance) const;

  double density() const { return fog_.density; }  ///< of the fog as the light's class sees it, 1/m

  /// Metres from the light within which its airlight is flat: half of the falloff's width, or less in dense fog.
  double flat_range() const;

  /// k, where the airlight at a distance h from the light is about k / h. Metres.
  double k() const;

 private:
  double weight(double seen, double lit) const;
  double width() const;  // metres: the falloff's

  Attenuation attenuation_;
  double extent_;
  Fog fog_;
  double brightness_;
  double eye_range_;
  double weight_;  // of any ray
};

}  // namespace litfog::render
