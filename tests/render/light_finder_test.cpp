// SPDX-License-Identifier: Apache-2.0
#include "render/light/light_finder.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "reference/random_light.h"
#include "render/random_box.h"

namespace litfog::test {
using namespace render;

namespace {

using scene::Bounds;

bool lights(const PlacedLight& light, double extent, const glm::dvec3& point) {
  const double range = glm::distance(point, light.position);
  return range <= extent && cone_at(light.light.cone, glm::dot(point - light.position, light.direction) / range) > 0;
}

TEST(LightFinder, LightThatReachesAPointOfTheBoxIsFound) {
  Random random(7);
  int reached = 0;
  int left_out = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Bounds box = random_box(random);
    PlacedLight light;
    light.position = random_point(random, 40);
    light.direction = glm::normalize(random_point(random, 1));
    if (i % 3 == 1) light.light.cone = Cone::cosine(random.uniform(0.05, 1.5), 2);
    if (i % 3 == 2) light.light.cone = Cone::smoothstep(0.01, random.uniform(0.05, 3.1));
    const double extent = random.uniform(1, 60);
    const bool listed = can_reach(light, extent, box);
    if (!listed) ++left_out;
    for (int sample = 0; sample < 50; ++sample) {
      if (!lights(light, extent, random_point_in(random, box))) continue;
      ++reached;
      ASSERT_TRUE(listed) << "case " << i;
    }
  }
  EXPECT_GT(reached, 10'000);
  EXPECT_GT(left_out, 5'000);
}

TEST(LightFinder, LightsThatReachAreNamedInTheirOrder) {
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

/// Expects a finder to list exactly the lamps of can_reach() for each box. Returns how many were listed.
std::size_t expect_those_that_can_reach(const std::vector<PlacedLight>& lamps, const std::vector<double>& extents,
                                        const std::vector<Bounds>& boxes) {
  const render::LightFinder finder(lamps, extents);
  std::size_t listed = 0;
  for (const Bounds& box : boxes) {
    std::vector<std::int32_t> expected;
    for (std::size_t i = 0; i < lamps.size(); ++i) {
      if (can_reach(lamps[i], extents[i], box)) expected.push_back(std::int32_t(i));
    }
    EXPECT_EQ(finder.reaching(box), expected);
    listed += expected.size();
  }
  return listed;
}

TEST(LightFinder, LightThatCanReachIsFoundAmongMany) {
  std::vector<PlacedLight> lamps(1000);
  std::vector<double> extents;
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    lamps[i].position = {double(i % 40) * 7, double(i % 3), double(i / 40) * 11};
    lamps[i].light.cone = i % 2 == 0 ? Cone{} : Cone::cosine(0.4, 10);
    lamps[i].direction = {0, -1, 0};
    extents.push_back(i == 77 ? std::numeric_limits<double>::infinity() : double(i % 20));
  }
  std::vector<Bounds> boxes;
  for (int step = 0; step < 100; ++step) {
    const glm::vec3 low{float(step * 3), -2, float(step * 2)};
    boxes.push_back({low, low + glm::vec3(5, 1, 9)});
  }
  EXPECT_GT(expect_those_that_can_reach(lamps, extents, boxes), 100u);
}

TEST(LightFinder, BoxWhoseMiddleLiesBehindALampOnItsAxisIsLitAroundTheLamp) {
  std::vector<PlacedLight> lamps(1);
  lamps[0].direction = glm::normalize(glm::dvec3(1, -1, 1));
  lamps[0].light.cone = Cone::cosine(std::numbers::pi / 4, 1);
  const std::vector<double> extents{10};
  const Bounds box{glm::vec3(-2.5, -0.5, -2.5), glm::vec3(0.5, 2.5, 0.5)};
  EXPECT_EQ(expect_those_that_can_reach(lamps, extents, {box}), 1u);
}

TEST(LightFinder, AnyConeRangeAndBoxAreDecidedAsByCanReach) {
  constexpr double kHuge = std::numeric_limits<double>::infinity();
  Random random(8);
  std::vector<PlacedLight> lamps(2000);
  std::vector<double> extents;
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    PlacedLight& lamp = lamps[i];
    lamp.position = i % 7 == 0 ? glm::dvec3(glm::round(random_point(random, 30))) : random_point(random, 40);
    lamp.direction = i % 5 == 0 ? glm::dvec3(0, -1, 0) : glm::normalize(random_point(random, 1));
    const double half_angles[] = {std::numbers::pi / 2, 1e-6, random.uniform(0.01, 3.1), random.uniform(0.01, 0.3)};
    if (i % 5 != 4) lamp.light.cone = Cone::smoothstep(0, half_angles[i % 5]);
    const double ranges[] = {kHuge, 0, 1e-9, random.uniform(1, 60), random.uniform(1, 60), 1e5};
    extents.push_back(ranges[i % 6]);
  }
  std::vector<Bounds> boxes;
  for (int i = 0; i < 500; ++i) {
    Bounds box = random_box(random);
    if (i % 3 == 1) box = {glm::round(box.low), glm::round(box.high)};  // touches cones and lamps exactly
    if (i % 3 == 2) box.high = box.low + glm::vec3(0, i % 2 == 0 ? 0.0f : 1e4f, 50.0f);  // flat, or a line
    boxes.push_back(box);
  }
  const std::size_t listed = expect_those_that_can_reach(lamps, extents, boxes);
  EXPECT_GT(listed, 100'000u);
  EXPECT_LT(listed, 900'000u);
}

}  // namespace

}  // namespace litfog::test
