// SPDX-License-Identifier: Apache-2.0
#include "scene/model/terrain.h"

#include <algorithm>
#include <cmath>

#include "scene/model/primitive.h"
#include "scene/noise.h"

namespace litfog::scene {
namespace {

constexpr int kMaxCells = 400;     // along a side of a patch
constexpr float kBlend_m = 12.0f;  // from the corridor's edge to full relief
constexpr float kBankReach_m = 60.0f;

int cells(float length, float cell) { return std::clamp(int(std::ceil(length / cell)), 1, kMaxCells); }

}  // namespace

float height_at(const Terrain& terrain, float x, float z) {
  const auto seed = std::uint32_t(terrain.ground_seed);
  // Bumps of 40 m and less; the sum of the octaves stays within about +-1.
  const float noise = octave_noise(x / 40.0f, z / 40.0f, 3, seed) + 0.08f * gradient_noise(x / 3.0f, z / 3.0f, seed);
  const float relief = terrain.relief_m * noise;
  if (terrain.corridor_m <= 0.0f && terrain.bank_m == 0.0f) return relief;
  const float beside = std::abs(terrain.path.offset_of(x, z)) - 0.5f * terrain.corridor_m;
  const float bank = terrain.bank_m * fade(std::clamp(beside / kBankReach_m, 0.0f, 1.0f));
  if (terrain.corridor_m <= 0.0f) return relief + bank;
  const float free = fade(std::clamp(beside / kBlend_m, 0.0f, 1.0f));
  return free * (relief + bank) - (1.0f - free) * terrain.corridor_drop_m;
}

Model make_ground(const Ground& ground) {
  const int columns = cells(ground.width_m, ground.cell_m) + 1;
  const int rows = cells(ground.depth_m, ground.cell_m) + 1;
  std::vector<glm::vec3> points;
  points.reserve(std::size_t(columns * rows));
  for (int j = 0; j < rows; ++j) {
    const float z = ground.centre_z_m + ground.depth_m * (0.5f - float(j) / float(rows - 1));
    for (int i = 0; i < columns; ++i) {
      const float x = ground.width_m * (float(i) / float(columns - 1) - 0.5f);
      points.emplace_back(x, height_at(ground.terrain, x, z), z);
    }
  }
  Model model;
  Mesh& mesh = part(model, "grass");
  mesh = make_surface(points, columns);
  // Plain coordinates, so that two patches of ground meet without a seam.
  for (Vertex& vertex : mesh.vertices) vertex.uv = {vertex.position.x, -vertex.position.z};
  return model;
}

}  // namespace litfog::scene
