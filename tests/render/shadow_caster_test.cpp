// SPDX-License-Identifier: Apache-2.0
#include "render/shadow/shadow_caster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "litfog/light_bounds.h"
#include "reference/random_light.h"
#include "render/light/scene_lights.h"

namespace litfog::test {
using namespace render;

namespace {

constexpr scene::Bounds kBox{{-40, -1, -40}, {40, 20, 40}};
constexpr int kMapSize = 512;

PlacedLight lamp(const Cone& cone, const glm::dvec3& position, double brightness, bool is_carried = false) {
  PlacedLight placed;
  placed.light = {.name = "lamp", .color = glm::dvec3(brightness), .attenuation = {1, 0, 0.01}, .cone = cone};
  placed.position = position;
  placed.direction = glm::normalize(glm::dvec3(0.2, -1, 0.1));
  placed.carried = is_carried;
  return placed;
}

std::vector<std::size_t> chosen(const scene::Scene& scene, const glm::dvec3& eye, std::size_t most) {
  const SceneLights lights(scene, {});
  std::vector<std::size_t> found;
  for (const ShadowCaster& caster : choose_shadow_casters(lights, kBox, eye, most, kMapSize)) {
    found.push_back(caster.scene_light);
  }
  return found;
}

TEST(ShadowCaster, CarriedLampsComeFirstThenTheBrightestFromTheEye) {
  scene::Scene scene;
  scene.lights = {lamp({}, {0, 5, 30}, 1), lamp({}, {0, 5, 10}, 1),       lamp({}, {0, 5, 10}, 0),
                  lamp({}, {0, 5, 30}, 9), lamp({}, {0, 1, 39}, 1, true), lamp({}, {0, 5, -30}, 0.9)};
  EXPECT_EQ(chosen(scene, {0, 2, 0}, 9), (std::vector<std::size_t>{4, 3, 1, 0, 5}));
  EXPECT_EQ(chosen(scene, {0, 2, 0}, 2), (std::vector<std::size_t>{4, 3}));
  EXPECT_EQ(chosen(scene, {0, 2, -30}, 3), (std::vector<std::size_t>{4, 5, 3}));
}

// Each direction into which a lamp sends light is in the part of space of one of its maps.
TEST(ShadowCaster, MapsOfALampCoverItsCone) {
  Random random(7);
  int tested = 0;
  for (const double degrees : {3.0, 30.0, 59.0, 61.0, 89.0, 110.0, 124.0, 126.0, 180.0}) {
    scene::Scene scene;
    const double half_angle = degrees / 180 * std::numbers::pi;
    scene.lights = {lamp(Cone::smoothstep(0, half_angle), {1, 4, 2}, 1)};
    const SceneLights lights(scene, {});
    const ShadowCaster caster = choose_shadow_casters(lights, kBox, {}, 1, kMapSize).at(0);
    EXPECT_EQ(caster.map_count, degrees < 60 ? 1 : degrees < 125 ? 5 : 6) << degrees;
    EXPECT_EQ(caster.is_cube, degrees > 60) << degrees;
    EXPECT_LE(caster.half_size, 1.75) << degrees;
    for (int i = 0; i < 4000; ++i) {
      const glm::dvec3 direction = draw_direction(random);
      if (glm::dot(direction, scene.lights[0].direction) < std::cos(half_angle)) continue;
      const glm::vec3 place = glm::vec3(caster.position + 0.9 * caster.reach * direction);
      bool is_seen = false;
      for (int map = 0; map < caster.map_count; ++map) {
        is_seen = is_seen || can_light(bounds_of_map(caster, map), place, place);
      }
      EXPECT_TRUE(is_seen) << degrees;
      ++tested;
    }
  }
  EXPECT_GT(tested, 9000);
}

TEST(ShadowCaster, MapsOfACubeLookAheadRightLeftUpDownAndBehind) {
  scene::Scene scene;
  scene.lights = {lamp({}, {1, 4, 2}, 1)};
  scene.lights[0].direction = {0, 0, -1};
  const SceneLights lights(scene, {});
  const ShadowCaster caster = choose_shadow_casters(lights, kBox, {}, 1, kMapSize).at(0);
  const std::vector<glm::dvec3> directions{{0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  ASSERT_EQ(std::size_t(caster.map_count), directions.size());
  for (int map = 0; map < caster.map_count; ++map) {
    EXPECT_LT(glm::distance(bounds_of_map(caster, map).direction, directions[std::size_t(map)]), 1e-12) << map;
  }
}

TEST(ShadowCaster, ReachEndsWithTheSceneWhereALightHasNoEnd) {
  scene::Scene scene;
  scene.lights = {lamp({}, {40, 20, 40}, 1), lamp({}, {0, 0, 0}, 0.5)};
  scene.lights[0].light.attenuation = {1, 0, 0};
  const SceneLights lights(scene, {});
  const auto casters = choose_shadow_casters(lights, kBox, {}, 2, kMapSize);
  EXPECT_DOUBLE_EQ(casters.at(0).reach, std::sqrt(80 * 80 + 21 * 21 + 80 * 80));
  EXPECT_DOUBLE_EQ(casters.at(1).reach, lights.extents()[1]);
}

}  // namespace

}  // namespace litfog::test
