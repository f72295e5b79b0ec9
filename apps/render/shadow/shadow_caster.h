// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "litfog/light_bounds.h"
#include "render/light/scene_lights.h"
#include "scene/mesh.h"

namespace litfog::render {

/// Metres around a lamp within which nothing casts a shadow, because lamps are in or on their lenses.
inline constexpr double kLampRadius = 0.1;

/// Half angle of the widest beam in one map, radians. A wider map would have most of its texels near its rim.
inline constexpr double kWidestShadowMap = std::numbers::pi / 3;

/// A lamp that casts shadows by shadow maps: square depth pictures, taken from the lamp. A beam up to kWidestShadowMap
/// has one map, across its axis. Wider beams have a cube of maps of 90 degrees each, in the order ahead, right, left,
/// up, down and, if the beam is wide enough, behind.
struct ShadowCaster {
  std::int32_t light;       ///< its index in SceneLights
  std::size_t scene_light;  ///< its index in Scene::lights
  glm::dvec3 position;
  glm::dmat3 frame_from_world;  ///< rotation: x to the lamp's right, y up, -z along its axis
  bool is_cube;
  int map_count;
  double half_size;  ///< half a map's side 1 m before the lamp, metres
  double reach;      ///< metres, finite; no lit surface is farther, though lit fog may be
};

/// Bounds of the space that a map shows; may be a little larger.
LightBounds bounds_of_map(const ShadowCaster& caster, int map);

/// Chooses the lamps that cast shadows: first carried lamps, then those that would be brightest at the eye if all lamps
/// pointed at it.
///
/// bounds    around everything that can cast or receive a shadow
/// most      largest number of lamps; black lamps do not count
/// map_size  texels along a side
std::vector<ShadowCaster> choose_shadow_casters(const SceneLights& lights, const scene::Bounds& bounds,
                                                const glm::dvec3& eye, std::size_t most, int map_size);

}  // namespace litfog::render
