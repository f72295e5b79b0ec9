// SPDX-License-Identifier: Apache-2.0
#include "render/shadow/moon_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace litfog::test {
using namespace render;

namespace {

constexpr scene::Bounds kBox{{-300, -5, -800}, {250, 60, 40}};

scene::Scene moonlit_scene() {
  scene::Scene scene;
  scene.camera = {.position = {10, 2, 5}, .target = {30, 1, -90}, .field_of_view = 0.9f};
  scene.environment.moon_direction = glm::normalize(glm::vec3(-0.4f, 0.5f, -0.3f));
  scene.environment.moon_color = glm::vec3(0.1f);
  return scene;
}

glm::dvec3 place_in(const MoonMap& map, const glm::dvec3& position) {
  return map.frame_from_world * (position - map.position);
}

TEST(MoonMap, SceneWithoutMoonHasNone) {
  scene::Scene scene = moonlit_scene();
  scene.environment.moon_color = glm::vec3(0);
  EXPECT_TRUE(fit_moon_maps(scene.environment, scene.camera, kBox, 1.5, 512).empty());
}

// Each map shows the camera's picture up to a quarter of the next one's distance, with a rim of two texels.
TEST(MoonMap, MapsShowWhatTheCameraSees) {
  constexpr double kAspect = 16 / 9.;
  constexpr int kSize = 512;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform;
  for (const float field_of_view : {0.1f, 0.9f, 2.0f}) {
    scene::Scene scene = moonlit_scene();
    scene.camera.field_of_view = field_of_view;
    const glm::dvec3 eye = scene.camera.position;
    const std::vector<MoonMap> maps = fit_moon_maps(scene.environment, scene.camera, kBox, kAspect, kSize);
    ASSERT_EQ(maps.size(), std::size_t(kMoonMaps));
    double distance = std::hypot(310, 58, 805);  // to the box's farthest corner
    for (std::size_t i = maps.size(); i-- > 0; distance /= 4) {
      const glm::dvec3 forward = glm::normalize(glm::dvec3(scene.camera.target) - eye);
      const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
      const glm::dvec3 up = glm::cross(right, forward);
      const double slope = std::tan(0.5 * double(field_of_view));
      double farthest = 0;
      for (int k = 0; k < 2000; ++k) {
        const double along = distance * uniform(random);
        const double x = std::round(2 * uniform(random) - 1);
        const double y = std::round(2 * uniform(random) - 1);
        const glm::dvec3 seen = eye + along * (forward + slope * (kAspect * x * right + y * up));
        const glm::dvec3 place = glm::abs(place_in(maps[i], seen));
        farthest = std::max({farthest, place.x, place.y});
      }
      EXPECT_LE(farthest, maps[i].half_size * (1 - 3.9 / kSize)) << field_of_view << ", map " << i;
      EXPECT_GE(farthest, maps[i].half_size * 0.6) << field_of_view << ", map " << i;
    }
  }
}

TEST(MoonMap, AllThatCastsIsWithinReach) {
  const scene::Scene scene = moonlit_scene();
  for (const MoonMap& map : fit_moon_maps(scene.environment, scene.camera, kBox, 1.5, 512)) {
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 place =
          place_in(map, {corner & 1 ? kBox.low.x : kBox.high.x, corner & 2 ? kBox.low.y : kBox.high.y,
                         corner & 4 ? kBox.low.z : kBox.high.z});
      EXPECT_LT(place.z, 0);
      EXPECT_GT(place.z, -map.reach);
    }
    EXPECT_NEAR(glm::length(map.frame_from_world * glm::dvec3(-0.4, 0.5, -0.3) - glm::dvec3(0, 0, std::sqrt(0.5))), 0,
                1e-7);
  }
}

TEST(MoonMap, BoxCanCastIntoAMapThatItCoversAlongTheLight) {
  const scene::Scene scene = moonlit_scene();
  const MoonMap map = fit_moon_maps(scene.environment, scene.camera, kBox, 1.5, 512).front();
  const auto box_at = [&](double x, double y) {
    const glm::vec3 middle = map.position + glm::transpose(map.frame_from_world) * glm::dvec3(x, y, -3);
    return scene::Bounds{middle - 0.1f, middle + 0.1f};
  };
  EXPECT_TRUE(can_cast(box_at(0, 0), map));
  EXPECT_TRUE(can_cast(box_at(map.half_size, -map.half_size), map));
  EXPECT_FALSE(can_cast(box_at(map.half_size + 0.3, 0), map));
  EXPECT_FALSE(can_cast(box_at(0, -map.half_size - 0.3), map));
  EXPECT_TRUE(can_cast(kBox, map));
}

}  // namespace
}  // namespace litfog::test
