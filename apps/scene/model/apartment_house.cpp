// SPDX-License-Identifier: Apache-2.0
#include "scene/model/house.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <string_view>

#include "scene/hash_random.h"
#include "scene/model/primitive.h"

namespace litfog::scene {
namespace {

constexpr float kGroundFloor_m = 4.2f;
constexpr float kStorey_m = 3.1f;
constexpr float kParapet_m = 0.9f;
constexpr float kBay_m = 2.6f;
constexpr float kFrameLift_m = 0.03f;  // before the wall
constexpr float kPaneLift_m = 0.07f;
constexpr float kBar_m = 0.08f;      // between the halves of a window
constexpr float kLitShops = 0.7f;    // fractions
constexpr float kDimWindows = 0.6f;  // fraction of the lit windows

/// One of the four walls, as it is seen from outside.
struct Facade {
  glm::mat4 house_from_wall;
  float width;
  int bays;
  bool has_shops;
};

std::vector<Facade> facades(const ApartmentHouse& house) {
  const float x = 0.5f * house.width_m;
  const float z = 0.5f * house.depth_m;
  const float right = glm::half_pi<float>();
  const auto bays = [](float width) { return std::max(1, int(width / kBay_m)); };
  return {{place({-x, 0, z}), house.width_m, bays(house.width_m), true},
          {place({x, 0, -z}, 2 * right), house.width_m, bays(house.width_m), false},
          {place({x, 0, z}, right), house.depth_m, bays(house.depth_m), false},
          {place({-x, 0, -z}, -right), house.depth_m, bays(house.depth_m), false}};
}

/// A pane on a wall, from (left, bottom) to (right, top).
struct Pane {
  float left, bottom, right, top;
  std::string_view material;
  bool is_shop;

  bool is_lit() const { return material != "glass"; }
};

/// Calls visit(facade, pane) for every pane of a house.
template <typename Visit>
void for_each_pane(const ApartmentHouse& house, const Visit& visit) {
  HashRandom random(std::uint32_t(house.seed));
  for (const Facade& facade : facades(house)) {
    const float bay = facade.width / float(facade.bays);
    for (int i = 0; i < facade.bays; ++i) {
      const float middle = bay * (float(i) + 0.5f);
      if (facade.has_shops) {
        const bool is_lit = random.unit() < kLitShops * std::min(1.0f, 2 * house.lit);
        visit(facade, Pane{middle - 0.5f * bay + 0.15f, 0.45f, middle + 0.5f * bay - 0.15f, 3.0f,
                           is_lit ? "window_lit" : "glass", true});
      }
      for (int storey = 0; storey < house.storeys; ++storey) {
        const float floor = kGroundFloor_m + kStorey_m * float(storey);
        const float draw = random.unit();
        const std::string_view material = draw >= house.lit                ? "glass"
                                          : draw < kDimWindows * house.lit ? "window_dim"
                                                                           : "window_lit";
        visit(facade, Pane{middle - 0.65f, floor + 0.8f, middle + 0.65f, floor + 2.4f, material, false});
      }
    }
  }
}

void add_pane(Model& model, const Pane& pane, float lift, const glm::mat4& house_from_wall) {
  Mesh face;
  add_face(face, {{pane.left, pane.bottom, lift},
                  {pane.right, pane.bottom, lift},
                  {pane.right, pane.top, lift},
                  {pane.left, pane.top, lift}});
  append(part(model, pane.material), face, house_from_wall);
}

}  // namespace

Model make_apartment_house(const ApartmentHouse& house) {
  Model model;
  const float top = kGroundFloor_m + kStorey_m * float(house.storeys) + kParapet_m;
  Mesh& walls = part(model, house.brick != 0 ? "brick" : "plaster");
  Mesh& bands = part(model, "stone");
  for (const Facade& facade : facades(house)) {
    const glm::mat4& at = facade.house_from_wall;
    Mesh wall;
    add_face(wall, {{0, -0.3f, 0}, {facade.width, -0.3f, 0}, {facade.width, top, 0}, {0, top, 0}});
    append(walls, wall, at);
    // Over the shops, below the windows of each storey, round the roof.
    add_box(bands, {0, 3.3f, 0}, {facade.width, 3.9f, 0.22f}, at);
    for (int storey = 0; storey < house.storeys; ++storey) {
      const float sill = kGroundFloor_m + kStorey_m * float(storey) + 0.62f;
      add_box(bands, {0, sill, 0}, {facade.width, sill + 0.14f, 0.12f}, at);
    }
    add_box(bands, {-0.3f, top - 0.5f, -0.3f}, {facade.width + 0.3f, top, 0.3f}, at);
  }
  for_each_pane(house, [&](const Facade& facade, const Pane& pane) {
    const Pane frame{pane.left - 0.1f,
                     pane.bottom - 0.04f,
                     pane.right + 0.1f,
                     pane.top + 0.1f,
                     pane.is_shop ? "stone" : "paint_white",
                     pane.is_shop};
    const float middle = 0.5f * (pane.left + pane.right);
    Pane left = pane;
    left.right = middle - 0.5f * kBar_m;
    Pane right = pane;
    right.left = middle + 0.5f * kBar_m;
    add_pane(model, frame, kFrameLift_m, facade.house_from_wall);
    add_pane(model, left, kPaneLift_m, facade.house_from_wall);
    add_pane(model, right, kPaneLift_m, facade.house_from_wall);
  });
  const glm::vec3 half{0.5f * house.width_m, 0, 0.5f * house.depth_m};
  Mesh& roof = part(model, "stone");
  const float level = top - kParapet_m;
  add_face(roof,
           {{-half.x, level, half.z}, {half.x, level, half.z}, {half.x, level, -half.z}, {-half.x, level, -half.z}});
  append(roof, make_box({0.2f * house.width_m, 2.6f, 0.25f * house.depth_m}),
         place({0.22f * house.width_m, level, -0.15f * house.depth_m}));
  return model;
}

std::vector<BrightPane> bright_panes(const ApartmentHouse& house) {
  std::vector<BrightPane> bright;
  for_each_pane(house, [&](const Facade& facade, const Pane& pane) {
    if (!pane.is_lit()) return;
    const glm::vec4 middle{0.5f * (pane.left + pane.right), 0.5f * (pane.bottom + pane.top), kPaneLift_m + 0.03f, 1};
    bright.push_back({glm::vec3(facade.house_from_wall * middle), glm::vec3(facade.house_from_wall[2]), pane.is_shop});
  });
  return bright;
}

}  // namespace litfog::scene
