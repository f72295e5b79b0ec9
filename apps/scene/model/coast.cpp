// SPDX-License-Identifier: Apache-2.0
#include "scene/model/coast.h"

#include <algorithm>
#include <vector>

#include "scene/model/primitive.h"
#include "scene/noise.h"

namespace litfog::scene {
namespace {

constexpr int kIslandCells = 72;  // along a side
constexpr float kSunk_m = 2.5f;   // how deep the island's foot lies

/// A grid of cells x cells over +-half_width and +-half_depth, as high as height(x, z).
template <typename Height>
Mesh make_grid(float half_width, float half_depth, int cells, const Height& height) {
  std::vector<glm::vec3> points;
  for (int j = 0; j <= cells; ++j) {
    const float z = half_depth * (1.0f - 2.0f * float(j) / float(cells));
    for (int i = 0; i <= cells; ++i) {
      const float x = half_width * (2.0f * float(i) / float(cells) - 1.0f);
      points.emplace_back(x, height(x, z), z);
    }
  }
  Mesh mesh = make_surface(points, cells + 1);
  for (Vertex& vertex : mesh.vertices) vertex.uv = {vertex.position.x, -vertex.position.z};
  compute_tangents(mesh);
  return mesh;
}

/// 1 where the island is level, 0 at its foot.
float rise_at(const Island& island, float x, float z) {
  const auto seed = std::uint32_t(island.seed);
  const float ragged = 1.0f + 0.25f * octave_noise(2.5f * x / island.radius_m, 2.5f * z / island.radius_m, 3, seed);
  const float range = glm::length(glm::vec2(x, z)) * ragged;
  const float flat = std::min(1.3f * island.flat_m, 0.8f * island.radius_m);
  return std::clamp((0.95f * island.radius_m - range) / (0.95f * island.radius_m - flat), 0.0f, 1.0f);
}

float height_at(const Island& island, float x, float z) {
  const float rise = rise_at(island, x, z);
  const float crags = octave_noise(x / 9.0f, z / 9.0f, 4, std::uint32_t(island.seed) + 100);
  return fade(rise) * (island.height_m + kSunk_m) - kSunk_m + island.relief_m * crags * 4.0f * rise * (1.0f - rise);
}

}  // namespace

Model make_sea(const Sea& sea) {
  return {{"water", make_grid(0.5f * sea.width_m, 0.5f * sea.depth_m, 24, [](float, float) { return 0.0f; })}};
}

Model make_island(const Island& island) {
  const float half = island.radius_m * 1.25f;
  const auto rock = [&](float x, float z) { return height_at(island, x, z); };
  // The turf lies over the rock where the island is high, and below it elsewhere.
  const auto turf = [&](float x, float z) {
    return rock(x, z) + 0.5f * fade(std::clamp(6.0f * rise_at(island, x, z) - 4.2f, 0.0f, 1.0f)) - 0.3f;
  };
  return {{"stone", make_grid(half, half, kIslandCells, rock)}, {"grass", make_grid(half, half, kIslandCells, turf)}};
}

}  // namespace litfog::scene
