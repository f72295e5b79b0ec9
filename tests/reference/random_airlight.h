// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>
#include <string>

#include "litfog/airlight.h"
#include "litfog/density_profile.h"
#include "reference/degree.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"

namespace litfog::test {

inline constexpr std::array kLampLegs{LampLeg::clear, LampLeg::fogged};

/// A light, the air and a ray: the arguments of airlight().
struct AirlightCase {
  PlacedLight light;
  Atmosphere atmosphere;
  EyeRay ray;
  LampLeg lamp_leg = LampLeg::fogged;
  double spread = 0;  ///< [0, 1]: of a cone of rays around this one, where a climb takes one
};

inline std::string to_string(const AirlightCase& c) {
  const Light& light = c.light.light;
  const Cone& cone = light.cone;
  const glm::dvec3 to_light = c.light.position - c.ray.origin;
  const double approach = glm::dot(to_light, c.ray.direction);
  char text[768];
  std::snprintf(text, sizeof text,
                "; k = %d, lobes %.17g %.17g, %.17g %.17g by %.17g, cone %d: half angle %.17g, exponent %.17g, inner "
                "%.17g, outer %.17g; approach "
                "%.17g, offset %.17g, axis %.17g along the ray, %.17g to it, length %.17g",
                c.lamp_leg == LampLeg::fogged, c.atmosphere.phase.first.asymmetry, c.atmosphere.phase.first.alpha,
                c.atmosphere.phase.second.asymmetry, c.atmosphere.phase.second.alpha, c.atmosphere.phase.weight,
                int(cone.profile), cone.half_angle, cone.exponent, cone.inner, cone.outer, approach,
                glm::length(to_light - approach * c.ray.direction), glm::dot(c.light.direction, c.ray.direction),
                glm::dot(c.light.direction, approach * c.ray.direction - to_light), c.ray.length);
  std::string all = to_string(SolveCase{light.attenuation, c.atmosphere.fog, light.threshold}) + text;
  for (const DensityKnot& knot : c.atmosphere.profile.used()) {
    std::snprintf(text, sizeof text, "; %.17g at %.17g m", knot.density, knot.height);
    all += text;
  }
  if (c.atmosphere.profile.count == 0) return all;
  std::snprintf(text, sizeof text, "; heights of eye %.17g, lamp %.17g, rise %.17g", c.ray.origin.y, c.light.position.y,
                c.ray.direction.y);
  return all + text;
}

inline glm::dvec3 draw_perpendicular(Random& random, const glm::dvec3& direction) {
  for (;;) {
    const glm::dvec3 cross = glm::cross(direction, draw_direction(random));
    if (glm::length(cross) > 0.1) return glm::normalize(cross);
  }
}

/// Isotropic phase functions, those of droplets, and one or two lobes with asymmetries of -0.99 to 0.99.
inline Phase draw_phase(Random& random) {
  if (random.chance(0.25)) return {};
  if (random.chance(0.33)) return Phase::droplets(random.log_uniform(kSmallestDroplets, kLargestDroplets));
  const auto draw_lobe = [&random] {
    const double size = random.chance(0.5) ? random.uniform(0, 0.9) : 1 - random.log_uniform(0.01, 1);
    return PhaseLobe{random.chance(0.7) ? size : -size, random.chance(0.5) ? 0 : random.log_uniform(0.1, 30)};
  };
  if (random.chance(0.5)) return {.first = draw_lobe()};
  return {draw_lobe(), draw_lobe(), random.uniform(0, 1)};
}

/// Gives a case in exp fog one or two layers of about the fog's density near the heights of its eye and lamp, some with
/// a step for a transition band, and half of the time no fog outside of them.
inline void draw_layers(Random& random, AirlightCase& c) {
  const double eye = c.ray.origin.y, lamp = c.light.position.y;
  const double size = std::max(std::abs(lamp - eye), 0.05 * glm::distance(c.ray.origin, c.light.position));
  if (!(size > 1e-12 * std::max(std::abs(eye), std::abs(lamp)))) return;  // no layer lies between them
  const double height = std::min(eye, lamp) + size * random.uniform(-0.5, 1.5);
  const double band = random.chance(0.3) ? 0 : size * random.log_uniform(0.01, 1);
  const double visibility = -std::log(kContrastMor) / c.atmosphere.fog.density;
  std::array<FogLayer, 2> layers{};
  layers[0] = {.transition = band, .visibility = visibility};
  if (random.chance(0.67)) layers[0].base = height;
  if (layers[0].base != height) {
    layers[0].top = height;
  } else if (random.chance(0.5)) {
    layers[0].top = height + size * random.log_uniform(0.01, 1);
  }
  layers[1] = {
      .top = height - 0.2 * size, .transition = 0.1 * size, .visibility = visibility * random.log_uniform(0.1, 10)};
  c.atmosphere.profile = make_density_profile(std::span<const FogLayer>(layers).first(random.chance(0.7) ? 1 : 2));
  c.atmosphere.fog.density *= random.chance(0.5) ? 0 : random.log_uniform(0.01, 1);
}

/// Point lights as they occur with some of their kinds' corners, in fog from clear to a visibility of 5 cm, and rays
/// whose sizes are near those of the light, the fog or a scene: through the light, grazing it, from it, past it.
/// C is 0 to 5, L 0 or 1e-4 to 3, Q 0 or 1e-6 to 3, the threshold 1e-6 to 0.9, the visibility 5 cm to 100 km.
inline AirlightCase draw_airlight_case(Random& random, FogMode mode, LampLeg lamp_leg) {
  AirlightCase c;
  c.lamp_leg = lamp_leg;
  Light& light = c.light.light;
  Attenuation& attenuation = light.attenuation;
  do {
    attenuation.constant = random.chance(0.2)   ? 0
                           : random.chance(0.4) ? random.uniform(0, 1)
                           : random.chance(0.5) ? 1
                                                : random.log_uniform(1, 5);
    attenuation.linear = random.chance(0.25) ? 0 : random.log_uniform(1e-4, 3);
    attenuation.quadratic = random.chance(0.25) ? 0 : random.log_uniform(1e-6, 3);
    light.threshold = random.chance(0.5) ? 0.05 : random.log_uniform(1e-6, 0.9);
  } while (find_error(attenuation) || compute_extent(attenuation, light.threshold) == 0);
  c.atmosphere.fog =
      Fog::from_visibility(mode, random.chance(0.05) ? random.log_uniform(0.05, 3) : random.log_uniform(3, 1e5));

  const double extent = compute_extent(attenuation, light.threshold);
  const double knee = compute_knee(attenuation);
  const double sizes[]{extent, knee, 1 / c.atmosphere.fog.density, random.log_uniform(0.1, 2000)};
  double size = random.chance(0.5) ? extent : random.pick(sizes);
  if (!(size > 0 && size < 1e6)) size = 10;
  const double approach =
      random.chance(0.125) ? 0 : (random.chance(0.25) ? -1 : 1) * size * random.log_uniform(1e-3, 3);
  const double offset = random.chance(0.125) ? 0 : size * random.log_uniform(1e-4, 1.1);
  c.ray.direction = draw_direction(random);
  const glm::dvec3 away = draw_perpendicular(random, c.ray.direction);
  c.ray.origin = 100. * draw_direction(random);
  c.light.position = c.ray.origin + approach * c.ray.direction - offset * away;
  c.ray.length = random.chance(0.33)  ? kInfinity
                 : random.chance(0.5) ? std::abs(approach) * random.log_uniform(0.3, 3)
                                      : random.log_uniform(0.1, 3000);
  return c;
}

/// Lights of inverse-square falloff with knees of 0.1 to 10 m and practically without an end, in fog of 3 m to 100 km
/// of visibility, and rays that pass outside the knee.
inline AirlightCase draw_inverse_square_airlight_case(Random& random, FogMode mode, LampLeg lamp_leg) {
  AirlightCase c;
  c.lamp_leg = lamp_leg;
  const double knee = random.log_uniform(0.1, 10);
  c.light.light.attenuation = {0, 0, 1 / (knee * knee)};
  c.light.light.threshold = 1e-6;
  c.atmosphere.fog = Fog::from_visibility(mode, random.log_uniform(3, 1e5));
  const double offset = knee * random.log_uniform(1.001, 100);
  const double approach = (random.chance(0.25) ? -1 : 1) * knee * random.log_uniform(0.1, 300);
  c.ray.direction = draw_direction(random);
  c.light.position = approach * c.ray.direction + offset * draw_perpendicular(random, c.ray.direction);
  if (random.chance(0.5)) c.ray.length = knee * random.log_uniform(0.1, 1000);
  return c;
}

/// photometric() lamps of colour 1 with source radii of 2 cm to 2 m and up to 1e5 times as bright as white, and rays
/// that pass them within a hundredth to a hundred source radii or at sizes of a scene.
inline AirlightCase draw_photometric_airlight_case(Random& random, FogMode mode, LampLeg lamp_leg) {
  AirlightCase c;
  c.lamp_leg = lamp_leg;
  const double radius = random.log_uniform(0.02, 2);
  const double brightness = random.log_uniform(1, 1e5);
  Light light;
  light.source_radius = radius;
  light.attenuation.quadratic = 1 / (brightness * radius * radius);
  light.attenuation.linear = random.chance(0.7) ? 0 : random.log_uniform(1e-3, 10) / (brightness * radius);
  if (random.chance(0.3)) light.threshold = random.log_uniform(1e-4, 0.3);
  c.light.light = photometric(light);
  c.atmosphere.fog = Fog::from_visibility(mode, random.log_uniform(3, 1e5));
  const double extent = compute_extent(light.attenuation, light.threshold);
  const double sizes[]{extent, radius, 1 / c.atmosphere.fog.density, random.log_uniform(0.1, 2000)};
  const double size = random.pick(sizes);
  const double approach =
      random.chance(0.125) ? 0 : (random.chance(0.25) ? -1 : 1) * size * random.log_uniform(1e-3, 3);
  const double offset = random.chance(0.125) ? 0
                        : random.chance(0.5) ? radius * random.log_uniform(0.01, 100)
                                             : size * random.log_uniform(1e-4, 1.1);
  c.ray.direction = draw_direction(random);
  c.light.position = approach * c.ray.direction - offset * draw_perpendicular(random, c.ray.direction);
  c.ray.length = random.chance(0.33)  ? kInfinity
                 : random.chance(0.5) ? std::abs(approach) * random.log_uniform(0.3, 3)
                                      : random.log_uniform(0.1, 3000);
  return c;
}

/// Where a lamp lies as the eye sees it.
struct LampRegion {
  double nearest, farthest;          ///< fog scales (1 / density) from the eye
  double smallest_deg, largest_deg;  ///< between the ray and the vector to the lamp
};

/// Point lamps in a region whose denominators double within 0.001 to 10 fog scales, with C of 0 to 5, linear falloff,
/// quadratic or both, and thresholds of 1e-6 to 0.3 / C. Half of the rays end 0.3 to 3 times as far away as the lamp.
inline AirlightCase draw_region_airlight_case(Random& random, const LampRegion& region, FogMode mode,
                                              LampLeg lamp_leg) {
  constexpr double kScale = 10;  // metres
  AirlightCase c;
  c.lamp_leg = lamp_leg;
  c.atmosphere.fog = {mode, 1 / kScale};
  Light& light = c.light.light;
  const double constant = random.chance(0.15)  ? 0
                          : random.chance(0.4) ? random.uniform(0, 1)
                          : random.chance(0.5) ? 1
                                               : random.log_uniform(1, 5);
  const double level = std::max(1.0, constant);
  const double width = kScale * random.log_uniform(1e-3, 10);
  const double linear_part = random.chance(0.25) ? 0 : random.chance(0.33) ? 1 : random.uniform(0, 1);
  const double rise = 2 * level - constant;
  light.attenuation = {constant, linear_part * rise / width, (1 - linear_part) * rise / (width * width)};
  light.threshold = random.chance(0.5) ? 0.05 : random.log_uniform(1e-6, 0.3 / level);

  const double range = kScale * random.uniform(region.nearest, region.farthest);
  const double angle = random.log_uniform(region.smallest_deg, region.largest_deg) * std::numbers::pi / 180;
  c.light.position = range * glm::dvec3(std::sin(angle), 0, -std::cos(angle));
  if (random.chance(0.5)) c.ray.length = range * random.log_uniform(0.3, 3);
  return c;
}

/// Turns the lamp of a case into a spot of 0.1 to 180 degrees. Two thirds of such spots light some of the ray.
inline void turn_into_spot(Random& random, AirlightCase& c) {
  Cone& cone = c.light.light.cone;
  if (random.chance(0.5)) {
    const double exponent = random.chance(0.125) ? 0 : random.log_uniform(0.5, 2000);
    const double half_angle = random.chance(0.5)
                                  ? random.log_uniform(0.1, 90) * kDegree
                                  : std::acos(std::pow(random.log_uniform(1e-3, 0.5), 1 / std::max(exponent, 0.5)));
    cone = Cone::cosine(std::min(half_angle, std::numbers::pi / 2), exponent);
  } else {
    const double outer = random.log_uniform(0.1, 180) * kDegree;
    cone = Cone::smoothstep(outer * random.uniform(0, 0.98), outer);
  }
  c.light.direction = draw_direction(random);
  if (random.chance(0.67)) {  // aimed near a point of the ray
    const glm::dvec3 to_light = c.light.position - c.ray.origin;
    const double approach = glm::dot(to_light, c.ray.direction);
    const double offset = glm::length(to_light - approach * c.ray.direction);
    const double along = (random.chance(0.5) ? 1 : -1) * random.log_uniform(1e-2, 30) * std::max(offset, 0.01);
    const glm::dvec3 aim = glm::normalize((approach + along) * c.ray.direction - to_light);
    const double tilt = random.uniform(-1, 1) * cutoff_angle(cone);
    c.light.direction = glm::normalize(std::cos(tilt) * aim + std::sin(tilt) * draw_perpendicular(random, aim));
  }
}

/// draw_airlight_case() of spots.
inline AirlightCase draw_spot_airlight_case(Random& random, FogMode mode, LampLeg lamp_leg) {
  AirlightCase c = draw_airlight_case(random, mode, lamp_leg);
  turn_into_spot(random, c);
  return c;
}

/// Where a ray meets a lamp by coincidence: the eye or the ray's end on its cone, knee or extent, or in the lamp
/// itself, exactly or except for a few ulp; cones of 45, 60, 90 and 180 degrees and others, in radians of doubles or of
/// floats; rays along an axis of the world, of the lamp, across it or anywhere.
inline AirlightCase draw_coincident_airlight_case(Random& random, FogMode mode, LampLeg lamp_leg) {
  constexpr std::array kAngles{5., 20., 30., 45., 60., 90., 120., 135., 180.};
  constexpr std::array kWorldAxes{glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1)};
  AirlightCase c;
  c.lamp_leg = lamp_leg;
  c.atmosphere.phase.first.asymmetry = random.chance(0.5) ? 0 : random.uniform(-0.9, 0.9);
  Light& light = c.light.light;
  light.attenuation = {random.pick(std::array{0., 0.4, 1., 1.5}), random.chance(0.5) ? 0 : random.log_uniform(1e-3, 1),
                       random.log_uniform(1e-3, 1)};
  light.threshold = random.log_uniform(1e-3, 0.1);
  const auto radians = [&](double degrees) {
    return random.chance(0.5) ? degrees * kDegree : double(float(degrees) * float(kDegree));
  };
  const double angle = random.pick(kAngles);
  light.cone = random.chance(0.5) ? Cone::cosine(std::min(radians(std::min(angle, 90.)), std::numbers::pi / 2),
                                                 random.pick(std::array{0., 1., 8., 200.}))
                                  : Cone::smoothstep(radians(angle) * random.pick(std::array{0., 0.5, 0.9}),
                                                     std::min(radians(angle), std::numbers::pi));
  c.light.direction = random.chance(0.5) ? random.pick(kWorldAxes) : draw_direction(random);
  c.light.position = random.chance(0.5) ? glm::dvec3(0, 2, 0) : 10. * draw_direction(random);
  c.atmosphere.fog = Fog::from_visibility(mode, random.log_uniform(1, 1000));

  const double cutoff = cutoff_angle(light.cone);
  const glm::dvec3 side = draw_perpendicular(random, c.light.direction);
  const glm::dvec3 on_cone = std::cos(cutoff) * c.light.direction + std::sin(cutoff) * side;
  const double knee = compute_knee(light.attenuation);
  const double extent = compute_extent(light.attenuation, light.threshold);
  const double range = random.pick(std::array{0., knee, extent, extent * random.uniform(0, 1)});
  const double nudge = random.chance(0.5) ? 1 : 1 + random.pick(std::array{-1e-15, 1e-15, -1e-9, 1e-9});
  const glm::dvec3 met = c.light.position + nudge * range * (random.chance(0.7) ? on_cone : draw_direction(random));
  const int way = random.below(5);
  c.ray.direction = way == 0   ? random.pick(kWorldAxes)
                    : way == 1 ? c.light.direction
                    : way == 2 ? side
                    : way == 3 ? draw_perpendicular(random, side)
                               : draw_direction(random);
  if (random.chance(0.5)) c.ray.direction = -c.ray.direction;
  c.ray.origin = met;
  if (random.chance(0.4)) {  // the end of the ray is there
    c.ray.length = random.log_uniform(0.1, 100);
    c.ray.origin -= c.ray.length * c.ray.direction;
  } else if (random.chance(0.5)) {
    c.ray.length = random.log_uniform(0.1, 100);
  }
  return c;
}

/// Whether a ray runs through the lamp along the edge of a beam that is not dark there: it is lit or not by the last
/// digit.
inline bool runs_along_edge(const AirlightCase& c) {
  const Cone& cone = c.light.light.cone;
  const glm::dvec3 to_light = c.light.position - c.ray.origin;
  const double offset = glm::length(to_light - glm::dot(to_light, c.ray.direction) * c.ray.direction);
  const double slope = std::abs(glm::dot(c.light.direction, c.ray.direction));
  return cone.profile == ConeProfile::cosine && offset < 1e-6 && std::abs(slope - std::cos(cone.half_angle)) < 1e-6;
}

}  // namespace litfog::test
