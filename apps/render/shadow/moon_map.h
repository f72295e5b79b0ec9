// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace litfog::render {

/// A shadow map of the directional light: a square depth picture, taken along the light.
struct MoonMap {
  glm::dvec3 position;          ///< at the picture's centre, before everything that casts shadows
  glm::dmat3 frame_from_world;  ///< rotation: x to the picture's right, y up, -z along the light
  double half_size;             ///< metres
  double reach;                 ///< metres along the light, to beyond everything

  friend bool operator==(const MoonMap&, const MoonMap&) = default;
};

/// The shadow maps of a scene's directional light, the finest first; none without such a light. Each map shows a ball
/// around the camera's view volume up to a distance. The last map's distance reaches the farthest surface, and each
/// other map's is a quarter of the next one's ("cascades", Wolfgang Engel 2006, "Cascaded Shadow Maps").
///
/// bounds    around everything that can cast or receive a shadow
/// aspect    width over height of the camera's picture
/// map_size  texels along a side
std::vector<MoonMap> fit_moon_maps(const scene::Environment& environment, const scene::Camera& camera,
                                   const scene::Bounds& bounds, double aspect, int map_size);
inline constexpr int kMoonMaps = 4;

/// Whether a box can cast a shadow into a map.
bool can_cast(const scene::Bounds& box, const MoonMap& map);

}  // namespace litfog::render
