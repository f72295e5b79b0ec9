// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "litfog/light.h"
#include "scene/mesh.h"

namespace litfog::render {

/// Whether a light can light anything within a box: litfog::can_light.
///
/// extent  metres; infinity asks for the cone alone
bool can_reach(const PlacedLight& light, double extent, const scene::Bounds& box);

/// Finds the lights, among many, that can reach a box: those of can_reach(), which is asked only about the few lights
/// that a bound of their sectors does not decide (in `approach` 0.2% of 50 million). Neighbours in a scene's list are
/// mostly neighbours in space, because its lights stand in rows: a box that no light of a group can reach is not tested
/// against each of them.
class LightFinder {
 public:
  /// lights, extents (metres)  have to outlive this
  LightFinder(std::span<const PlacedLight> lights, std::span<const double> extents);

  /// Indices of the lights that can reach a box, in order.
  std::vector<std::int32_t> reaching(const scene::Bounds& box) const;
  /// Indices of those candidates that can reach a box, in order.
  std::vector<std::int32_t> reaching(const scene::Bounds& box, std::span<const std::int32_t> candidates) const;

 private:
  struct Box {
    glm::dvec3 low;
    glm::dvec3 high;
  };

  struct Sector {
    glm::dvec3 apex;
    glm::dvec3 axis;
    double range;
    double cos_half_angle;
    double sin_half_angle;
  };

  /// can_reach(), for a box whose centre and half size are given.
  bool reaches(std::size_t light, const scene::Bounds& box, const glm::dvec3& centre, const glm::dvec3& half) const;

  std::span<const PlacedLight> lights_;
  std::span<const double> extents_;
  std::vector<Sector> sectors_;  // one a light
  std::vector<Box> groups_;      // what each group of lights can reach
};

}  // namespace litfog::render
