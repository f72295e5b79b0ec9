// SPDX-License-Identifier: Apache-2.0
#include "scene/model/terrain.h"

#include <algorithm>
#include <cmath>

#include "scene/model/primitive.h"
#include "scene/noise.h"

namespace litfog::scene {
namespace {

constexpr int kMostCells = 400;    // a side of the ground
constexpr float kBlend_m = 12.0f;  // from the corridor's edge to full relief
constexpr float kBankReach_m = 60.0f;
constexpr float kRoadStep_m = 4.0f;

int cells(float length, float cell) { return std::clamp(int(std::ceil(length / cell)), 1, kMostCells); }

}  // namespace

float ground_height(const Ground& ground, float x, float z) {
  const auto seed = std::uint32_t(ground.ground_seed);
  // Bumps of 40 m and less; the sum of the octaves stays within about +-1.
  const float noise = octave_noise(x / 40.0f, z / 40.0f, 3, seed) + 0.08f * gradient_noise(x / 3.0f, z / 3.0f, seed);
  const float relief = ground.relief_m * noise;
  if (ground.corridor_m <= 0.0f && ground.bank_m == 0.0f) return relief;
  const float beside = std::abs(ground.offset_of(x, z)) - 0.5f * ground.corridor_m;
  const float bank = ground.bank_m * fade(std::clamp(beside / kBankReach_m, 0.0f, 1.0f));
  if (ground.corridor_m <= 0.0f) return relief + bank;
  const float free = fade(std::clamp(beside / kBlend_m, 0.0f, 1.0f));
  return free * (relief + bank) - (1.0f - free) * ground.corridor_drop_m;
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
      points.emplace_back(x, ground_height(ground, x, z), z);
    }
  }
  Model model;
  Mesh& mesh = part(model, "grass");
  mesh = make_surface(points, columns);
  // Plain coordinates, so that two patches of ground meet without a seam.
  for (Vertex& vertex : mesh.vertices) vertex.uv = {vertex.position.x, -vertex.position.z};
  return model;
}

float road_height(const Road& road, float offset) { return road.camber * (0.5f * road.width_m - std::abs(offset)); }

Model make_road(const Road& road) {
  const float edge = 0.5f * road.width_m;
  const float shoulder = edge + road.shoulder_m;
  const float verge = shoulder + 1.2f;
  const float verge_depth = 0.45f;
  const std::vector<glm::vec3> path = road.line(0.0f, road.length_m, kRoadStep_m, 0.0f, 0.0f);
  const float crown = road_height(road, 0.0f);
  Model model;
  part(model, "asphalt") = make_sweep(
      {{edge, 0.0f}, {0.5f * edge, 0.5f * crown}, {0.0f, crown}, {-0.5f * edge, 0.5f * crown}, {-edge, 0.0f}}, path);
  Mesh& gravel = part(model, "gravel");
  const float lip = -0.04f * road.shoulder_m;
  for (const auto& side : {make_sweep({{verge, -verge_depth}, {shoulder, lip}, {edge, 0.0f}}, path),
                           make_sweep({{-edge, 0.0f}, {-shoulder, lip}, {-verge, -verge_depth}}, path)}) {
    append(gravel, side, glm::mat4(1.0f));
  }
  return model;
}

void add_stripe(Mesh& mesh, const Road& road, float from, float to, float offset, float width, float lift) {
  const float right = offset + 0.5f * width;
  const float left = offset - 0.5f * width;
  const std::vector<glm::vec3> path = road.line(from, to, kRoadStep_m, 0.0f, 0.0f);
  append(mesh, make_sweep({{right, road_height(road, right) + lift}, {left, road_height(road, left) + lift}}, path),
         glm::mat4(1.0f));
}

Model make_road_markings(const RoadMarkings& markings) {
  Model model;
  Mesh& paint = part(model, "road_paint");
  const float edge = 0.5f * markings.width_m - 0.25f;
  for (const float offset : {-edge, edge}) {
    add_stripe(paint, markings, 0.0f, markings.length_m, offset, markings.line_m, markings.lift_m);
  }
  if (markings.gap_m <= 0.0f) {
    add_stripe(paint, markings, 0.0f, markings.length_m, 0.0f, markings.line_m, markings.lift_m);
    return model;
  }
  // Parameters allow at most 2000 m and dashes of at least 1 m.
  for (float along = 0.0f; along + markings.dash_m <= markings.length_m; along += markings.dash_m + markings.gap_m) {
    add_stripe(paint, markings, along, along + markings.dash_m, 0.0f, markings.line_m, markings.lift_m);
  }
  return model;
}

}  // namespace litfog::scene
