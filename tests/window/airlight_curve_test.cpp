// SPDX-License-Identifier: Apache-2.0
#include "window/airlight_curve.h"

#include <gtest/gtest.h>

#include <glm/glm.hpp>
#include <limits>

#include "litfog/multiple_scattering.h"

namespace litfog::test {
using namespace window;

namespace {

PlacedLight lamp() {
  PlacedLight light{.light = {}, .position = {2, 3, -20}};
  light.light.attenuation = {1, 0, 0.05};
  return light;
}

const EyeRay kRay{.direction = glm::normalize(glm::dvec3(0.2, 0.1, -1))};

TEST(AirlightCurve, EachSampleIsTheRaysThatEndsThere) {
  Atmosphere air;
  air.fog = Fog::from_visibility(FogMode::exp, 60);
  const AirlightCurve curve = make_airlight_curve(lamp(), air, kRay, 21);
  const ScatteringTable table = make_scattering_table(air);
  for (std::size_t i = 0; i < 21; ++i) {
    EyeRay ray = kRay;
    ray.length = curve.end * double(i) / 20;
    const double single = airlight(lamp(), air, ray);
    EXPECT_NEAR(curve.single[i], single, 1e-9);
    EXPECT_NEAR(curve.all[i], single + multiple_scattering(lamp(), air, table, ray), 1e-9);
    EXPECT_GE(curve.single[i], curve.single[i > 0 ? i - 1 : 0]);
  }
  EXPECT_GT(curve.end, glm::distance(lamp().position, kRay.origin));
}

TEST(AirlightCurve, ConesHaveAllOrdersToo) {
  Atmosphere air{.phase = Phase::droplets(10)};
  air.fog = Fog::from_visibility(FogMode::exp, 60);
  PlacedLight light = lamp();
  light.light.cone = Cone::smoothstep(0.2, 0.5);
  EXPECT_FALSE(make_airlight_curve(light, air, kRay, 80).all.empty());
}

TEST(AirlightCurve, SurfaceEndsItAndFogWithoutOrdersHasOne) {
  Atmosphere air;
  air.fog = Fog::from_visibility(FogMode::exp2, 60);
  EyeRay ray = kRay;
  ray.length = 7;
  const AirlightCurve curve = make_airlight_curve(lamp(), air, ray, 5);
  EXPECT_EQ(curve.end, 7);
  EXPECT_TRUE(curve.all.empty());
  ray.length = 0;
  ray.origin = lamp().position;
  EXPECT_GT(make_airlight_curve(lamp(), air, ray, 5).end, 0);
}

}  // namespace

}  // namespace litfog::test
