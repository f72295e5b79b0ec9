// SPDX-License-Identifier: Apache-2.0
#include "bench/light_count.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scene/file/scene_file.h"

namespace litfog::test {
using namespace bench;
using namespace scene;

namespace {

using litfog::bench::with_light_count;

double brightness(const Scene& scene) {
  double sum = 0;
  for (const PlacedLight& light : scene.lights) sum += light.light.color.g;
  return sum;
}

TEST(LightCount, EverySceneHasTheNumberOfLightsAskedFor) {
  for (const std::string& name : bundled_scenes()) {
    const Scene scene = read_scene(bundled_scene_path(name));
    for (const std::size_t count : {1u, 2u, 5u, 16u, 256u}) {
      EXPECT_EQ(with_light_count(scene, count).lights.size(), count) << name;
    }
  }
}

TEST(LightCount, CarriedLightsAreTakenFirstAndThenTheNearest) {
  const Scene scene = read_scene(bundled_scene_path("approach"));
  const auto carried = std::size_t(std::ranges::count_if(scene.lights, &PlacedLight::carried));
  ASSERT_GT(carried, 0u);
  const Scene some = with_light_count(scene, carried + 3);
  double range = 0;
  for (std::size_t i = 0; i < some.lights.size(); ++i) {
    EXPECT_EQ(some.lights[i].carried, i < carried);
    if (i < carried) continue;
    const double next = glm::distance(some.lights[i].position, glm::dvec3(scene.camera.position));
    EXPECT_GE(next, range);
    range = next;
  }
  for (const PlacedLight& light : scene.lights) {
    const bool is_taken =
        std::ranges::any_of(some.lights, [&](const PlacedLight& taken) { return taken.position == light.position; });
    if (!light.carried && !is_taken) {
      EXPECT_GE(glm::distance(light.position, glm::dvec3(scene.camera.position)), range);
    }
  }
}

TEST(LightCount, CopiesAreTogetherAsBrightAsTheirLightsAndNotCarried) {
  Scene scene = read_scene(bundled_scene_path("headlights"));
  const std::size_t own = scene.lights.size();
  const Scene many =
      with_light_count(scene, own + 4 * std::size_t(std::ranges::count(scene.lights, false, &PlacedLight::carried)));
  EXPECT_NEAR(brightness(many), brightness(scene), 1e-12 * brightness(scene));
  for (std::size_t i = own; i < many.lights.size(); ++i) EXPECT_FALSE(many.lights[i].carried);
}

TEST(LightCount, CopiesKeepTheirCookies) {
  const Scene scene = read_scene(bundled_scene_path("cookies"));
  const Scene many = with_light_count(scene, 50);
  EXPECT_GT(many.cookie_uses.size(), scene.cookie_uses.size());
  for (const auto& copy : many.cookie_uses) {
    ASSERT_LT(copy.first, many.lights.size());
    const std::string& name = many.lights[copy.first].light.name;
    const auto source = std::ranges::find_if(scene.cookie_uses, [&](const auto& one) {
      return scene.lights[one.first].light.name == name && one.second.cookie == copy.second.cookie;
    });
    EXPECT_NE(source, scene.cookie_uses.end()) << name;
  }
}

// In the middle third of the view as often as in each of the outer ones.
TEST(LightCount, CopiesFillTheFieldOfView) {
  const Scene scene = read_scene(bundled_scene_path("headlights"));
  const Scene many = with_light_count(scene, 606);
  const Camera& camera = scene.camera;
  const glm::dvec3 forward =
      glm::normalize(glm::dvec3(camera.target.x - camera.position.x, 0, camera.target.z - camera.position.z));
  const glm::dvec3 right(-forward.z, 0, forward.x);
  const double edge = std::tan(double(camera.field_of_view) / 2) * 16 / 9;
  int thirds[3] = {};
  for (std::size_t i = scene.lights.size(); i < many.lights.size(); ++i) {
    const glm::dvec3 way = many.lights[i].position - glm::dvec3(camera.position);
    const double across = glm::dot(way, right) / glm::dot(way, forward) / edge;
    ASSERT_LE(std::abs(across), 1 + 1e-9);
    ++thirds[std::clamp(int((across + 1) * 1.5), 0, 2)];
  }
  for (const int count : thirds) EXPECT_NEAR(count, 200, 5);  // R2 strews 600 points with an error of a few
}

}  // namespace

}  // namespace litfog::test
