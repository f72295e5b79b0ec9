// SPDX-License-Identifier: Apache-2.0
#include "scene/model/city.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "scene/hash_random.h"
#include "scene/model/house.h"
#include "scene/model/model_catalogue.h"
#include "scene/model/primitive.h"

namespace litfog::scene {
namespace {

// Metres.
constexpr float kPitch = 90;  // from street to street
constexpr int kBlocksFromMiddle = 7;
constexpr float kEdge = kPitch * kBlocksFromMiddle;
constexpr float kCarriageway = 12;
constexpr float kPavement = 5.5f;
constexpr float kKerb = 0.13f;
constexpr float kLampHeight = 8;
constexpr float kLampArm = 1.8f;
constexpr float kLampSpacing = 30;
constexpr float kHouseDepth = 14;
constexpr float kRunway = kEdge + 170;  // x of its centre line
constexpr float kRunwayLength = 1000;

struct Lamp {
  PlacedLight light;
  std::size_t kind;  // in kCityLightKinds
  bool is_window;
};

/// A square slab in tiles.
Model make_pavement(float side) {
  constexpr int kTiles = 5;
  const float tile = side / kTiles;
  Mesh slab;
  for (int i = 0; i < kTiles; ++i) {
    for (int k = 0; k < kTiles; ++k) {
      const float x = tile * float(i) - 0.5f * side;
      const float z = tile * float(k) - 0.5f * side;
      add_face(slab, {{x, kKerb, z + tile}, {x + tile, kKerb, z + tile}, {x + tile, kKerb, z}, {x, kKerb, z}});
    }
  }
  for (int turn = 0; turn < 4; ++turn) {
    const float half = 0.5f * side;
    Mesh kerb;
    add_face(kerb, {{-half, 0, half}, {half, 0, half}, {half, kKerb, half}, {-half, kKerb, half}});
    append(slab, kerb, place({0, 0, 0}, float(turn) * glm::half_pi<float>()));
  }
  return {{"concrete_slabs", slab}};
}

class CityBuilder {
 public:
  CityBuilder(Scene& scene, const City& city) : scene_(scene), city_(city), random_(city.seed) {
    add_ground();
    for (int i = -kBlocksFromMiddle; i < kBlocksFromMiddle; ++i) {
      for (int k = -kBlocksFromMiddle; k < kBlocksFromMiddle; ++k) {
        add_block({(float(i) + 0.5f) * kPitch, 0, (float(k) + 0.5f) * kPitch});
      }
    }
    for (int i = -kBlocksFromMiddle; i <= kBlocksFromMiddle; ++i) {
      for (const float heading : {0.0f, glm::half_pi<float>()}) {
        for (int k = -kBlocksFromMiddle; k < kBlocksFromMiddle; ++k) {
          add_street(place({0, 0, 0}, heading) * place({float(i) * kPitch, 0, (float(k) + 0.5f) * kPitch}));
        }
      }
    }
    add_airfield();
  }

  void add_lights() {
    if (city_.lights > lamps_.size()) {
      throw std::invalid_argument("lights: must be at most " + std::to_string(lamps_.size()) + ", the city's");
    }
    std::ranges::stable_sort(
        lamps_, {}, [](const Lamp& lamp) { return std::pair(lamp.is_window, glm::length(lamp.light.position)); });
    const std::size_t first_kind = scene_.light_members.size();
    for (const CityLightKind& kind : kCityLightKinds) scene_.light_members.push_back(std::string("city.") + kind.name);
    for (std::size_t i = 0; i < city_.lights; ++i) {
      if (city_.without.contains(i)) continue;
      scene_.lights.push_back(lamps_[i].light);
      scene_.light_entries.push_back(first_kind + lamps_[i].kind);
    }
  }

 private:
  std::size_t catalogue_model(const std::string& name, const ModelParameters& parameters = {}) {
    std::string key = name;
    for (const auto& [parameter, value] : parameters) key += " " + parameter + "=" + std::to_string(value);
    return model(key, [&] { return make_model(name, parameters); });
  }
  /// The model of a key, made if new.
  template <typename Make>
  std::size_t model(const std::string& key, const Make& make) {
    const auto [entry, is_new] = models_.try_emplace(key, scene_.models.size());
    if (is_new) scene_.models.push_back(make());
    return entry->second;
  }
  void add(std::size_t model, const glm::mat4& world_from_model) {
    scene_.instances.push_back({model, world_from_model});
  }

  void add_lamp(Light City::*light, const glm::mat4& world_from_model, const glm::vec3& position,
                const glm::vec3& direction, bool is_window = false) {
    const glm::dvec3 at(world_from_model * glm::vec4(position, 1));
    const glm::dvec3 axis = glm::normalize(glm::dvec3(glm::mat3(world_from_model) * direction));
    const auto kind =
        std::size_t(std::ranges::find(kCityLightKinds, light, &CityLightKind::light) - kCityLightKinds.begin());
    lamps_.push_back({{.light = city_.*light, .position = at, .direction = axis}, kind, is_window});
  }

  void add_ground() {
    const auto add_plane = [&](const std::string& material, float low_x, float high_x, float half_z, float height) {
      constexpr float kTile = 20;  // metres; few lamps reach each tile
      Mesh plane;
      for (float x = low_x; x < high_x; x += kTile) {
        for (float z = -half_z; z < half_z; z += kTile) {
          add_face(plane,
                   {{x, height, z + kTile}, {x + kTile, height, z + kTile}, {x + kTile, height, z}, {x, height, z}});
        }
      }
      add(model(material + " ground", [&] { return Model{{material, plane}}; }), place({0, 0, 0}));
    };
    add_plane("wet_asphalt", -kEdge - kPitch, kEdge + kPitch, kEdge + kPitch, 0);
    add_plane("grass", kEdge + kPitch, kEdge + 5 * kPitch, kEdge + 4 * kPitch, 0);
  }

  /// Houses around a yard, on a pavement.
  void add_block(const glm::vec3& middle) {
    const float side = kPitch - kCarriageway;
    add(model("pavement", [&] { return make_pavement(side); }), place(middle));
    const float built = side - 2 * kPavement;
    const float from_middle = 0.5f * (built - kHouseDepth);
    for (int turn = 0; turn < 4; ++turn) {
      const glm::mat4 at = place(middle, float(turn) * glm::half_pi<float>());
      // Two sides take the corners.
      const bool has_corners = turn % 2 == 0;
      const int houses = has_corners ? 3 : 2;
      const float width = (has_corners ? built : built - 2 * kHouseDepth) / float(houses);
      for (int i = 0; i < houses; ++i) {
        const float x = width * (float(i) + 0.5f) - 0.5f * width * float(houses);
        add_house(at * place({x, kKerb, from_middle}), width, glm::length(middle));
      }
    }
  }

  void add_house(const glm::mat4& at, float width, float from_origin) {
    const int storeys = 2 + int(5 * std::exp(-from_origin / 350) + random_.between(0, 3));
    const ApartmentHouse house{.width_m = width,
                               .depth_m = kHouseDepth,
                               .storeys = storeys,
                               .brick = int(random_.between(0, 2)),
                               .lit = 0.5f,
                               .seed = 1 + int(random_.between(0, 4))};
    const std::string key = "house " + std::to_string(width) + " " + std::to_string(storeys) + " " +
                            std::to_string(house.brick) + " " + std::to_string(house.seed);
    add(model(key, [&] { return make_apartment_house(house); }), at);
    const auto [panes, is_new] = panes_.try_emplace(key);
    if (is_new) panes->second = bright_panes(house);
    for (const BrightPane& pane : panes->second) {
      add_lamp(pane.is_shop ? &City::shop_window : &City::window, at, pane.position, pane.normal, !pane.is_shop);
    }
  }

  /// A street from one crossing to the next, along Z.
  void add_street(const glm::mat4& at) {
    const float length = kPitch - kCarriageway;
    const float kerb = 0.5f * kCarriageway;
    add(catalogue_model("road_markings", {{"width_m", kCarriageway}, {"camber", 0}, {"length_m", length - 12}}),
        at * place({0, 0, 0.5f * length - 6}));
    for (const float end : {-1.0f, 1.0f}) {
      add(catalogue_model("zebra_crossing", {{"width_m", kCarriageway - 0.4}, {"length_m", 3}}),
          at * place({0, 0, end * (0.5f * length - 2.5f)}));
    }
    for (int i = 0; i < int(kPitch / kLampSpacing); ++i) {
      const float right = i % 2 == 0 ? 1.0f : -1.0f;
      const glm::mat4 foot = at * place({right * (kerb + 0.6f), kKerb, (float(i) - 1) * kLampSpacing},
                                        right > 0 ? glm::pi<float>() : 0.0f);
      add(catalogue_model("street_lamp", {{"height_m", kLampHeight}, {"arm_m", kLampArm}, {"sodium", 1}}), foot);
      add_lamp(&City::street_lamp, foot, {kLampArm, kLampHeight - 0.15f, 0}, {0, -1, 0});
    }
    for (const float lane : {1.0f, -1.0f}) {
      const float heading = lane > 0 ? 0.0f : glm::pi<float>();
      if (random_.unit() < 0.5f) add_car(at * place({lane * 1.8f, 0, random_.between(-28, 28)}, heading), true);
      if (random_.unit() < 0.5f) add_car(at * place({lane * 4.8f, 0, random_.between(-26, 26)}, heading), false);
      if (random_.unit() < 0.35f) {
        const float turn = random_.unit() < 0.5f ? 0.0f : glm::pi<float>();
        const float x = lane * (kerb + random_.between(1.5f, 4));
        const float z = random_.between(-38, 38);
        const float coat = std::floor(random_.between(0, 5));
        add(catalogue_model("person", {{"coat", coat}, {"walks", 1}}), at * place({x, kKerb, z}, turn));
      }
    }
  }

  void add_car(const glm::mat4& at, bool is_driven) {
    add(catalogue_model("car", {{"paint", std::floor(random_.between(0, 5))}, {"lights", is_driven ? 1 : 0}}), at);
    if (!is_driven) return;
    for (const float side : {-1.0f, 1.0f}) {
      add_lamp(&City::headlight, at, {side * 0.58f, 0.61f, -2.25f}, {side * 0.01f, -0.015f, -1});
      add_lamp(&City::tail_lamp, at, {side * 0.7f, 0.8f, 2.2f}, {0, 0, 1});
    }
  }

  /// A runway whose threshold is at the south, with what an approach from there sees.
  void add_airfield() {
    const glm::mat4 threshold = place({kRunway, 0.02f, 0.5f * kRunwayLength});
    add(catalogue_model("runway", {{"length_m", kRunwayLength}, {"number", 36}}), threshold);
    const glm::vec3 to_approach{0, 0.05f, 1};
    for (float z = 0; z <= kRunwayLength; z += 60) {
      for (const float side : {-1.0f, 1.0f}) {
        const glm::mat4 at = threshold * place({side * 24.0f, 0, -z});
        add(catalogue_model("edge_light"), at);
        add_lamp(&City::runway_edge, at, {0, 0.33f, 0}, to_approach);
      }
    }
    for (float z = 30; z <= 420; z += 30) {
      const glm::mat4 at = threshold * place({0, 0, z});
      add(catalogue_model("approach_light", {{"height_m", 1}}), at);
      for (int i = -2; i <= 2; ++i) add_lamp(&City::approach_light, at, {float(i), 1, 0}, to_approach);
    }
    const float apron = kRunway - 75;
    for (int i = 0; i < 3; ++i) {
      add(catalogue_model("hangar"), place({apron, 0, 40 - 45 * float(i)}, glm::half_pi<float>()));
    }
    add(catalogue_model("tower", {{"height_m", 24}}), place({apron, 0, 90}, glm::half_pi<float>()));
  }

  Scene& scene_;
  const City& city_;
  HashRandom random_;
  std::map<std::string, std::size_t> models_;
  std::map<std::string, std::vector<BrightPane>> panes_;  // by the house's key
  std::vector<Lamp> lamps_;
};

}  // namespace

void add_city(Scene& scene, const City& city) { CityBuilder(scene, city).add_lights(); }

}  // namespace litfog::scene
