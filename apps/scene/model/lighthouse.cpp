// SPDX-License-Identifier: Apache-2.0
#include "scene/model/coast.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <iterator>
#include <vector>

#include "scene/model/primitive.h"

namespace litfog::scene {

Model make_lighthouse(const Lighthouse& lighthouse) {
  constexpr int kSides = 28;
  constexpr int kMullions = 10;
  const float deck = lighthouse.height_m - 1.9f;
  const auto radius = [&](float y) { return glm::mix(1.5f + 0.06f * lighthouse.height_m, 1.7f, y / deck); };
  Model model;
  // The wall in bands, each a ring of its own colour.
  const float bands[] = {-0.5f, 0.36f * deck, 0.66f * deck, deck - 0.4f};
  for (std::size_t i = 0; i + 1 < std::size(bands); ++i) {
    append(part(model, i == 1 ? "paint_red" : "paint_white"),
           make_lathe({{radius(bands[i]), bands[i]}, {radius(bands[i + 1]), bands[i + 1]}}, kSides));
  }
  append(part(model, "paint_green"), make_bevelled_box({1.0f, 2.1f, 0.3f}, 0.02f), place({0.0f, 0.0f, radius(1.0f)}));
  for (const float level : {0.24f, 0.5f, 0.78f}) {
    append(part(model, lighthouse.lit != 0 ? "window_lit" : "glass"), make_box({0.5f, 0.9f, 0.1f}),
           place({0.0f, level * deck, radius(level * deck)}));
  }
  // The gallery and its rail.
  append(part(model, "concrete"),
         make_lathe({{1.6f, deck - 0.6f}, {2.6f, deck - 0.2f}, {2.6f, deck}, {0.0f, deck}}, kSides));
  Mesh& steel = part(model, "paint_grey");
  std::vector<glm::vec3> rail;
  for (int i = 0; i <= kSides; ++i) {
    const float turn = glm::two_pi<float>() * float(i) / kSides;
    rail.emplace_back(2.5f * std::sin(turn), deck + 1.05f, 2.5f * std::cos(turn));
    if (i % 2 == 1) append(steel, make_cylinder({0.02f, 0.02f, 1.05f, 6}), place(rail.back() - glm::vec3(0, 1.05f, 0)));
  }
  append(steel, make_tube(rail, 0.025f, 6));
  // The lantern: a parapet, mullions without panes, so that nothing is before the lens, and a roof.
  append(part(model, "paint_white"), make_lathe({{1.4f, deck}, {1.4f, deck + 0.9f}, {0.0f, deck + 0.9f}}, kSides));
  for (int i = 0; i < kMullions; ++i) {
    const float turn = glm::two_pi<float>() * (float(i) + 0.5f) / kMullions;
    const glm::vec3 foot(1.36f * std::sin(turn), deck + 0.85f, 1.36f * std::cos(turn));
    append(steel, make_beam(foot, foot + glm::vec3(0.0f, 2.1f, 0.0f), 0.06f, 0.06f,
                            glm::normalize(glm::vec3(foot.x, 0, foot.z))));
  }
  append(part(model, "paint_red"), make_lathe({{0.0f, deck + 2.9f},
                                               {1.6f, deck + 2.9f},
                                               {1.6f, deck + 3.0f},
                                               {0.9f, deck + 3.6f},
                                               {0.15f, deck + 4.0f},
                                               {0.15f, deck + 4.3f},
                                               {0.0f, deck + 4.35f}},
                                              kSides));
  // The lens is slender: its light is within 0.1 m of its face from all sides.
  append(steel, make_cylinder({0.2f, 0.12f, 0.7f, 12}), place({0.0f, deck + 0.9f, 0.0f}));
  append(part(model, lighthouse.lit != 0 ? "lamp_white" : "glass"), make_cylinder({0.09f, 0.09f, 0.6f, 12}),
         place({0.0f, deck + 1.6f, 0.0f}));
  return model;
}

}  // namespace litfog::scene
