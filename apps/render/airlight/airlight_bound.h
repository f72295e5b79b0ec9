// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "litfog/atmosphere.h"
#include "litfog/light.h"
#include "litfog/multiple_scattering.h"

namespace litfog::render {

/// Upper bounds of a phase function over all angles of scattering from one on. Radians, [0, pi].
class ScatteringBound {
 public:
  explicit ScatteringBound(const Phase& phase);

  bool is_isotropic() const { return is_isotropic_; }
  double largest_from(double angle) const;
  /// Of the integral of largest_from() over the angles up to pi.
  double integral_from(double angle) const;

 private:
  static constexpr int kAngles = 64;

  Phase phase_;
  bool is_isotropic_;
  std::array<double, kAngles + 1> integrals_{};  // from each angle of a geometric series
};

/// A light as litfog/multiple_scattering.h knows it: what of it is scattered twice and more often.
struct PointGlow {
  const ScatteringTable* table = nullptr;  ///< none: nothing is
  double intensity = 0;                    ///< effective, m^2
  double soft_range = 0;                   ///< metres; it makes the glow fainter
};

/// Upper bounds of a light's airlight, in the largest component of its colour; both legs lead through the fog. s is the
/// distance from the eye, r that from the light, L from the eye to the light. litfog/shaders/airlight_bound.glsl bounds
/// the fog's weight -f'(s) f(r) and the attenuation's integral. In layers the weight's bound is the largest of
/// those of bands of height: fog of a band is at least as far away as the band, and hides on either leg at least what
/// Atmosphere::thinnest_fog_between() does. Along a ray the angle of scattering rises from the angle between the ray and
/// the vector to the light, so that a ray which passes the light at a distance h has the phase function of asin(h / L)
/// and of larger angles only, and beyond the light that of right angles and larger ones.
class AirlightBound {
 public:
  static constexpr double kLeastReach = 1e-3;    ///< metres: AirlightTiles see no light that reaches 1e-5
  static constexpr double kFarthestReach = 1e9;  ///< metres, for lights without an end: floats hold its square
  /// By how much farther off rays that look into layers from outside may pass the light and still count as near it.
  static constexpr double kMostFlattened = 4;

  /// extent  of the light, metres
  ///
  /// scattering  of the atmosphere's phase function; has to outlive this
  ///
  /// glow  its table has to outlive this
  AirlightBound(const PlacedLight& light, double extent, const Atmosphere& atmosphere,
                const ScatteringBound& scattering, const glm::dvec3& eye, const PointGlow& glow = {});

  /// Range from the light beyond which rays pass it with at most a budget of airlight from within its extent, 0 where
  /// all do. Metres.
  ///
  /// Proof. In isotropic fog litfog_largest_airlight() is solved for the denominator. Else a ray that passes at a
  /// distance h has at most that times the largest value of the phase function p from the angle asin(h / L) on, and at
  /// most w / (Q h) times the integral of p over all those angles: a(r) <= 1 / (Q r^2), and r^2 is h ds / dtheta.
  double reach(double budget) const;

  /// Distance R from the eye beyond which the rest of no ray has more than a budget of airlight from within the extent
  /// or of far_peak_reach(). Metres, 0 where no ray has more, infinity where
  /// some have more beyond kSkyDistance.
  ///
  /// Proof. At s >= R, r is at least R - L. By these the weight is bounded.
  double end(double budget) const;

  /// What the light adds beyond its extent to a ray from a distance S from the eye on, in isotropic fog.
  ///
  /// Proof. With R the larger of the extent and S - L, r >= R. The weights -f'(s) of the eye's leg sum to at most f(S)
  /// in the thinnest fog, and to at most f(S) in each band, so that the light adds at most a(R) f(R) f(S) of the
  /// thinnest, or the sum of those of the bands. Where -f'(s) f(r) is at most w, it also adds at most w pi / (Q R):
  /// a(r) <= 1 / (Q r^2), and the integral of 1 / r^2 over what is outside the ball of radius R is largest on the line
  /// that touches it.
  double beyond_extent(double distance) const;

  /// Range from the light beyond which rays pass it with at most a budget of what the peak of the phase function adds
  /// beyond the extent (litfog/shaders/far_airlight.glsl), 0 where all do. Metres.
  double far_peak_reach(double budget) const;

  /// What the light adds by being scattered twice and more often to a ray from a distance from the eye on, where angles
  /// below FarAirlightList::kPeakAngle count as that: it falls with depth and angle. In layers rays near the light count
  /// as in beside_peak() of shaders/airlight/higher_orders.glsl, and what they receive is taken as no more than endless
  /// fog of the layers' density sends from any place of the ray.
  double higher_orders(double distance) const;

  /// Range from the light beyond which rays pass it with at most a budget of the peak that higher_orders() leaves out
  /// (shaders/airlight/higher_orders.glsl), 0 where all do. Metres.
  double higher_orders_reach(double budget) const;

  double density() const { return largest_density_; }  ///< of the thickest fog as the light's class sees it, 1/m

  /// Metres from the light within which its airlight is flat: half of the falloff's width, or less in dense fog.
  double flat_range() const;

  /// k, where the airlight at a distance h from the light is about k / h, near a distance; of one that falls off by a
  /// higher power, the k of which k / h bends as much. Metres.
  double k(double distance) const;
  /// The same of the peak of higher orders.
  double higher_orders_k(double distance) const { return distance * glow_beside(distance); }

 private:
  double angle_at(double distance) const;  // smallest of scattering, for rays that pass the light at a distance
  double largest_phase_at(double distance) const { return scattering_->largest_from(angle_at(distance)); }
  double glow_at(double depth, double angle) const;
  /// The same of layers, at a range from the light: as of endless fog of any density up to the largest.
  double glow_in_layers(double range, double angle) const;
  /// What is scattered twice and more often to rays that pass the light at a distance. In layers it may come from near
  /// the light through clear air.
  double glow_beside(double distance) const;
  double most_at(double distance) const;  // airlight of rays that pass the light at a distance
  double reach_where_phase_is(double phase, double budget) const;
  double width() const;  // metres: the falloff's
  // The way from the eye or from the light to fog of a band of height.
  struct Leg {
    double density;  // at most the mean density of the fog on it, 1/m
    double nearest;  // metres
  };
  struct Band {
    double density;  // the largest of its fog
    Leg seen, lit;
  };
  /// All heights with fog: one band without layers, none without fog.
  std::span<const Band> bands() const { return std::span(bands_).first(band_count_); }
  struct Distances {
    double seen, lit;
  };
  /// The optical distances of litfog_largest_fog_weight(), where s >= seen, r >= lit and s + r >= L.
  Distances optical(const Band& band, double seen, double lit) const;
  double left(const Band& band, double seen, double lit) const;  // f(s) f(r), at most
  double largest_weight(double seen, double lit) const;

  Attenuation attenuation_;
  double extent_;
  FogMode mode_;
  bool is_layered_;
  static constexpr std::size_t kMaxBands = 5 * kMaxDensityKnots + 9;
  std::array<Band, kMaxBands> bands_;  // as the light's class sees them
  std::size_t band_count_ = 0;
  double largest_density_;
  double smallest_density_;
  const ScatteringBound* scattering_;
  PointGlow glow_;
  double brightness_;  // in isotropic fog
  double eye_range_;
  double near_;  // metres from the light: rays that pass it nearer have a peak of what is scattered twice and more often
};

}  // namespace litfog::render
