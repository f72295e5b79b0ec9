// SPDX-License-Identifier: Apache-2.0
#include "scene/model/room.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/model/primitive.h"
#include "scene/model/wall.h"

namespace litfog::scene {
namespace {

constexpr float kNicheDepth_m = 0.32f;
constexpr float kPier_m = 0.42f;
constexpr float kPierDepth_m = 0.16f;
constexpr float kTile_m = 1.0f;  // floors and walls are cut into squares of about this size, for lighting per vertex

/// The vault's cross-section from the left springing to the right one, a circle's segment.
std::vector<glm::vec2> vault_arc(const Room& room, int pieces) {
  const float half = 0.5f * room.width_m;
  const float radius = 0.5f * (half * half / room.rise_m + room.rise_m);
  const float reach =
      std::atan2(half, radius - room.rise_m);  // beyond a quarter turn where the rise exceeds the half width
  std::vector<glm::vec2> arc;
  for (int i = 0; i <= pieces; ++i) {
    const float angle = reach * (2.0f * float(i) / float(pieces) - 1.0f);
    arc.emplace_back(radius * std::sin(angle), room.wall_m + room.rise_m - radius * (1.0f - std::cos(angle)));
  }
  return arc;
}

/// A flat panel of about kTile_m squares from (0, 0) to (width, height), facing +Z.
Mesh make_panel(float width, float height) {
  const int columns = int(std::ceil(width / kTile_m));
  const int rows = int(std::ceil(height / kTile_m));
  std::vector<glm::vec3> points;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      points.emplace_back(width * float(i) / float(columns), height * float(j) / float(rows), 0.0f);
    }
  }
  return make_surface(points, columns + 1);
}

void add_side(Model& model, const Room& room, const glm::mat4& at) {
  const float bay = room.depth_m / float(room.bays);
  std::vector<Opening> niches;
  for (int i = 0; i < room.bays; ++i) {
    const float middle = bay * (float(i) + 0.5f);
    const float half = std::min(0.55f, 0.5f * bay - 0.35f);
    if (half < 0.2f) break;  // too little space for a niche between the piers
    const Opening niche{middle - half, 0.75f, middle + half, std::min(2.15f, room.wall_m - 0.3f)};
    niches.push_back(niche);
    append(part(model, "plaster"), make_panel(2.0f * half, niche.top - niche.bottom),
           glm::translate(at, glm::vec3(niche.left, niche.bottom, -kNicheDepth_m)));
    append(part(model, "stone"), make_bevelled_box({2.0f * half + 0.16f, 0.07f, kNicheDepth_m + 0.08f}, 0.015f),
           glm::translate(at, glm::vec3(middle, niche.bottom - 0.06f, 0.04f - 0.5f * kNicheDepth_m)));
  }
  append(part(model, "plaster"), make_wall(room.depth_m, room.wall_m, niches, kNicheDepth_m), at);
  for (int i = 0; i <= room.bays; ++i) {
    const float along = std::clamp(bay * float(i), 0.5f * kPier_m, room.depth_m - 0.5f * kPier_m);
    Mesh& stone = part(model, "stone");
    const auto block = [&](float wider, float low, float high) {
      append(stone, make_bevelled_box({kPier_m + wider, high - low, kPierDepth_m + wider}, 0.018f),
             glm::translate(at, glm::vec3(along, low, 0.5f * (kPierDepth_m + wider) - 0.02f)));
    };
    block(0.12f, 0.0f, 0.28f);
    block(0.0f, 0.28f, room.wall_m - 0.2f);
    block(0.06f, room.wall_m - 0.24f, room.wall_m - 0.16f);
    block(0.14f, room.wall_m - 0.16f, room.wall_m + 0.02f);
  }
  for (int i = 0; i < room.bays; ++i) {
    append(part(model, "wood"),
           make_beam({bay * float(i), 0.09f, 0.012f}, {bay * float(i + 1), 0.09f, 0.012f}, 0.024f, 0.18f), at);
  }
}

/// An end wall with the lunette under the vault.
void add_end(Model& model, const Room& room, bool door, const glm::mat4& at) {
  Mesh& plaster = part(model, "plaster");
  const float middle = 0.5f * room.width_m;
  std::vector<Opening> openings;
  if (door) {
    const Opening opening{middle - 0.6f, 0.0f, middle + 0.6f, 2.15f};
    openings.push_back(opening);
    add_door(model, opening, at, "wood");
    for (const float side : {-1.0f, 1.0f}) {
      const float x = middle + side * 0.70f;
      append(part(model, "stone"), make_bevelled_box({0.2f, 2.15f, 0.1f}, 0.02f),
             glm::translate(at, glm::vec3(x, 0.0f, 0.03f)));
    }
    append(part(model, "stone"), make_bevelled_box({1.75f, 0.22f, 0.14f}, 0.025f),
           glm::translate(at, glm::vec3(middle, 2.15f, 0.04f)));
  }
  append(plaster, make_wall(room.width_m, room.wall_m, openings, kReveal_m), at);
  std::vector<glm::vec3> lunette;
  for (const glm::vec2& point : vault_arc(room, 32)) lunette.emplace_back(middle - point.x, point.y, 0.0f);
  Mesh face;
  add_face(face, lunette);
  append(plaster, face, at);
  Mesh& wood = part(model, "wood");
  const float stop = door ? middle - 0.8f : room.width_m;
  append(wood, make_beam({0.0f, 0.09f, 0.012f}, {stop, 0.09f, 0.012f}, 0.024f, 0.18f), at);
  if (door) append(wood, make_beam({middle + 0.8f, 0.09f, 0.012f}, {room.width_m, 0.09f, 0.012f}, 0.024f, 0.18f), at);
  // The moulding the vault stands on goes on round the end.
  const glm::vec3 line[] = {{room.width_m, room.wall_m - 0.02f, 0.0f}, {0.0f, room.wall_m - 0.02f, 0.0f}};
  append(part(model, "stone"),
         make_sweep({{0.0f, 0.10f}, {-0.09f, 0.10f}, {-0.11f, 0.06f}, {-0.07f, 0.0f}, {0.0f, -0.05f}}, line), at);
}

}  // namespace

Model make_room(const Room& room) {
  Model model;
  const float half_width = 0.5f * room.width_m;
  const float half_depth = 0.5f * room.depth_m;
  const float right = glm::half_pi<float>();
  append(part(model, "wood_floor"), make_panel(room.width_m, room.depth_m),
         glm::rotate(place({-half_width, 0.0f, half_depth}), -right, glm::vec3(1, 0, 0)));
  add_side(model, room, place({-half_width, 0.0f, half_depth}, right));
  add_side(model, room, place({half_width, 0.0f, -half_depth}, -right));
  add_end(model, room, true, place({-half_width, 0.0f, -half_depth}));
  add_end(model, room, false, place({half_width, 0.0f, half_depth}, 2.0f * right));
  // Vault and side mouldings run from the near end to the far one.
  std::vector<glm::vec3> axis;
  const int steps = int(std::ceil(room.depth_m / kTile_m));
  for (int i = 0; i <= steps; ++i) {
    axis.emplace_back(0.0f, 0.0f, half_depth - room.depth_m * float(i) / float(steps));
  }
  const std::vector<glm::vec2> arc = vault_arc(room, 40);
  append(part(model, "vault_plaster"), make_sweep(arc, axis));
  Mesh& stone = part(model, "stone");
  for (const float side : {-1.0f, 1.0f}) {
    std::vector<glm::vec2> moulding;
    for (const glm::vec2& p : {glm::vec2(0.0f, 0.10f), glm::vec2(0.09f, 0.10f), glm::vec2(0.11f, 0.06f),
                               glm::vec2(0.07f, 0.0f), glm::vec2(0.0f, -0.05f)}) {
      moulding.emplace_back(side * (p.x - half_width), p.y + room.wall_m - 0.02f);
    }
    if (side > 0.0f) std::reverse(moulding.begin(), moulding.end());
    append(stone, make_sweep(moulding, axis));
  }
  // Ribs over the piers.
  for (int i = 0; i <= room.bays; ++i) {
    const float along =
        std::clamp(room.depth_m * float(i) / float(room.bays), 0.5f * kPier_m, room.depth_m - 0.5f * kPier_m);
    std::vector<glm::vec3> rib;
    for (const glm::vec2& point : arc) rib.emplace_back(point, half_depth - along);
    append(stone,
           make_sweep(
               {{-0.02f, -0.15f}, {0.10f, -0.15f}, {0.14f, -0.11f}, {0.14f, 0.11f}, {0.10f, 0.15f}, {-0.02f, 0.15f}},
               rib, glm::vec3(0, 0, 1)));
  }
  return model;
}

}  // namespace litfog::scene
