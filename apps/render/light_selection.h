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
  /// Those that can reach the surface: the local ones, then the carried ones; with light maps, lights that share their
  /// maps together.
  std::vector<std::int32_t> surface;
  /// Those that light the fog before it: all that shine, for each number of them is another shader, or none where no
  /// light's cone meets it.
  std::vector<std::int32_t> fog;
};

/// local      the local lights that can reach the surface
/// bounds     the surface's, world space
/// map_kinds  of all lights: those of one kind share their maps; empty where the path has none
LightSelection select_lights(const SceneLights& lights, std::span<const std::int32_t> local,
                             const scene::Bounds& bounds, std::span<const int> map_kinds, Skipping skipping);

/// How many of the first lights make a batch: at most `most`, and all of one map kind.
std::size_t batch_length(std::span<const std::int32_t> lights, std::size_t most, std::span<const int> map_kinds);

}  // namespace litfog::render
