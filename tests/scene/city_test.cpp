// SPDX-License-Identifier: Apache-2.0
#include "scene/model/city.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "core/value_errors.h"
#include "litfog/input_error.h"
#include "scene/file/scene_file.h"
#include "scene/model/house.h"

namespace litfog::test {
using namespace scene;

namespace {

City named_city(std::size_t lights) {
  City city;
  city.lights = lights;
  city.street_lamp.name = "street lamp";
  city.headlight.name = "headlight";
  city.tail_lamp.name = "tail lamp";
  city.shop_window.name = "shop";
  city.window.name = "window";
  city.runway_edge.name = "runway edge";
  city.approach_light.name = "approach";
  return city;
}

Scene make(std::size_t lights, std::uint32_t seed = 1) {
  Scene scene;
  City city = named_city(lights);
  city.seed = seed;
  add_city(scene, city);
  return scene;
}

bool is_same(const PlacedLight& a, const PlacedLight& b) {
  return a.light.name == b.light.name && a.position == b.position && a.direction == b.direction;
}

TEST(City, LightsAreTheFirstOfOneList) {
  const Scene all = make(kMaxCityLights);
  ASSERT_EQ(all.lights.size(), kMaxCityLights);
  for (const std::size_t count : {1u, 100u, 10'000u}) {
    const Scene some = make(count);
    ASSERT_EQ(some.lights.size(), count);
    EXPECT_TRUE(std::ranges::equal(some.lights, std::span(all.lights).first(count), is_same));
    EXPECT_EQ(some.instances.size(), all.instances.size());
  }
}

TEST(City, WindowsComeLast) {
  const Scene scene = make(kMaxCityLights);
  const auto is_window = [](const PlacedLight& light) { return light.light.name == "window"; };
  EXPECT_TRUE(std::ranges::is_partitioned(scene.lights, [&](const PlacedLight& light) { return !is_window(light); }));
  for (const char* name : {"street lamp", "headlight", "tail lamp", "shop", "window", "runway edge", "approach"}) {
    const auto count =
        std::ranges::count_if(scene.lights, [&](const PlacedLight& light) { return light.light.name == name; });
    EXPECT_GT(count, 30) << name;
  }
}

TEST(City, SameSeedMakesTheSameCityAndAnotherAnother) {
  const Scene first = make(5000);
  const Scene again = make(5000);
  EXPECT_TRUE(std::ranges::equal(first.lights, again.lights, is_same));
  EXPECT_TRUE(std::ranges::equal(first.instances, again.instances, [](const Instance& a, const Instance& b) {
    return a.model == b.model && a.world_from_model == b.world_from_model;
  }));
  EXPECT_FALSE(std::ranges::equal(first.lights, make(5000, 2).lights, is_same));
}

TEST(City, LampsOfAHouseLeaveItsBrightPanes) {
  const ApartmentHouse house{.lit = 0.5f, .seed = 3};
  const auto panes = bright_panes(house);
  EXPECT_TRUE(std::ranges::any_of(panes, &BrightPane::is_shop));
  EXPECT_FALSE(std::ranges::all_of(panes, &BrightPane::is_shop));
  const Model model = make_apartment_house(house);
  std::size_t triangles = 0;  // in bright panes: four a pane
  for (const Part& part : model) {
    if (part.material == "window_lit" || part.material == "window_dim") triangles += part.mesh.indices.size() / 3;
  }
  EXPECT_EQ(triangles, 4 * panes.size());
  for (const BrightPane& pane : panes) {
    const bool is_front = pane.normal.z > 0.5f;
    EXPECT_TRUE(!pane.is_shop || is_front);
    const glm::vec3 half{0.5f * house.width_m, 100, 0.5f * house.depth_m};
    EXPECT_TRUE(glm::any(glm::greaterThan(glm::abs(pane.position), half)));  // before the wall
  }
  EXPECT_TRUE(bright_panes(ApartmentHouse{.lit = 0, .seed = 3}).empty());
}

TEST(City, SceneFileMayHaveACityAlone) {
  EXPECT_EQ(read_scene(bundled_scene_path("city")).lights.size(), 400u);
  EXPECT_EQ(read_scene(bundled_scene_path("city"), 20'000).lights.size(), 20'000u);
  EXPECT_TRUE(read_scene(bundled_scene_path("city"), 10).has_city);
  EXPECT_FALSE(read_scene(bundled_scene_path("room"), 10).has_city);
}

TEST(City, LightsWithoutWhichItShinesMoveNoOther) {
  const std::string path = bundled_scene_path("city");
  const Scene all = read_scene(path, 10);
  const Scene scene = read_scene(path, 10, {{"city.without", "[9, 0, 3, 3, 50]"}});
  EXPECT_EQ(scene.city_without, (std::set<std::size_t>{0, 3, 9, 50}));
  ASSERT_EQ(scene.lights.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i) {
    const std::size_t k = i < 2 ? i + 1 : i + 2;
    EXPECT_TRUE(is_same(scene.lights[i], all.lights[k])) << i;
    EXPECT_EQ(scene.light_entries[i], all.light_entries[k]) << i;
  }
  const auto error = [&](const std::string& without) {
    return sentence_of<InputError>([&] { read_scene(path, 10, {{"city.without", without}}); });
  };
  EXPECT_EQ(error("[1.5]"), "--set: city.without[0] = 1.5: must be a whole number");
  EXPECT_EQ(error("[100000]"), "--set: city.without[0] = 100000: must be in [0, 99999]");
}

}  // namespace
}  // namespace litfog::test
