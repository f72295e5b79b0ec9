// SPDX-License-Identifier: Apache-2.0
#include "render/light_list.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

namespace litfog::test {
using namespace render;

namespace {

using litfog::Cone;
using litfog::PlacedLight;
using render::can_see;
using scene::Bounds;

class Random {
 public:
  double between(double low, double high) { return std::uniform_real_distribution<>(low, high)(engine_); }
  glm::dvec3 point(double reach) { return {between(-reach, reach), between(-reach, reach), between(-reach, reach)}; }
  Bounds box() {
    const glm::vec3 low = point(30);
    return {low, low + glm::vec3(between(0, 20), between(0, 20), between(0, 20))};
  }
  glm::dvec3 point_in(const Bounds& box) {
    return {between(box.low.x, box.high.x), between(box.low.y, box.high.y), between(box.low.z, box.high.z)};
  }

 private:
  std::mt19937 engine_{7};
};

bool lights(const PlacedLight& light, double extent, const glm::dvec3& point) {
  const double range = glm::distance(point, light.position);
  return range <= extent && cone_at(light.light.cone, glm::dot(point - light.position, light.direction) / range) > 0;
}

TEST(LightList, NeverLeavesOutALightThatReachesAPointOfTheBox) {
  Random random;
  int reached = 0;
  int left_out = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Bounds box = random.box();
    PlacedLight light;
    light.position = random.point(40);
    light.direction = glm::normalize(random.point(1));
    if (i % 3 == 1) light.light.cone = Cone::cosine(random.between(0.05, 1.5), 2);
    if (i % 3 == 2) light.light.cone = Cone::smoothstep(0.01, random.between(0.05, 3.1));
    const double extent = random.between(1, 60);
    const bool listed = can_reach(light, extent, box);
    if (!listed) ++left_out;
    for (int sample = 0; sample < 50; ++sample) {
      if (!lights(light, extent, random.point_in(box))) continue;
      ++reached;
      ASSERT_TRUE(listed) << "case " << i;
    }
  }
  EXPECT_GT(reached, 10'000);
  EXPECT_GT(left_out, 5'000);
}

TEST(LightList, NamesTheLightsThatReachInTheirOrder) {
  std::vector<PlacedLight> lamps(3);
  lamps[0].position = {0, 0, 0};
  lamps[1].position = {100, 0, 0};
  lamps[2].position = {3, 0, 0};
  const std::vector<double> extents{5, 5, 5};
  const Bounds box{{1, -1, -1}, {2, 1, 1}};
  const render::LightFinder finder(lamps, extents);
  EXPECT_EQ(finder.reaching(box), (std::vector<std::int32_t>{0, 2}));
  EXPECT_EQ(finder.reaching(box, std::vector<std::int32_t>{1, 2}), (std::vector<std::int32_t>{2}));
}

TEST(LightList, AmongManyLightsNoneThatCanReachIsLost) {
  std::vector<PlacedLight> lamps(1000);
  std::vector<double> extents;
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    lamps[i].position = {double(i % 40) * 7, double(i % 3), double(i / 40) * 11};
    lamps[i].light.cone = i % 2 == 0 ? Cone{} : Cone::cosine(0.4, 10);
    lamps[i].direction = {0, -1, 0};
    extents.push_back(i == 77 ? std::numeric_limits<double>::infinity() : double(i % 20));
  }
  const render::LightFinder finder(lamps, extents);
  for (int place = 0; place < 100; ++place) {
    const glm::vec3 low{float(place * 3), -2, float(place * 2)};
    const Bounds box{low, low + glm::vec3(5, 1, 9)};
    std::vector<std::int32_t> expected;
    for (std::size_t i = 0; i < lamps.size(); ++i) {
      if (can_reach(lamps[i], extents[i], box)) expected.push_back(std::int32_t(i));
    }
    EXPECT_EQ(finder.reaching(box), expected) << place;
  }
}

TEST(LightList, BoxesBehindTheEyeAreOutOfView) {
  const glm::mat4 clip = glm::infinitePerspective(1.0f, 1.5f, 0.1f) *
                         glm::lookAt(glm::vec3(0, 2, 0), glm::vec3(0, 2, -1), glm::vec3(0, 1, 0));
  const auto frustum = render::make_frustum(clip);
  EXPECT_TRUE(can_see(frustum, {{-1, 0, -12}, {1, 2, -10}}));
  EXPECT_TRUE(can_see(frustum, {{-1, 0, -1e6f}, {1, 2, -1e5f}}));
  EXPECT_FALSE(can_see(frustum, {{-1, 0, 10}, {1, 2, 12}}));
  EXPECT_FALSE(can_see(frustum, {{50, 0, -12}, {52, 2, -10}}));
}

TEST(LightList, NeverLeavesABoxOutOfViewOfWhichAPointIsInThePicture) {
  Random random;
  int visible = 0;
  for (int i = 0; i < 20'000; ++i) {
    const glm::vec3 eye = random.point(20);
    const glm::mat4 clip = glm::infinitePerspective(float(random.between(0.2, 2)), 1.5f, 0.1f) *
                           glm::lookAt(eye, eye + glm::vec3(random.point(1)), glm::vec3(0, 1, 0));
    const auto frustum = render::make_frustum(clip);
    const Bounds box = random.box();
    const glm::vec4 seen = clip * glm::vec4(glm::vec3(random.point_in(box)), 1.0f);
    if (!glm::all(glm::lessThanEqual(glm::abs(glm::vec3(seen)), glm::vec3(seen.w)))) continue;
    ++visible;
    ASSERT_TRUE(can_see(frustum, box)) << "case " << i;
  }
  EXPECT_GT(visible, 500);
}

TEST(LightList, ATransformedBoxHoldsItsTransformedCorners) {
  const Bounds box{{-1, 0, 2}, {3, 1, 4}};
  const glm::mat4 turn = glm::translate(glm::rotate(glm::mat4(1), 0.7f, glm::vec3(0.6f, 0.8f, 0)), {5, 6, 7});
  const Bounds around = transformed(box, turn);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 at{corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                       corner & 4 ? box.high.z : box.low.z};
    const glm::vec3 moved = glm::vec3(turn * glm::vec4(at, 1));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(around.low, moved + 1e-4f)));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(moved, around.high + 1e-4f)));
  }
}

}  // namespace

}  // namespace litfog::test
