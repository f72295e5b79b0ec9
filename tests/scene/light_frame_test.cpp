// SPDX-License-Identifier: Apache-2.0
#include "scene/light_frame.h"

#include <gtest/gtest.h>

#include <numbers>

#include "reference/random_light.h"

namespace litfog::test {
using namespace scene;

namespace {

using glm::dvec3;

constexpr double kRounding = 1e-14;

void expect_near(const dvec3& a, const dvec3& b, double tolerance = kRounding) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

void expect_rotation(const glm::dmat3& rotation) {
  const glm::dmat3 product = rotation * glm::transpose(rotation);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(product[i][k], i == k ? 1 : 0, kRounding);
  }
  EXPECT_NEAR(glm::determinant(rotation), 1, kRounding);
}

constexpr double kQuarter = std::numbers::pi / 2;

TEST(LightFrame, ViewpointThatLooksNorthHasXAheadYLeftZUp) {
  const glm::dmat3 rotation = light_from_world({0, 0}, {});
  expect_near(rotation * dvec3(0, 0, -1), {1, 0, 0});
  expect_near(rotation * dvec3(-1, 0, 0), {0, 1, 0});
  expect_near(rotation * dvec3(0, 1, 0), {0, 0, 1});
}

TEST(LightFrame, HeadingAndAzimuthTurnRightPitchAndElevationUp) {
  expect_near(light_from_world({0, 0}, {.heading = kQuarter}) * dvec3(1, 0, 0), {1, 0, 0});
  expect_near(light_from_world({kQuarter, 0}, {}) * dvec3(1, 0, 0), {1, 0, 0});
  expect_near(light_from_world({0, 0}, {.pitch = kQuarter}) * dvec3(0, 1, 0), {1, 0, 0});
  expect_near(light_from_world({0, kQuarter}, {}) * dvec3(0, 1, 0), {1, 0, 0});
}

TEST(LightFrame, RollTurnsRightAboutTheDirectionOfView) {
  const glm::dmat3 rotation = light_from_world({0, 0}, {.roll = kQuarter});
  expect_near(rotation * dvec3(0, 0, -1), {1, 0, 0});
  expect_near(rotation * dvec3(1, 0, 0), {0, 0, 1});  // the right side's direction is up for who lies on the left
}

TEST(LightFrame, BearingOfADirectionHasItAhead) {
  test::Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const dvec3 direction = test::draw_direction(random);
    const glm::dmat3 rotation = light_from_world(bearing_of(direction), {});
    expect_rotation(rotation);
    expect_near(rotation * direction, {1, 0, 0}, 1e-7);  // acos near 1: an asin at a pole loses half the digits
  }
}

/// v turned about an axis (Rodrigues 1840).
dvec3 turned(const dvec3& v, const dvec3& axis, double angle) {
  return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) + axis * glm::dot(axis, v) * (1 - std::cos(angle));
}

// The vehicle turns about its own axes: to its heading about the vertical, up about its right side, over about its
// nose; the lamp in the same way, in the vehicle's axes.
TEST(LightFrame, LampPointsWhereTheVehiclesTurnsTakeIt) {
  test::Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Attitude vehicle{random.uniform(-3, 3), random.uniform(-1.5, 1.5), random.uniform(-3, 3)};
    const Bearing lamp{random.uniform(-3, 3), random.uniform(-1.5, 1.5)};
    dvec3 ahead(0, 0, -1), right(1, 0, 0), up(0, 1, 0);
    const auto turn = [&](const dvec3& axis, double angle) {
      ahead = turned(ahead, axis, angle), right = turned(right, axis, angle), up = turned(up, axis, angle);
    };
    turn(up, -vehicle.heading);
    turn(right, vehicle.pitch);
    turn(ahead, vehicle.roll);
    turn(up, -lamp.azimuth);
    turn(right, lamp.elevation);
    const glm::dmat3 rotation = light_from_world(lamp, vehicle);
    expect_rotation(rotation);
    expect_near(rotation * ahead, {1, 0, 0}, 1e-13);
    expect_near(rotation * right, {0, -1, 0}, 1e-13);
    expect_near(rotation * up, {0, 0, 1}, 1e-13);
  }
}

TEST(LightFrame, BasisHasTheDirectionAtMinusZAndStandsUpright) {
  test::Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const dvec3 direction = test::draw_direction(random);
    const glm::dmat3 basis = basis_from_world(direction);
    expect_rotation(basis);
    expect_near(basis * direction, {0, 0, -1});
    if (std::abs(direction.y) < 0.99) {
      EXPECT_GT((basis * dvec3(0, 1, 0)).y, 0);
    }
  }
  for (const double up : {1.0, -1.0}) {
    expect_rotation(basis_from_world({0, up, 0}));
    expect_near(basis_from_world({0, up, 0}) * dvec3(0, up, 0), {0, 0, -1});
  }
}

TEST(LightFrame, CookieTurnsToTheRightAsSeenAlongItsAxis) {
  const dvec3 ahead(0, 0, -1);
  const glm::dmat3 level = cookie_from_world(ahead, 0);
  EXPECT_NEAR(glm::distance(level * dvec3(0, 1, 0), dvec3(0, 1, 0)), 0, 1e-15);
  const glm::dmat3 turned = cookie_from_world(ahead, std::numbers::pi / 2);
  EXPECT_NEAR(glm::distance(turned * dvec3(1, 0, 0), dvec3(0, 1, 0)), 0, 1e-15);  // its up is now on the right
  EXPECT_NEAR(glm::distance(turned * ahead, ahead), 0, 1e-15);
}

}  // namespace

}  // namespace litfog::test
