// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "litfog/light.h"

namespace litfog::render {

/// Lights that differ in their places only. From far enough away they light like one of them in their middle, as many
/// times as bright (Walter et al. 2005, "Lightcuts: A Scalable Approach to Illumination").
struct LightGroup {
  std::int32_t first;   ///< of its lights, in LightGroups::lights
  std::int32_t count;   ///< of them, at least 2
  std::int32_t parent;  ///< the group of which it is a half, or -1
  glm::dvec3 position;  ///< their mean, metres
  double spread;        ///< root mean square of their distances from it, metres
  double radius;        ///< the largest of them
};

/// Binary trees of groups over lights.
struct LightGroups {
  std::vector<LightGroup> groups;
  std::vector<std::int32_t> lights;   ///< each once, those of a group adjacent
  std::vector<std::int32_t> parents;  ///< of each light: the smallest group that has it, or -1

  std::span<const std::int32_t> lights_of(const LightGroup& group) const {
    return std::span(lights).subspan(std::size_t(group.first), std::size_t(group.count));
  }
};

/// Groups lights of equal kinds, directions and colours by their places: a group falls apart at the widest gap along
/// its longest axis, of about equal ones at that nearest to its middle.
///
/// kinds  of each light: only those of equal ones share groups. Below 0: it is in none
LightGroups group_lights(std::span<const PlacedLight> lights, std::span<const int> kinds);

}  // namespace litfog::render
