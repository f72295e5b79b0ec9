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
  /// Whether a carried light's cone meets the surface. If so, all carried lights that shine light the fog before the
  /// surface, because each number of lights needs its own shader; if not, none does.
  bool is_fog_lit = false;
};

/// ranges  metres, one a light: how far the light reaches surfaces
/// local   the local lights that can reach the surface
/// bounds  of the surface, in world space
LightSelection select_lights(const SceneLights& lights, std::span<const double> ranges, std::vector<std::int32_t> local,
                             const scene::Bounds& bounds);

/// The carried lights that light the fog by their intensity, or all carried lights without skipping.
std::vector<std::int32_t> fog_lights(const SceneLights& lights, Skipping skipping);

/// Reorders lights so that those with shared maps are adjacent.
///
/// map_kinds  LightMapStore::kinds(), empty where a path has no maps
std::vector<std::int32_t> grouped_by_maps(std::span<const std::int32_t> lights, std::span<const int> map_kinds);

/// The lights of a pass with LightFeed::bring_fog: those of the surface and those of the fog.
std::vector<std::int32_t> with_fog_lights(std::span<const std::int32_t> lights,
                                          std::span<const std::int32_t> fog_lights, std::span<const int> map_kinds);

/// How many of the first lights make a batch: at most `most`, all with shared maps.
std::size_t batch_length(std::span<const std::int32_t> lights, std::size_t most, std::span<const int> map_kinds);

}  // namespace litfog::render
