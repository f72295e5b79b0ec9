// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>
#include <span>
#include <string>

#include "reference/degree.h"
#include "reference/random_airlight.h"

// A climbing search for the largest error of the airlight: random rays find what is common, a climb finds what is rare.

namespace litfog::test {

enum class LampShape { point, cosine, smoothstep, cookie };

/// What a climb keeps as it is.
struct ClimbKind {
  LampShape shape;
  bool is_directional;  ///< whether the fog scatters forward or backward, |g| up to 0.99 or droplets; isotropic else
  FogMode mode;
  LampLeg lamp_leg;
  bool is_layered = false;  ///< whether there is a layer, of exp fog
};

/// As cells of CSV: lamps, fog, k of the lamp's leg, largest |g|.
inline std::string to_string(const ClimbKind& kind) {
  constexpr std::array kShapes{"points", "cosine cones", "smoothstep cones", "cookies"};
  return std::string(kShapes[std::size_t(kind.shape)]) + "," + (kind.is_layered ? "layers" : name_of(kind.mode)) +
         (kind.lamp_leg == LampLeg::fogged ? ",1" : ",0") + (kind.is_directional ? ",0.99" : ",0");
}

/// The error that litfog/airlight.h states for every ray of a kind, of lamps that are no cookies.
inline double stated_error(const ClimbKind& kind) {
  if (kind.is_layered) {
    return kind.shape == LampShape::point && kind.is_directional ? kShapedAirlightMaxError : kLayeredAirlightMaxError;
  }
  if (!kind.is_directional || kind.mode == FogMode::exp2 || kind.lamp_leg == LampLeg::clear) return kAirlightMaxError;
  return kind.shape == LampShape::point ? kShapedAirlightMaxError : kShapedConeAirlightMaxError;
}

/// A point of the space that is searched: each number in [0, 1].
using ClimbPoint = std::array<double, 25>;

/// Cases over the ranges for which litfog/airlight.h states its errors: C of 0 to 5, L of 0 or 1e-4 to 3, Q of 0 or
/// 1e-6 to 3, thresholds of 1e-6 to 0.9, visibilities of 5 cm to 100 km, cones of 0.1 degree or more; lamp, closest
/// approach and end of the ray up to 30 fog scales apart. The eye is at the origin and looks along -z, or in layers
/// along any slope. A layer has the density of those visibilities, its edges are up to 30 fog scales away or within one
/// of the lamp's height, its transition band takes 0 to 10, and around it is clear air or 0.001 to 1 times its fog.
inline AirlightCase case_at(const ClimbPoint& point, const ClimbKind& kind) {
  const auto between = [](double part, double low, double high) { return low * std::pow(high / low, part); };
  /// The first part of [0, 1] stands for one value, the rest for a range of values.
  const auto one_or = [&](double x, double part, double value, double low, double high) {
    return x < part ? value : between((x - part) / (1 - part), low, high);
  };
  const auto [g, c, l, q, threshold, visibility, approach, offset, length, axial, turn, angle, sharpness, spread,
              second, weight, slope, roll, edge, other_edge, edges, band, haze, by_lamp, above_lamp] = point;
  AirlightCase made;
  made.spread = spread;
  made.lamp_leg = kind.lamp_leg;
  if (kind.is_directional) {
    made.atmosphere.phase = g < 0.7 ? Phase::henyey_greenstein(1.98 * g / 0.7 - 0.99)
                                    : Phase::droplets(between((g - 0.7) / 0.3, kSmallestDroplets, kLargestDroplets));
    if (g < 0.7 && second < 0.4) {
      made.atmosphere.phase.second.asymmetry = 1.98 * second / 0.4 - 0.99;
      made.atmosphere.phase.weight = weight;
    }
  }
  Light& light = made.light.light;
  light.attenuation.constant = c < 0.15 ? 0 : c < 0.55 ? (c - 0.15) / 0.4 : c < 0.75 ? 1 : between(4 * c - 3, 1, 5);
  light.attenuation.linear = one_or(l, 0.2, 0, 1e-4, 3);
  light.attenuation.quadratic = one_or(q, 0.2, 0, 1e-6, 3);
  if (light.attenuation == Attenuation{0, 0, 0}) light.attenuation.constant = 1;
  light.threshold = between(threshold, 1e-6, 0.9);
  made.atmosphere.fog = Fog::from_visibility(kind.mode, between(visibility, 0.05, 1e5));
  const double fog_scale = 1 / made.atmosphere.fog.density;
  made.light.position.x = -fog_scale * one_or(offset, 0.05, 0, 1e-5, 30);
  made.light.position.z = approach < 0.7 ? -fog_scale * one_or(approach / 0.7, 0.07, 0, 1e-4, 30)
                                         : fog_scale * between((approach - 0.7) / 0.3, 1e-4, 30);
  if (length > 0.4) made.ray.length = fog_scale * between((length - 0.4) / 0.6, 1e-3, 30);
  const double z = 2 * axial - 1, radius = std::sqrt(1 - z * z), around = 2 * std::numbers::pi * turn;
  made.light.direction = glm::normalize(glm::dvec3(radius * std::cos(around), radius * std::sin(around), z));
  const auto degrees_up_to = [&between](double largest, double part) {
    return part < 0.1   ? largest
           : part < 0.5 ? std::lerp(0.1, largest, (part - 0.1) / 0.4)
                        : between(2 * part - 1, 0.1, largest);
  };
  if (kind.shape == LampShape::cosine) {
    light.cone = Cone::cosine(degrees_up_to(90, angle) * kDegree, one_or(sharpness, 0.15, 0, 0.5, 2000));
  } else if (kind.shape == LampShape::smoothstep) {
    const double outer = degrees_up_to(180, angle) * kDegree;
    light.cone = Cone::smoothstep(0.98 * outer * sharpness, outer);
  }
  if (!kind.is_layered) return made;

  const double elevation = std::numbers::pi * (slope - 0.5), rolled = 2 * std::numbers::pi * roll;
  const glm::dvec3 right(std::cos(rolled), std::sin(rolled), 0);
  const glm::dvec3 ahead(0, std::sin(elevation), -std::cos(elevation));
  const glm::dmat3 world_from_drawn(glm::dvec3(right.x, right.y * std::cos(elevation), right.y * std::sin(elevation)),
                                    glm::dvec3(-right.y, right.x * std::cos(elevation), right.x * std::sin(elevation)),
                                    -ahead);
  made.ray.direction = glm::normalize(ahead);
  made.light.position = world_from_drawn * made.light.position;
  made.light.direction = glm::normalize(world_from_drawn * made.light.direction);
  /// A signed distance: the middle of [0, 1] is the smallest.
  const auto signed_between = [&](double x, double low, double high) {
    return (x < 0.5 ? -1 : 1) * fog_scale * between(std::abs(2 * x - 1), low, high);
  };
  double height = signed_between(edge, 1e-3, 30);
  if (by_lamp < 0.4) height = made.light.position.y + signed_between(above_lamp, 1e-4, 1);
  const double other_height = signed_between(other_edge, 1e-3, 30);
  FogLayer layer{.transition = fog_scale * one_or(band, 0.3, 0, 1e-3, 10),
                 .visibility = -std::log(kContrastMor) / made.atmosphere.fog.density};
  if (edges >= 0.3) layer.base = edges < 0.6 ? height : std::min(height, other_height);
  if (edges < 0.3 || edges >= 0.6) layer.top = edges < 0.3 ? height : std::max(height, other_height) + 1e-9 * fog_scale;
  made.atmosphere.profile = make_density_profile(std::span<const FogLayer>(&layer, 1));
  made.atmosphere.fog.density *= haze < 0.5 ? 0 : between(2 * haze - 1, 1e-3, 1);
  return made;
}

/// The largest error that a climb has found, and where.
struct ClimbResult {
  double error = 0;
  AirlightCase at = {};
};

/// Climbs from the worst of a few random points: each step moves some of the numbers by a random distance, and stays
/// there if the error has not fallen.
///
/// error_of  called with a case: its error, >= 0; NaN counts as infinite
template <typename ErrorOf>
ClimbResult climb_airlight(Random& random, const ClimbKind& kind, int steps, const ErrorOf& error_of) {
  constexpr int kFirstPoints = 12;
  constexpr double kMaxStride = 0.3, kSmallestStride = 1e-3;
  ClimbResult best;
  ClimbPoint best_point{};
  const auto takes = [&](const ClimbPoint& point) {
    const AirlightCase made = case_at(point, kind);
    if (compute_extent(made.light.light.attenuation, made.light.light.threshold) == 0) return false;
    double error = error_of(made);
    if (std::isnan(error)) error = kInfinity;
    if (error < best.error) return false;
    const bool is_better = error > best.error;
    best = {error, made};
    best_point = point;
    return is_better;
  };
  for (int i = 0; i < kFirstPoints; ++i) {
    ClimbPoint point;
    for (double& x : point) x = random.uniform(0, 1);
    takes(point);
  }
  double stride = 0.1;
  for (int i = 0; i < steps; ++i) {
    ClimbPoint point = best_point;
    const double size = stride * random.log_uniform(0.01, 1);
    const bool moves_one = random.chance(0.4);
    const int moved = random.below(int(point.size()));
    for (int k = 0; k < int(point.size()); ++k) {
      if (moves_one ? k != moved : !random.chance(0.4)) continue;
      double& x = point[std::size_t(k)];
      x = std::abs(x + size * (random.uniform(-1, 1) + random.uniform(-1, 1)));
      x = std::clamp(std::min(x, 2 - x), 0.0, 1.0);
    }
    stride = takes(point) ? std::min(1.5 * stride, kMaxStride) : std::max(0.99 * stride, kSmallestStride);
  }
  return best;
}

}  // namespace litfog::test
