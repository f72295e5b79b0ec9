// SPDX-License-Identifier: Apache-2.0
#include "scene/model/road.h"

#include <cmath>

#include "scene/model/primitive.h"

namespace litfog::scene {
namespace {

constexpr float kStep_m = 4.0f;  // between cross-sections

}  // namespace

float height_at(const Carriageway& carriageway, float offset) {
  return carriageway.camber * (0.5f * carriageway.width_m - std::abs(offset));
}

Model make_road(const Road& road) {
  const RoadPath& centre_line = road.carriageway.path;
  const float edge = 0.5f * road.carriageway.width_m;
  const float shoulder = edge + road.shoulder_m;
  const float verge = shoulder + 1.2f;
  const float verge_depth = 0.45f;
  const std::vector<glm::vec3> path = centre_line.line(0.0f, centre_line.length_m, kStep_m, 0.0f, 0.0f);
  const float crown = height_at(road.carriageway, 0.0f);
  Model model;
  part(model, road.wet != 0 ? "wet_asphalt" : "asphalt") = make_sweep(
      {{edge, 0.0f}, {0.5f * edge, 0.5f * crown}, {0.0f, crown}, {-0.5f * edge, 0.5f * crown}, {-edge, 0.0f}}, path);
  Mesh& gravel = part(model, "gravel");
  const float lip = -0.04f * road.shoulder_m;
  for (const auto& side : {make_sweep({{verge, -verge_depth}, {shoulder, lip}, {edge, 0.0f}}, path),
                           make_sweep({{-edge, 0.0f}, {-shoulder, lip}, {-verge, -verge_depth}}, path)}) {
    append(gravel, side);
  }
  return model;
}

Model make_road_markings(const RoadMarkings& markings) {
  Model model;
  Mesh& paint = part(model, "road_paint");
  const Carriageway& carriageway = markings.carriageway;
  const auto add_line = [&](float from, float to, float offset) {
    const float right = offset + 0.5f * markings.line_m;
    const float left = offset - 0.5f * markings.line_m;
    const std::vector<glm::vec3> path = carriageway.path.line(from, to, kStep_m, 0.0f, 0.0f);
    append(paint, make_sweep({{right, height_at(carriageway, right) + markings.lift_m},
                              {left, height_at(carriageway, left) + markings.lift_m}},
                             path));
  };
  const float edge = 0.5f * carriageway.width_m - 0.25f;
  const float length = carriageway.path.length_m;
  for (const float offset : {-edge, edge}) add_line(0.0f, length, offset);
  if (markings.gap_m <= 0.0f) {
    add_line(0.0f, length, 0.0f);
    return model;
  }
  for (float along = 0.0f; along + markings.dash_m <= length; along += markings.dash_m + markings.gap_m) {
    add_line(along, along + markings.dash_m, 0.0f);
  }
  return model;
}

Model make_zebra_crossing(const ZebraCrossing& crossing) {
  Model model;
  Mesh& paint = part(model, "road_paint");
  const int bars = int((crossing.width_m / crossing.bar_m + 1.0f) / 2.0f);
  const float half = 0.5f * crossing.length_m;
  for (int i = 0; i < bars; ++i) {
    const float left = crossing.bar_m * (2.0f * float(i) - float(bars) + 0.5f);
    const float right = left + crossing.bar_m;
    const float y = crossing.lift_m;
    add_face(paint, {{left, y, half}, {right, y, half}, {right, y, -half}, {left, y, -half}});
  }
  return model;
}

}  // namespace litfog::scene
