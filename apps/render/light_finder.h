// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "litfog/light.h"
#include "scene/mesh.h"

namespace litfog::render {

/// Whether a light can light anything within a box: the box meets the sphere of the light's extent, and the box's
/// sphere meets the light's cone. May say yes where it cannot; never no where it can.
///
/// extent  metres; infinity asks for the cone alone
bool can_reach(const PlacedLight& light, double extent, const scene::Bounds& box);

/// Finds the lights that can reach a box among many. A scene's lights stand in rows, so neighbours in the list are
/// neighbours in space: what is far from a whole group of them is not asked about each.
class LightFinder {
 public:
  /// lights, extents (metres)  have to outlive this
  LightFinder(std::span<const PlacedLight> lights, std::span<const double> extents);

  /// Indices of the lights that can reach a box, in order.
  std::vector<std::int32_t> reaching(const scene::Bounds& box) const;
  /// The same of some of the lights.
  std::vector<std::int32_t> reaching(const scene::Bounds& box, std::span<const std::int32_t> candidates) const;

 private:
  struct Box {
    glm::dvec3 low;
    glm::dvec3 high;
  };

  std::span<const PlacedLight> lights_;
  std::span<const double> extents_;
  std::vector<Box> groups_;  // what each group of lights can reach at most
};

}  // namespace litfog::render
