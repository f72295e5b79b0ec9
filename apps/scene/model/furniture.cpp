// SPDX-License-Identifier: Apache-2.0
#include "scene/model/room.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/hash_random.h"
#include "scene/model/primitive.h"

namespace litfog::scene {
Model make_crate(const Crate& crate) {
  Model model;
  Mesh& wood = part(model, "wood");
  const float s = crate.size_m;
  const float board = 0.11f * s;
  const float thick = 0.03f * s;
  append(wood, make_box(glm::vec3(s - 2.0f * thick)), place({0.0f, thick, 0.0f}));
  // The same frame with a brace on all six sides.
  const auto side = [&](const glm::mat4& at) {
    const float edge = 0.5f * (s - board);
    for (const float end : {-edge, edge}) {
      append(wood, make_beam({end, -0.5f * s, 0.0f}, {end, 0.5f * s, 0.0f}, board, thick, glm::vec3(0, 0, 1)), at);
      append(wood,
             make_beam({-0.5f * s + board, end, 0.0f}, {0.5f * s - board, end, 0.0f}, board, thick, glm::vec3(0, 0, 1)),
             at);
    }
    const float corner = 0.5f * s - board;
    append(wood,
           make_beam({-corner, -corner, 0.0f}, {corner, corner, 0.0f}, 0.8f * board, 0.8f * thick, glm::vec3(0, 0, 1)),
           at);
  };
  const glm::mat4 middle = place({0.0f, 0.5f * s, 0.0f});
  const glm::vec3 out(0.0f, 0.0f, 0.5f * (s - thick));
  // Frames meet along the edges: each of the three pairs is a little smaller than the last, so that none lie in one
  // plane.
  constexpr float kSmaller = 0.003f;
  for (int i = 0; i < 4; ++i) {
    const glm::mat4 turned = glm::rotate(middle, glm::half_pi<float>() * float(i), glm::vec3(0, 1, 0));
    const glm::vec3 scale(1.0f - kSmaller * float(i % 2));
    side(glm::translate(glm::scale(turned, scale), out));
  }
  for (const float up : {-1.0f, 1.0f}) {
    const glm::mat4 turned = glm::rotate(middle, up * glm::half_pi<float>(), glm::vec3(1, 0, 0));
    side(glm::translate(glm::scale(turned, glm::vec3(1.0f - 2.0f * kSmaller)), out));
  }
  return model;
}

Model make_barrel(const Barrel& barrel) {
  Model model;
  const float h = barrel.height_m;
  const auto radius = [&](float t) { return h * (0.28f + 0.24f * t * (1.0f - t)); };
  std::vector<glm::vec2> profile{{0.0f, 0.0f}, {radius(0.0f), 0.0f}};
  for (int i = 1; i <= 10; ++i) profile.emplace_back(radius(0.1f * float(i)), 0.1f * h * float(i));
  profile.emplace_back(radius(1.0f) - 0.03f * h, h);
  profile.emplace_back(radius(1.0f) - 0.03f * h, 0.95f * h);
  profile.emplace_back(0.0f, 0.95f * h);
  append(part(model, "wood"), make_lathe(profile, 24));
  for (const float t : {0.02f, 0.22f, 0.72f, 0.92f}) {
    const float low = radius(t) + 0.006f * h;
    const float high = radius(t + 0.06f) + 0.006f * h;
    append(part(model, "galvanised"),
           make_lathe(
               {{low - 0.006f * h, t * h}, {low, t * h}, {high, (t + 0.06f) * h}, {high - 0.006f * h, (t + 0.06f) * h}},
               24));
  }
  return model;
}

Model make_dining_table(const DiningTable& table) {
  Model model;
  Mesh& wood = part(model, "wood_floor");
  const float x = 0.5f * table.length_m - 0.08f;
  const float z = 0.5f * table.width_m - 0.08f;
  const float under = table.height_m - 0.04f;
  append(wood, make_bevelled_box({table.width_m, 0.04f, table.length_m}, 0.008f),
         place({0.0f, under, 0.0f}, glm::half_pi<float>()));
  for (const float sx : {-x, x}) {
    for (const float sz : {-z, z})
      append(wood, make_bevelled_box({0.07f, under, 0.07f}, 0.006f), place({sx, 0.0f, sz}));
    append(wood, make_beam({sx, under - 0.05f, -z}, {sx, under - 0.05f, z}, 0.022f, 0.1f));
  }
  for (const float sz : {-z, z}) append(wood, make_beam({-x, under - 0.05f, sz}, {x, under - 0.05f, sz}, 0.022f, 0.1f));
  return model;
}

Model make_chair(const Chair& chair) {
  Model model;
  Mesh& wood = part(model, "wood_floor");
  const float seat = chair.seat_m;
  const float reach = 0.18f;
  append(wood, make_bevelled_box({0.42f, 0.035f, 0.42f}, 0.01f), place({0.0f, seat - 0.035f, 0.0f}));
  for (const float x : {-reach, reach}) {
    append(wood, make_bevelled_box({0.04f, seat - 0.035f, 0.04f}, 0.005f), place({x, 0.0f, -reach}));
    append(wood, make_beam({x, 0.0f, reach}, {x, seat, reach}, 0.04f, 0.04f, glm::vec3(0, 0, 1)));
    append(wood, make_beam({x, seat, reach}, {x, 2.05f * seat, reach + 0.07f}, 0.04f, 0.03f, glm::vec3(0, 0, 1)));
    append(wood, make_beam({x, 0.4f * seat, -reach}, {x, 0.4f * seat, reach}, 0.02f, 0.035f));
  }
  for (const float level : {1.35f, 1.65f, 1.92f}) {
    const float z = reach + 0.07f * (level - 1.0f) / 1.05f;
    append(wood, make_beam({-reach, level * seat, z}, {reach, level * seat, z}, 0.018f, level > 1.9f ? 0.09f : 0.05f));
  }
  append(wood, make_beam({-reach, 0.55f * seat, -reach}, {reach, 0.55f * seat, -reach}, 0.02f, 0.035f));
  return model;
}

Model make_shelf(const Shelf& shelf) {
  HashRandom random(std::uint32_t(shelf.seed));
  Model model;
  Mesh& wood = part(model, "wood_floor");
  constexpr float kDepth_m = 0.3f;
  constexpr float kBoard_m = 0.025f;
  const float half = 0.5f * shelf.width_m;
  for (const float x : {-half, half})
    append(wood, make_box({kBoard_m, shelf.height_m, kDepth_m}), place({x, 0.0f, 0.5f * kDepth_m}));
  append(part(model, "wood"), make_box({shelf.width_m, shelf.height_m, 0.008f}), place({0.0f, 0.0f, 0.004f}));
  const int boards = std::max(2, int(shelf.height_m / 0.37f));
  const float pitch = (shelf.height_m - 0.1f - kBoard_m) / float(boards);
  constexpr std::string_view kCovers[] = {"paint_red",   "paint_green", "paint_blue", "paint_grey",
                                          "paint_black", "paint_white", "wood"};
  for (int i = 0; i <= boards; ++i) {
    const float level = 0.08f + pitch * float(i);
    append(wood, make_beam({-half + 0.5f * kBoard_m, level + 0.5f * kBoard_m, 0.5f * kDepth_m},
                           {half - 0.5f * kBoard_m, level + 0.5f * kBoard_m, 0.5f * kDepth_m}, kDepth_m, kBoard_m));
    if (i == boards) break;
    const float end = -half + 0.03f + shelf.books * (shelf.width_m - 0.06f) * random.between(0.8f, 1.0f);
    for (float x = -half + 0.03f; x < end;) {
      const float thick = random.between(0.02f, 0.05f);
      const float height = std::min(pitch - 0.06f, random.between(0.18f, 0.29f));
      const float depth = random.between(0.15f, 0.22f);
      const std::string_view cover = kCovers[random.bits() % std::size(kCovers)];
      if (x + thick > half - 0.03f) break;
      append(part(model, cover), make_box({thick - 0.001f, height, depth}),
             place({x + 0.5f * thick, level + kBoard_m, 0.26f - 0.5f * depth}));
      x += thick;
    }
  }
  return model;
}

}  // namespace litfog::scene
