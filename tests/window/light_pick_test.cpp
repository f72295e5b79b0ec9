// SPDX-License-Identifier: Apache-2.0
#include "window/light_pick.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "render/gpu/depth.h"

namespace litfog::test {
using namespace window;

namespace {

constexpr double kAspect = 16.0 / 9;

scene::Camera camera() { return {.position = {3, 2, 5}, .target = {-1, 1, -20}, .field_of_view = 0.9f}; }

std::vector<PlacedLight> lights(const std::vector<glm::dvec3>& positions) {
  std::vector<PlacedLight> placed;
  for (const glm::dvec3& position : positions) placed.push_back({.light = {}, .position = position});
  return placed;
}

TEST(LightPick, PlaceIsThatOfTheProjection) {
  const glm::dmat4 view = glm::lookAt(glm::dvec3(camera().position), glm::dvec3(camera().target), glm::dvec3(0, 1, 0));
  const glm::dmat4 clip = glm::perspective(double(camera().field_of_view), kAspect, 0.1, 1000.0) * view;
  for (const glm::dvec3& point : {glm::dvec3(0, 1, -10), glm::dvec3(4, 6, -30), glm::dvec3(-9, -2, -15)}) {
    const glm::dvec4 projected = clip * glm::dvec4(point, 1);
    const auto place = place_in_picture(camera(), kAspect, point);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, (1 + projected.x / projected.w) / 2, 1e-6);
    EXPECT_NEAR(place->y, (1 - projected.y / projected.w) / 2, 1e-6);
  }
  EXPECT_FALSE(place_in_picture(camera(), kAspect, {3, 2, 6}));  // behind the eye
}

TEST(LightPick, RayThroughAPlaceShowsItsPointsThere) {
  for (const glm::dvec2& place : {glm::dvec2(0.1, 0.7), glm::dvec2(0.5, 0.5), glm::dvec2(0.98, 0.02)}) {
    const EyeRay ray = ray_through(camera(), kAspect, place);
    const auto shown = place_in_picture(camera(), kAspect, ray.origin + 30.0 * ray.direction);
    EXPECT_LE(glm::distance(shown.value(), place), 1e-12);
  }
}

TEST(LightPick, ClickMeansTheLampUnderIt) {
  const auto lamps = lights({{0, 1, -10}, {4, 6, -30}, {3, 2, 40}});
  for (const std::size_t i : {0u, 1u}) {
    const auto place = place_in_picture(camera(), kAspect, lamps[i].position);
    EXPECT_EQ(light_at(camera(), kAspect, lamps, *place + glm::dvec2(0.005, 0), 0.03), i);
  }
  EXPECT_FALSE(light_at(camera(), kAspect, lamps, {0.02, 0.98}, 0.03));
}

TEST(LightPick, NearerOfTwoLampsInLineIsMeant) {
  const glm::dvec3 eye(camera().position);
  const glm::dvec3 ray = glm::normalize(glm::dvec3(-0.1, 0.02, -1));
  const auto lamps = lights({eye + ray * 80.0, eye + ray * 12.0, eye + ray * 30.0});
  EXPECT_EQ(light_at(camera(), kAspect, lamps, *place_in_picture(camera(), kAspect, lamps[0].position), 0.03), 1u);
}

TEST(LightPick, ReachIsAsLongAcrossAsItIsHigh) {
  const auto lamps = lights({{0, 1, -10}});
  const glm::dvec2 place = *place_in_picture(camera(), kAspect, lamps[0].position);
  EXPECT_TRUE(light_at(camera(), kAspect, lamps, place + glm::dvec2(0.029 / kAspect, 0), 0.03));
  EXPECT_FALSE(light_at(camera(), kAspect, lamps, place + glm::dvec2(0.031 / kAspect, 0), 0.03));
  EXPECT_TRUE(light_at(camera(), kAspect, lamps, place + glm::dvec2(0, 0.029), 0.03));
  EXPECT_FALSE(light_at(camera(), kAspect, lamps, place + glm::dvec2(0, 0.031), 0.03));
}

}  // namespace

}  // namespace litfog::test
