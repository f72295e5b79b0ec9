// SPDX-License-Identifier: Apache-2.0
#include "render/light/point_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "litfog/attenuation.h"

namespace litfog::test {
using namespace render;

namespace {

constexpr double kBudget = 4e-5;

/// From the origin along -z.
const PointView kView{.eye = {},
                      .forward = {0, 0, -1},
                      .frustum = make_frustum(glm::infinitePerspective(1.0f, 1.5f, 0.1f)),
                      .pixels_per_radian = 360 / std::tan(0.5),
                      .height = 720};

scene::Scene row_of_lamps(int count, double spacing, double density_scale = 1) {
  scene::Scene scene;
  for (int i = 0; i < count; ++i) {
    PlacedLight lamp;
    lamp.light = {.name = "lamp", .attenuation = {1, 0, 0.01}, .threshold = 1e-6, .cone = {}};
    lamp.light.density_scale = density_scale;
    lamp.position = {0, 0, -spacing * (i + 1)};
    scene.lights.push_back(lamp);
  }
  return scene;
}

/// What light_point.vert makes of a white lamp at a range.
double brightness(double range, const Fog& fog) {
  return std::min(2000 * attenuation_at({1, 0, 0.01}, range) * fog_factor_at(fog, range), 1.5);
}

TEST(PointList, PointsLeftOutTogetherAddLessThanTheBudget) {
  const scene::Scene scene = row_of_lamps(2000, 0.5);
  const SceneLights lights(scene, {});
  for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
    for (const double density : {0.0, 0.005, 0.02, 0.1, 1.0}) {
      const Fog fog{mode, density};
      const PointList found = list_points(lights, {.fog = fog}, FogLighting::peak, kView, kBudget);
      double left_out = 0;
      double farthest = 0;
      for (std::size_t i = 0; i < lights.size(); ++i) {
        const double range = -lights.lights()[i].position.z;
        const bool is_drawn = std::ranges::binary_search(found.lights, std::int32_t(i));
        if (is_drawn) farthest = std::max(farthest, range);
        if (!is_drawn) left_out += 1.25 * brightness(range, fog);
      }
      EXPECT_LE(left_out, kBudget) << density;
      EXPECT_GE(found.hidden_by, farthest);
      EXPECT_LE(found.hidden_by, farthest * 1.1);
      EXPECT_EQ(found.lights.size() + found.hidden + found.outside_view, lights.size());
      EXPECT_GE(found.hidden, density >= 0.1 ? 1000u : 0u) << density;
    }
  }
}

TEST(PointList, PointsBehindAndBesideTheViewAreOutsideIt) {
  scene::Scene scene = row_of_lamps(3, 20);
  scene.lights[0].position = {0, 0, 20};
  scene.lights[1].position = {40, 0, -20};
  const PointList found = list_points(SceneLights(scene, {}), {}, FogLighting::peak, kView, kBudget);
  EXPECT_EQ(found.lights, std::vector<std::int32_t>{2});
  EXPECT_EQ(found.outside_view, 2u);
}

TEST(PointList, FogOfTheLightsClassDecides) {
  const Fog fog{FogMode::exp, 0.1};
  const scene::Scene dense = row_of_lamps(1, 200);
  const scene::Scene thin = row_of_lamps(1, 200, 0.4);
  EXPECT_TRUE(list_points(SceneLights(dense, {}), {.fog = fog}, FogLighting::peak, kView, kBudget).lights.empty());
  EXPECT_EQ(list_points(SceneLights(thin, {}), {.fog = fog}, FogLighting::peak, kView, kBudget).lights.size(), 1u);
}

}  // namespace
}  // namespace litfog::test
