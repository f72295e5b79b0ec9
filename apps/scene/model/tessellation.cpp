// SPDX-License-Identifier: Apache-2.0
#include "scene/model/tessellation.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "scene/model/primitive.h"

namespace litfog::scene {
namespace {

constexpr float kWire_m = 0.012f;

/// Beams along the edges of a mesh's triangles.
Mesh make_wires(const Mesh& mesh) {
  Mesh wires;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t a = mesh.indices[i];
    const std::uint32_t b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
    edges.insert(std::minmax(a, b));
  }
  for (const auto& [a, b] : edges) {
    const glm::vec3 from = mesh.vertices[a].position;
    const glm::vec3 to = mesh.vertices[b].position;
    const bool is_upright = std::abs(to.y - from.y) > 0.9f * glm::distance(from, to);
    append(wires, make_beam(from, to, kWire_m, kWire_m, is_upright ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0)));
  }
  return wires;
}

Model finished(Mesh mesh, int wire) {
  if (wire != 0) return {{"paint_white", make_wires(mesh)}};
  return {{"sign_white", std::move(mesh)}};
}

}  // namespace

Model make_panel_model(const Panel& panel) {
  std::vector<glm::vec3> points;
  for (int j = 0; j <= panel.cells; ++j) {
    for (int i = 0; i <= panel.cells; ++i) {
      const glm::vec2 fraction = glm::vec2(i, j) / float(panel.cells);
      points.emplace_back(panel.size_m * (fraction.x - 0.5f), panel.size_m * fraction.y, 0.0f);
    }
  }
  return finished(make_surface(points, panel.cells + 1), panel.wire);
}

Model make_drum_model(const Drum& drum) {
  std::vector<glm::vec2> profile;
  for (int i = 0; i <= drum.rings; ++i) {
    profile.emplace_back(drum.radius_m, drum.height_m * float(i) / float(drum.rings));
  }
  return finished(make_lathe(profile, drum.segments), drum.wire);
}

}  // namespace litfog::scene
