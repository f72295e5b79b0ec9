// SPDX-License-Identifier: Apache-2.0
#include "scene/model/house.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/hash_random.h"
#include "scene/model/primitive.h"
#include "scene/model/wall.h"

namespace litfog::scene {
namespace {

constexpr float kStorey_m = 2.7f;
constexpr float kPlinth_m = 0.35f;
constexpr float kEaves_m = 0.5f;
constexpr float kVerge_m = 0.35f;
constexpr float kRoofThickness_m = 0.14f;

/// A wall, its windows and perhaps a door in the bay `door` (counted from the left; -1: none).
void add_facade(Model& model, const House& house, float width, int door, const glm::mat4& at, HashRandom& random) {
  const std::string_view material = house.brick != 0 ? "brick" : "plaster";
  const float height = kPlinth_m + kStorey_m * float(house.storeys);
  const int bays = std::max(1, int(width / 2.5f));
  std::vector<Opening> openings;
  const float bay = width / float(bays);
  for (int storey = 0; storey < house.storeys; ++storey) {
    for (int i = 0; i < bays; ++i) {
      const float middle = bay * (float(i) + 0.5f);
      const float floor = kPlinth_m + kStorey_m * float(storey);
      if (storey == 0 && i == door) {
        const Opening opening{middle - 0.5f, 0.18f, middle + 0.5f, floor + 2.05f};
        openings.push_back(opening);
        add_door(model, opening, at, "paint_green");
        add_box(part(model, "concrete"), {middle - 0.9f, 0.0f, 0.0f}, {middle + 0.9f, 0.17f, 0.9f}, at);
        // The lamp beside the door.
        append(part(model, "lamp_white"), make_sphere(0.08f, 12),
               glm::translate(at, glm::vec3(middle + 0.75f, floor + 1.75f, 0.13f)));
        add_box(part(model, "paint_grey"), {middle + 0.70f, floor + 1.83f, 0.0f}, {middle + 0.80f, floor + 1.88f, 0.2f},
                at);
        continue;
      }
      const Opening opening{middle - 0.55f, floor + 0.85f, middle + 0.55f, floor + 2.1f};
      openings.push_back(opening);
      add_window(model, opening, at, random.unit() < house.lit);
    }
  }
  append(part(model, material), make_wall(width, height, openings, kReveal_m), at);
  // The plinth runs round, but not before the door.
  const float left = door < 0 ? width : bay * (float(door) + 0.5f) - 0.5f;
  add_box(part(model, "stone"), {-0.04f, -0.5f, -0.1f}, {std::min(left, width + 0.04f), kPlinth_m, 0.04f}, at);
  if (door >= 0) add_box(part(model, "stone"), {left + 1.0f, -0.5f, -0.1f}, {width + 0.04f, kPlinth_m, 0.04f}, at);
}

void add_roof(Model& model, const House& house) {
  const float slope = glm::radians(house.pitch_deg);
  const float wall = kPlinth_m + kStorey_m * float(house.storeys);
  const float half_depth = 0.5f * house.depth_m;
  const float half_width = 0.5f * house.width_m + kVerge_m;
  const float ridge = wall + half_depth * std::tan(slope) + kRoofThickness_m / std::cos(slope);
  const float run = half_depth + kEaves_m;
  const float eaves = ridge - run * std::tan(slope);
  const glm::vec3 down(0.0f, -kRoofThickness_m * std::cos(slope), -kRoofThickness_m * std::sin(slope));
  for (const float turn : {0.0f, glm::pi<float>()}) {
    const glm::mat4 at = glm::rotate(glm::mat4(1.0f), turn, glm::vec3(0, 1, 0));
    const glm::vec3 a(-half_width, eaves, run);
    const glm::vec3 b(half_width, eaves, run);
    const glm::vec3 c(half_width, ridge, 0.0f);
    const glm::vec3 d(-half_width, ridge, 0.0f);
    Mesh tiles;
    add_face(tiles, {a, b, c, d});
    append(part(model, "roof_tiles"), tiles, at);
    Mesh boards;
    const glm::vec3 below(0.0f, ridge - kRoofThickness_m / std::cos(slope) - ridge, 0.0f);
    add_face(boards, {b + down, a + down, d + below, c + below});
    add_face(boards, {a + down, b + down, b, a});
    add_face(boards, {b + down, c + below, c, b});
    add_face(boards, {d + below, a + down, a, d});
    append(part(model, "wood"), boards, at);
    // Gutter: a half pipe under the tiles' edge, and a downpipe at one end.
    std::vector<glm::vec2> half_pipe;
    for (int i = 0; i <= 6; ++i) {
      const float angle = glm::pi<float>() * (1.0f + float(i) / 6.0f);
      half_pipe.emplace_back(0.06f * std::cos(angle), 0.06f * std::sin(angle));
    }
    const std::vector<glm::vec2> inside(half_pipe.rbegin(), half_pipe.rend());
    const glm::vec3 line[] = {{half_width, eaves - 0.02f, run + 0.06f}, {-half_width, eaves - 0.02f, run + 0.06f}};
    append(part(model, "galvanised"), make_sweep(half_pipe, line), at);
    append(part(model, "galvanised"), make_sweep(inside, line), at);
    const float x = half_width - kVerge_m - 0.15f;
    const glm::vec3 pipe[] = {{x, eaves - 0.06f, run + 0.06f},
                              {x, eaves - 0.2f, run},
                              {x, eaves - 0.5f, half_depth + 0.08f},
                              {x, 0.1f, half_depth + 0.08f}};
    append(part(model, "galvanised"), make_tube(pipe, 0.04f, 8), at);
  }
  const glm::vec3 crest[] = {{-half_width, ridge - 0.02f, 0.0f}, {half_width, ridge - 0.02f, 0.0f}};
  append(part(model, "roof_tiles"), make_tube(crest, 0.11f, 10));
  // Chimney.
  const float x = -0.27f * house.width_m;
  const float foot = wall;
  append(part(model, "brick"), make_box({0.75f, ridge + 0.9f - foot, 0.6f}), place({x, foot, -0.4f}));
  append(part(model, "concrete"), make_bevelled_box({0.9f, 0.1f, 0.75f}, 0.03f), place({x, ridge + 0.9f, -0.4f}));
  append(part(model, "roof_tiles"), make_cylinder({0.14f, 0.11f, 0.4f, 12}), place({x, ridge + 1.0f, -0.4f}));
}

}  // namespace

Model make_house(const House& house) {
  HashRandom random(std::uint32_t(house.seed));
  Model model;
  const float half_width = 0.5f * house.width_m;
  const float half_depth = 0.5f * house.depth_m;
  const float right = glm::half_pi<float>();
  const int bays = std::max(1, int(house.width_m / 2.5f));
  add_facade(model, house, house.width_m, bays / 2, place({-half_width, 0.0f, half_depth}), random);
  add_facade(model, house, house.width_m, -1, place({half_width, 0.0f, -half_depth}, 2.0f * right), random);
  const float wall = kPlinth_m + kStorey_m * float(house.storeys);
  const float rise = half_depth * std::tan(glm::radians(house.pitch_deg));
  for (const float side : {1.0f, -1.0f}) {
    const glm::mat4 at = place({side * half_width, 0.0f, side * half_depth}, side * right);
    add_facade(model, house, house.depth_m, -1, at, random);
    Mesh gable;
    add_face(gable, {{0.0f, wall, 0.0f}, {house.depth_m, wall, 0.0f}, {half_depth, wall + rise, 0.0f}});
    append(part(model, house.brick != 0 ? "brick" : "plaster"), gable, at);
  }
  add_roof(model, house);
  return model;
}

}  // namespace litfog::scene
