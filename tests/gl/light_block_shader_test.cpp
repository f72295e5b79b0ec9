// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "gl/shader_test.h"

namespace litfog::test {
namespace {

using glm::vec4;

using LightBlockShader = ShaderTest;

TEST_F(LightBlockShader, EveryNumberOfTheBlockIsRead) {
  std::vector<PlacedLight> lights(kMaxFogLights);
  std::vector<FogIntensity> solutions(kMaxFogLights);
  std::vector<vec4> indices;
  for (std::size_t i = 0; i < kMaxFogLights; ++i) {
    const double n = 100.0 * double(i);
    lights[i] = {.light = {.name = {},
                           .color = {n + 1, n + 2, n + 3},
                           .attenuation = {n + 4, n + 5, n + 6},
                           .threshold = 0.05,
                           .cone = i % 2 ? Cone::cosine(1, n + 7) : Cone::smoothstep(0.25, 1),
                           .density_scale = n + 8},
                 .position = {n + 9, n + 10, n + 11},
                 .direction = glm::normalize(glm::dvec3(n + 12, -n - 13, 14)),
                 .carried = true};
    solutions[i] = {.intensity = n + 15, .peak_range = 0, .extent = n + 16, .status = SolveStatus::ok};
    for (int field = 0; field < 7; ++field) indices.emplace_back(i, field, 0, 0);
  }
  upload({FogMode::exp2, 0.125}, {0.25, 0.5, 0.75}, lights, solutions);
  const auto results = draw(R"(
    LitfogLight light = litfog_block_light(int(given(0).x));
    vec4 fields[7] = vec4[7](light.position_extent, light.axis_profile, light.color_intensity, light.attenuation,
                             light.cone, litfog_fog, litfog_ambient_fog_color);
    result = fields[int(given(0).y)];)",
                            {indices});
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto expected = shader_light(block().kinds[i / 7], block().instances[i / 7]);
    const std::size_t field = i % 7;
    const vec4 expected_value = field < 5    ? expected[field]
                                : field == 5 ? block().header.fog
                                             : block().header.ambient_fog_color;
    EXPECT_EQ(results[i], expected_value) << "light " << i / 7 << ", field " << field;
  }
}

}  // namespace
}  // namespace litfog::test
