// SPDX-License-Identifier: Apache-2.0
#include "render/light/light_selection.h"

#include <gtest/gtest.h>

namespace litfog::test {
using namespace render;

namespace {

using Indices = std::vector<std::int32_t>;

constexpr scene::Bounds kBox{{-1, -1, -11}, {1, 1, -9}};

/// Shines along -z, out to 19 m.
PlacedLight lamp(const glm::dvec3& position, bool carried) {
  return {.light = {.name = "lamp", .attenuation = {1, 1, 0}, .cone = Cone::smoothstep(0.1, 0.2)},
          .position = position,
          .direction = {0, 0, -1},
          .carried = carried};
}

/// Lights 0 and 1 are local; 2 is carried and meets kBox, 3 is carried and shines past it.
scene::Scene four_lamps() {
  scene::Scene scene;
  scene.lights = {lamp({0, 0, 0}, true), lamp({0, 0, -5}, false), lamp({0, 0, -4}, false), lamp({50, 0, 0}, true)};
  return scene;
}

LightSelection select(const scene::Scene& scene) {
  const SceneLights lights(scene, {.path = &lighting_paths().front()});
  return select_lights(lights, lights.extents(), Indices{0, 1}, kBox);
}

Indices fog_lights_of(const scene::Scene& scene, const Fog& fog, const LightingPath& path,
                      Skipping skipping = Skipping::on) {
  SceneLights lights(scene, {.path = &path});
  lights.set_fog(fog);
  return fog_lights(lights, skipping);
}

const LightingPath& unified() { return lighting_paths().front(); }
const Fog kFog{FogMode::exp, 0.05};

TEST(LightSelection, SurfaceTakesTheLocalLightsThenTheCarriedOnesThatReachIt) {
  EXPECT_EQ(select(four_lamps()).surface, (Indices{0, 1, 2}));
}

TEST(LightSelection, FogTakesAllCarriedLightsWhereOneOfThemMeetsTheSurface) {
  EXPECT_TRUE(select(four_lamps()).is_fog_lit);
  EXPECT_EQ(fog_lights_of(four_lamps(), kFog, unified()), (Indices{2, 3}));
  scene::Scene scene = four_lamps();
  scene.lights[0].position = {-50, 0, 0};
  EXPECT_FALSE(select(scene).is_fog_lit);
}

TEST(LightSelection, ClearAirAndPathsWithoutLitFogTakeNoLightForTheFog) {
  EXPECT_EQ(fog_lights_of(four_lamps(), Fog{}, unified()), Indices{});
  EXPECT_EQ(fog_lights_of(four_lamps(), kFog, *find_lighting_path("legacy")), Indices{});
}

TEST(LightSelection, EveryCarriedLightIsTakenForTheFogWithoutSkipping) {
  EXPECT_EQ(fog_lights_of(four_lamps(), Fog{}, unified(), Skipping::off), (Indices{2, 3}));
}

TEST(LightSelection, LightsThatShareTheirMapsComeTogetherAndMakeBatches) {
  const std::vector<int> kinds{1, 0, 1, 0};
  const Indices surface = grouped_by_maps(Indices{0, 1, 2}, kinds);
  EXPECT_EQ(surface, (Indices{1, 0, 2}));
  EXPECT_EQ(batch_length(surface, 4, kinds), 1u);
  EXPECT_EQ(batch_length(std::span(surface).subspan(1), 4, kinds), 2u);
  EXPECT_EQ(batch_length(std::span(surface).subspan(1), 1, kinds), 1u);
  EXPECT_EQ(batch_length(surface, 4, {}), 3u);
  EXPECT_EQ(batch_length({}, 4, kinds), 0u);
}

TEST(LightSelection, LightsThatBringTheirFogAreThoseOfTheSurfaceAndOfTheFogEachOnce) {
  const std::vector<int> kinds{1, 0, 1, 0};
  EXPECT_EQ(with_fog_lights(Indices{1, 0, 2}, Indices{2, 3}, kinds), (Indices{1, 3, 0, 2}));
  EXPECT_EQ(with_fog_lights({}, Indices{3}, kinds), Indices{3});
}

TEST(SceneLights, LightThatEndsAtOnceIsLeftOutUnlessItIsCarried) {
  scene::Scene scene = four_lamps();
  for (PlacedLight& light : scene.lights) light.light.attenuation = {100, 0, 0};
  const SceneLights lights(scene, {.path = &unified()});
  EXPECT_EQ(lights.local_count(), 0u);
  EXPECT_EQ(lights.size(), 2u);
}

TEST(SceneLights, TablesHoldTheLightsInOrderAndTheIntensityOfTheLastFog) {
  const scene::Scene scene = four_lamps();
  SceneLights lights(scene, {.path = &unified()});
  lights.set_fog(kFog);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const PlacedLight& light = lights.lights()[i];
    const auto [kind, instance] = lights.packed(i);
    EXPECT_EQ(glm::dvec3(instance.position_kind), light.position);
    EXPECT_EQ(double(kind.attenuation_extent.w), double(float(lights.extents()[i])));
    const double intensity = light.carried ? solve_fog_intensity(light.light, kFog).intensity : 0;
    EXPECT_FLOAT_EQ(kind.cone_scale_intensity.w, float(intensity));
  }
}

}  // namespace

}  // namespace litfog::test
