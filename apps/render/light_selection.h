// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/render_settings.h"
#include "render/scene_lights.h"
#include "scene/mesh.h"

namespace litfog::render {

/// The lights that a surface is drawn with, by their indices in SceneLights.
struct LightSelection {
  /// Those that can reach the surface: the local ones, then the carried ones. If the path has light maps, lights that
  /// share their maps are adjacent instead.
  std::vector<std::int32_t> surface;
  /// Those that light the fog before it. Either none, because no carried light's cone meets the surface, or all that
  /// shine: each number of lights needs its own shader.
  std::vector<std::int32_t> fog;
};

/// local      the local lights that can reach the surface
/// bounds     the surface's, world space
/// map_kinds  LightMapStore::kinds
LightSelection select_lights(const SceneLights& lights, std::span<const std::int32_t> local,
                             const scene::Bounds& bounds, std::span<const int> map_kinds, Skipping skipping);

/// The lights of a pass whose lights bring their fog (LightFeed::bring_fog): those of the surface and those of the fog.
std::vector<std::int32_t> with_fog_lights(const LightSelection& selection, std::span<const int> map_kinds);

/// How many of the first lights make a batch: at most `most`, and all share their maps.
std::size_t batch_length(std::span<const std::int32_t> lights, std::size_t most, std::span<const int> map_kinds);

}  // namespace litfog::render
