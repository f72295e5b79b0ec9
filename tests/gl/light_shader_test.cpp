// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec4.hpp>
#include <limits>
#include <vector>

#include "gl/example_lights.h"
#include "litfog/attenuation.h"

namespace litfog::test {
namespace {

using glm::dvec3;
using glm::vec4;

using LightShader = ExampleLightsTest;

TEST_F(LightShader, RangeAttenuationEndsAtTheExtent) {
  const std::vector<PlacedLight> lights = three_lights();
  const Fog fog{FogMode::exp, 0.01};
  upload(fog, {}, lights, solve_all(lights, fog));
  std::vector<vec4> points;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const float light_extent = block().kinds[i].attenuation_extent.w;
    for (const float range :
         {0.0f, 1.0f, light_extent / 2, light_extent, std::nextafter(light_extent, 1e9f), 2 * light_extent, 1e30f}) {
      points.emplace_back(i, range, 0, 0);
    }
  }
  const auto results =
      draw("result = vec4(litfog_range_attenuation(litfog_block_light(int(given(0).x)), given(0).y));", {points});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& light = lights[std::size_t(points[i].x)].light;
    const double range = double(points[i].y);
    const double expected = range > double(block().kinds[std::size_t(points[i].x)].attenuation_extent.w)
                                ? 0
                                : attenuation_at(light.attenuation, range);
    EXPECT_NEAR(results[i].x, expected, 1e-6) << light.name << " at " << range;
  }
}

TEST_F(LightShader, LightWithoutEndNeverEnds) {
  const std::vector<PlacedLight> lights = {
      {.light =
           {.name = {}, .color = dvec3(1), .attenuation = {2, 0, 0}, .threshold = 0.05, .cone = {}, .density_scale = 1},
       .position = dvec3(0),
       .direction = {0, 0, -1},
       .carried = true}};
  const Fog fog{FogMode::exp, 0.01};
  upload(fog, {}, lights, solve_all(lights, fog));
  const auto results = draw(
      "result = vec4(litfog_range_attenuation(litfog_block_light(0), given(0).x), "
      "litfog_block_light(0).color_intensity.w, 0, "
      "0);",
      {{vec4(1), vec4(1e30f), vec4(std::numeric_limits<float>::max())}});
  for (const vec4& result : results) {
    EXPECT_EQ(result.x, 0.5f);
    EXPECT_EQ(result.y, 0.5f);
  }
}

}  // namespace
}  // namespace litfog::test
