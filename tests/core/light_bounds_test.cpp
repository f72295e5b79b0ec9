// SPDX-License-Identifier: Apache-2.0
#include "litfog/light_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "core/value_errors.h"
#include "reference/double_limits.h"
#include "reference/random_bounds.h"

namespace litfog::test {
namespace {

constexpr double kPi = std::numbers::pi;

struct Box {
  glm::dvec3 low;
  glm::dvec3 high;
};

/// Boxes of a scene's parts: some flat, some thin.
Box draw_box(Random& random) {
  const auto size = [&] { return random.chance(0.2) ? 0 : random.log_uniform(0.01, 100); };
  const glm::dvec3 low{random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-100, 100)};
  const glm::dvec3 sizes{size(), size(), size()};  // braces: drawn in this order by every compiler
  return {low, low + sizes};
}

/// Rounded, a mean of two equal coordinates may differ from both: not here.
glm::dvec3 point_in(const Box& box, const glm::dvec3& fraction) {
  return glm::clamp(glm::mix(box.low, box.high, fraction), box.low, box.high);
}

/// A light whose range and distance are near the box's size.
LightBounds draw_light_near(Random& random, const Box& box) {
  LightBounds light;
  const glm::dvec3 inside = point_in(box, glm::dvec3(random.uniform(0, 1)));
  const double distance = random.chance(0.1) ? 0 : random.log_uniform(0.01, 100);
  light.position = inside + distance * draw_direction(random);
  light.direction = random.chance(0.2) ? glm::dvec3(0, -1, 0) : draw_direction(random);
  light.range = random.chance(0.05) ? kInfinity : (distance + 0.01) * random.log_uniform(0.1, 10);
  light.half_angle = random.chance(0.2)   ? kPi
                     : random.chance(0.1) ? kPi / 2
                     : random.chance(0.1) ? random.uniform(kPi / 2, kPi)
                                          : random.uniform(0, kPi / 2);
  return light;
}

bool can_light(const LightBounds& light, const Box& box) { return litfog::can_light(light, box.low, box.high); }

TEST(LightBounds, LightReachesTheBoxThatHoldsAPointItLights) {
  Random random(61);
  int common = 0;
  for (int i = 0; i < 100000; ++i) {
    const Box box = draw_box(random);
    const LightBounds light = draw_light_near(random, box);
    for (int k = 0; k < 10; ++k) {
      const glm::dvec3 fraction{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
      const glm::dvec3 offset = point_in(box, fraction) - light.position;
      const double distance = glm::length(offset);
      if (distance > light.range || glm::dot(offset, light.direction) < distance * std::cos(light.half_angle)) continue;
      ++common;
      ASSERT_TRUE(can_light(light, box)) << light.range << ", " << light.half_angle;
      break;
    }
  }
  EXPECT_GT(common, 15000);
}

TEST(LightBounds, LightDoesNotReachABoxApartFromIt) {
  Random random(62);
  int proved = 0;
  int lit = 0;
  for (int i = 0; i < 10000; ++i) {
    const Box box = draw_box(random);
    const LightBounds light = draw_light_near(random, box);
    if (light.half_angle > kPi / 2 && light.half_angle < kPi) continue;
    const GapSearch search(box.low, box.high, light);
    const bool is_lit = can_light(light, box);
    if (search.largest(random) > kCullSlack * search.size()) {
      ++proved;
      ASSERT_FALSE(is_lit) << light.range << ", " << light.half_angle;
    }
    lit += is_lit;
  }
  std::printf("lit %d, apart %d\n", lit, proved);
  EXPECT_GT(proved, 2000);
  EXPECT_GT(lit, 2000);
}

TEST(LightBounds, LightWhoseRangeEndsOnABoxReachesIt) {
  Random random(63);
  for (int i = 0; i < 10000; ++i) {
    const Box box = draw_box(random);
    LightBounds light{.position = 200.0 * draw_direction(random)};
    const glm::dvec3 nearest = glm::clamp(light.position, box.low, box.high);
    const auto offset = glm::vec<3, long double>(nearest) - glm::vec<3, long double>(light.position);
    light.range = std::nextafter(double(glm::length(offset)), kInfinity);
    ASSERT_TRUE(can_light(light, box)) << light.range;
  }
}

TEST(LightBounds, BoxThatTouchesTheEdgeOfADarkConeIsLit) {
  const LightBounds light{.half_angle = kPi * 3 / 4};  // dark within 45 degrees of +z
  EXPECT_TRUE(can_light(light, {{0, 0, 1}, {1, 0, 2}}));
  EXPECT_FALSE(can_light(light, {{0, 0, 1}, {1 - 1e-9, 0, 2}}));
}

TEST(LightBounds, BoxBehindABeamOrInADarkConeIsUnlit) {
  const Box ahead{{-1, -1, -6}, {1, 1, -5}};
  const LightBounds ball{.direction = {0, 0, 1}, .half_angle = double(float(kPi))};
  EXPECT_TRUE(can_light(ball, ahead)) << "a float above pi is pi";
  const LightBounds beam{.half_angle = 0.3};
  EXPECT_TRUE(can_light(beam, ahead));
  EXPECT_FALSE(can_light({.direction = {0, 0, 1}, .half_angle = 0.3}, ahead));
  EXPECT_FALSE(can_light({.range = 4.9, .half_angle = 0.3}, ahead));
  EXPECT_FALSE(can_light({.direction = {0, 0, 1}, .half_angle = kPi - 0.3}, ahead));
  EXPECT_TRUE(can_light({.direction = {0, 0, 1}, .half_angle = kPi - 0.2}, ahead));
  EXPECT_FALSE(can_light({.position = {0, 0, -5.5}, .range = 0}, ahead));
  EXPECT_TRUE(can_light({.position = {0, 0, -5.5}, .range = 1e-9}, ahead));
}

TEST(LightBounds, BoundsOfALightEndAtItsConesCutOff) {
  PlacedLight light{.light = {}, .position = {1, 2, 3}, .direction = {1, 0, 0}};
  EXPECT_EQ(bounds_of(light, 7), (LightBounds{{1, 2, 3}, {1, 0, 0}, 7, kPi}));
  light.light.cone = Cone::smoothstep(0.1, 0.4);
  EXPECT_EQ(bounds_of(light, 7).half_angle, 0.4);
}

TEST(LightBounds, WrongBoxIsAnError) {
  const auto error_of_box = [](const glm::dvec3& low, const glm::dvec3& high) {
    return error_of([&] { (void)litfog::can_light({}, low, high); });
  };
  const std::string rule = ": must be finite and at most that of high, also finite";
  EXPECT_EQ(error_of_box({2, 0, 0}, {1, 1, 1}), "low.x = 2" + rule);
  EXPECT_EQ(error_of_box({0, kNan, 0}, {1, 1, 1}), "low.y = nan" + rule);
  EXPECT_EQ(error_of_box({0, 0, 0}, {1, 1, kInfinity}), "low.z = 0" + rule);
  EXPECT_EQ(error_of([] { (void)litfog::can_light({.range = -1}, {0, 0, 0}, {1, 1, 1}); }), "range = -1: must be >= 0");
}

}  // namespace
}  // namespace litfog::test
