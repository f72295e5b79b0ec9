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

/// Finds the lights, among many, that can reach a box by can_reach(). It calls can_reach() only for the few lights that
/// a bound of their sectors does not decide (in `approach` 0.2% of 50 million). Lights that are neighbours in a scene's
/// list are mostly neighbours in space, because lamps stand in rows. So lights are tested in groups first.
class LightFinder {
 public:
  /// lights, extents (metres)  must outlive this object
  LightFinder(std::span<const PlacedLight> lights, std::span<const double> extents);

  /// Indices of the lights that can reach a box, in order.
  std::vector<std::int32_t> reaching(const scene::Bounds& box) const;
  /// Indices of the candidates that can reach a box, in order.
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
  std::vector<Box> groups_;      // the space that each group of lights can reach
};

}  // namespace litfog::render
