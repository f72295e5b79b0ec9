// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/light/scene_lights.h"
#include "render/render_settings.h"
#include "scene/mesh.h"

namespace litfog::render {

/// The lights that can reach a surface, by their indices in SceneLights.
struct LightSelection {
  std::vector<std::int32_t> surface;  ///< local lights, then carried lights
  /// Whether a carried light's cone meets the surface. If so, all carried lights that are on light the fog before it,
  /// because each number of lights needs a shader of its own. If not, none does.
  bool is_fog_lit = false;
};

/// ranges  how far each light reaches surfaces, metres
/// local   the local lights that can reach the surface
/// bounds  the surface's, in world space
LightSelection select_lights(const SceneLights& lights, std::span<const double> ranges, std::vector<std::int32_t> local,
                             const scene::Bounds& bounds);

/// The carried lights that light the fog by their intensity; without skipping all carried lights.
std::vector<std::int32_t> fog_lights(const SceneLights& lights, Skipping skipping);

/// Reorders lights so that those with shared maps are adjacent.
///
/// map_kinds  LightMapStore::kinds(), empty where a path has no maps
std::vector<std::int32_t> grouped_by_maps(std::span<const std::int32_t> lights, std::span<const int> map_kinds);

/// The lights of a pass with LightFeed::bring_fog: the surface's lights and the fog's.
std::vector<std::int32_t> with_fog_lights(std::span<const std::int32_t> lights,
                                          std::span<const std::int32_t> fog_lights, std::span<const int> map_kinds);

/// The number of lights in the first batch: at most `most`, all with shared maps.
std::size_t batch_length(std::span<const std::int32_t> lights, std::size_t most, std::span<const int> map_kinds);

}  // namespace litfog::render
