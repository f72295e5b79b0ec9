// SPDX-License-Identifier: Apache-2.0
#include "browser/street.h"

#include <string>
#include <utility>

#include "scene/model/house.h"
#include "scene/model/road.h"
#include "scene/model/roadside.h"
#include "scene/model/street_life.h"
#include "scene/model/terrain.h"
#include "scene/model/tree.h"

namespace litfog::browser {
namespace {

using glm::vec3;

constexpr float kLampHeight = 8;  // metres
constexpr float kLampLight = kLampHeight - 0.15f;

/// A scene to which models and lamps are added.
class Builder {
 public:
  /// Places a model: `yaw_deg` counter-clockwise seen from above.
  void add(scene::Model model, std::initializer_list<std::pair<vec3, float>> places) {
    scene_.models.push_back(std::move(model));
    for (const auto& [position, yaw_deg] : places) {
      scene_.instances.push_back(
          {.model = scene_.models.size() - 1, .world_from_model = scene::place(position, glm::radians(yaw_deg))});
    }
  }

  void add(PlacedLight light, std::initializer_list<glm::dvec3> positions) {
    light.direction = glm::normalize(light.direction);
    for (const glm::dvec3& position : positions) {
      light.position = position;
      scene_.lights.push_back(light);
    }
  }

  scene::Scene& scene() { return scene_; }

 private:
  scene::Scene scene_;
};

void add_ground(Builder& builder) {
  builder.add(scene::make_ground({.width_m = 160,
                                  .depth_m = 180,
                                  .centre_z_m = -60,
                                  .cell_m = 5,
                                  .terrain = {.path = {.length_m = 200}, .relief_m = 0.5f, .corridor_m = 50}}),
              {{{0, 0, 0}, 0.0f}});
  const scene::Carriageway asphalt{.width_m = 8, .camber = 0, .path = {.length_m = 150}};
  builder.add(scene::make_road({.shoulder_m = 0.2f, .wet = 1, .carriageway = asphalt}), {{{0, 0, 12}, 0.0f}});
  builder.add(scene::make_road_markings({.carriageway = asphalt}), {{{0, 0, 12}, 0.0f}});
  builder.add(scene::make_zebra_crossing({.width_m = 7.6f, .length_m = 3.6f}), {{{0, 0, -20}, 0.0f}});
  builder.add(scene::make_block({.width_m = 3, .height_m = 0.6f, .depth_m = 150, .bevel_m = 0.02f}),
              {{{-5.6f, -0.47f, -63}, 0.0f}, {{5.6f, -0.47f, -63}, 0.0f}});
}

void add_surroundings(Builder& builder) {
  builder.add(scene::make_house({.width_m = 12, .storeys = 2, .brick = 1, .lit = 0.5f, .seed = 3}),
              {{{-12.5f, 0, -14}, 90.0f}, {{12.5f, 0, -52}, -90.0f}});
  builder.add(scene::make_house({.width_m = 11, .storeys = 3, .lit = 0.4f, .seed = 8}),
              {{{-12.5f, 0, -44}, 90.0f}, {{12.5f, 0, -24}, -90.0f}});
  builder.add(scene::make_broadleaf_tree({.height_m = 8, .leaves = 0.5f, .leaf_m = 0.22f, .forks = 2, .seed = 4}),
              {{{9.2f, 0, -9}, 0.0f}, {{-9.4f, 0, -29}, 70.0f}});
  builder.add(scene::make_car({.paint = 1, .number = 31}), {{{-3.0f, 0, -10}, 180.0f}});
  builder.add(scene::make_car({.paint = 3, .lights = 1, .number = 77}), {{{-1.9f, 0, -46}, 180.0f}});
  builder.add(scene::make_person({.coat = 4, .walks = 1}), {{{-0.6f, 0, -20.4f}, 90.0f}});
}

/// file  in data/lights, without its ending
Light named(const std::string& file) {
  Light light;
  light.name = file;
  return light;
}

/// The lamps, each kind with the models that carry it.
void add_lamps(Builder& builder) {
  builder.add({.light = named("headlight-spread"), .direction = {0.01, -0.03, -1}, .carried = true},
              {{1.3, 0.7, 0}, {2.6, 0.7, 0}});
  const scene::StreetLamp lamp{.height_m = kLampHeight, .sodium = 1};
  builder.add(scene::make_street_lamp(lamp), {{{-5.4f, 0.13f, -6}, 0.0f},
                                              {{-5.4f, 0.13f, -36}, 0.0f},
                                              {{-5.4f, 0.13f, -66}, 0.0f},
                                              {{5.4f, 0.13f, -21}, 180.0f},
                                              {{5.4f, 0.13f, -51}, 180.0f},
                                              {{5.4f, 0.13f, -81}, 180.0f}});
  const double x = 5.4 - double{lamp.arm_m};
  const double y = 0.13 + double{kLampLight};
  builder.add({.light = named("street-lamp"), .direction = {0, -1, 0}},
              {{-x, y, -6}, {-x, y, -36}, {-x, y, -66}, {x, y, -21}, {x, y, -51}, {x, y, -81}});
  builder.add({.light = named("headlight-lower"), .direction = {-0.01, -0.015, 1}},
              {{-2.48, 0.61, -43.75}, {-1.32, 0.61, -43.75}});
}

}  // namespace

scene::Scene make_street() {
  Builder builder;
  add_ground(builder);
  add_surroundings(builder);
  add_lamps(builder);
  scene::Scene scene = std::move(builder.scene());
  scene.name = "street";
  scene.camera = {.position = {1.7f, 1.55f, 1.2f}, .target = {0.2f, 2.3f, -30}, .field_of_view = glm::radians(50.0f)};
  scene.environment = {.ambient_light = {0.030f, 0.031f, 0.040f},
                       .sky_zenith = {0.0016f, 0.0020f, 0.0045f},
                       .sky_horizon = {0.0130f, 0.0115f, 0.0120f},
                       .star_brightness = 0.5f};
  scene.atmosphere = {.top = 60, .ambient_fog_color = glm::vec3(0.012f, 0.011f, 0.012f)};
  return scene;
}

}  // namespace litfog::browser
