// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/scattered_light_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "litfog/multiple_scattering.h"
#include "random_box.h"
#include "render/light/light_threshold.h"

namespace litfog::test {
namespace {

using namespace render;

// Of boxes near and far from forty lamps, in thin and thick fog.
TEST(ScatteredLightBound, NoSurfaceReceivesMore) {
  Random random(427);
  double most = 0;
  for (const double density : {0.003, 0.03, 0.3}) {
    for (const Phase& phase : {Phase{}, Phase::droplets(10)}) {
      const Atmosphere air{.fog = {FogMode::exp, density}, .phase = phase};
      scene::Scene scene;
      for (int i = 0; i < 40; ++i) {
        PlacedLight light;
        light.light.attenuation = {.constant = 1, .linear = 0, .quadratic = random.log_uniform(1, 1e4)};
        light.light.source_radius = 0.01;
        light.light.color = glm::dvec3(random.log_uniform(0.1, 100), 1, random.log_uniform(0.1, 100));
        if (random.chance(0.5)) light.light.cone = Cone::smoothstep(0.1, random.uniform(0.2, 1.5));
        light.position = random_point(random, 60);
        light.direction = glm::normalize(random_point(random, 1));
        scene.lights.push_back(light);
      }
      const RenderSettings settings{.fog_lighting = FogLighting::airlight, .scattering = Scattering::all};
      SceneLights lights(scene, settings);
      lights.set_fog(air.fog);
      const HigherOrders orders(lights, {}, air);
      const ScatteredLightBound bound(lights, orders, density);
      const ThinBeams beams = make_thin_beams(air, *orders.table);
      for (int i = 0; i < 50; ++i) {
        const scene::Bounds box = random_box(random);
        const double bounded = bound.largest_irradiance(box);
        const glm::dvec3 position = random_point_in(random, box);
        const glm::dvec3 normal = glm::normalize(random_point(random, 1));
        double sum = 0;
        for (const PlacedLight& light : lights.lights()) {
          const ScatteringSource source = scattering_source(light.light, air, beams);
          sum +=
              largest_component(light.light.color) * irradiance(scattered_light(light, source, air, position), normal);
        }
        EXPECT_LE(sum, bounded) << density << ", box " << i;
        most = std::max(most, sum / bounded);
      }
    }
  }
  std::printf("at most %.2f of the bound\n", most);
  EXPECT_GT(most, 0.05);
}

TEST(ScatteredLightBound, FogThatScattersOnceLightsNoSurface) {
  EXPECT_EQ(ScatteredLightBound().largest_irradiance({glm::vec3(-1), glm::vec3(1)}), 0);
}

}  // namespace
}  // namespace litfog::test
