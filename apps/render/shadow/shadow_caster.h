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

/// Metres around a lamp within which nothing casts its shadow: a lamp is in or on its lens, which other passes draw.
inline constexpr double kLampRadius = 0.1;

/// Half angle of the widest beam that one map holds, radians: a wider map has most of its texels near its rim.
inline constexpr double kWidestShadowMap = std::numbers::pi / 3;

/// A lamp that casts shadows by maps: square pictures, taken from the lamp, of how far its light gets. A beam up to
/// kWidestShadowMap has one map, across its axis. Others have a cube of maps of 90 degrees each, in the order ahead,
/// right, left, up, down and, where the beam is wide enough, behind.
struct ShadowCaster {
  std::int32_t light;       ///< its index in SceneLights
  std::size_t scene_light;  ///< its index in Scene::lights
  glm::dvec3 position;
  glm::dmat3 frame_from_world;  ///< rotation: x to the lamp's right, y up, -z along its axis
  bool is_cube;
  int map_count;
  double half_size;  ///< of a map, a metre before the lamp, in metres
  double reach;      ///< metres: no surface that it lights is farther, though fog may be. Finite
};

/// The part of space that a map shows, or a little more.
LightBounds bounds_of_map(const ShadowCaster& caster, int map);

/// The lamps of a scene that cast shadows: those that the eye's vehicle carries, then those that are brightest as seen
/// from the eye, were they all turned to it.
///
/// bounds    of all that can cast or receive a shadow
/// most      how many lamps at most; lamps that are black do not count
/// map_size  texels a side
std::vector<ShadowCaster> choose_shadow_casters(const SceneLights& lights, const scene::Bounds& bounds,
                                                const glm::dvec3& eye, std::size_t most, int map_size);

}  // namespace litfog::render
