// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "gl/example_lights.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

using glm::dvec3;
using glm::vec3;
using glm::vec4;

class SurfaceShader : public ExampleLightsTest {
 protected:
  /// The Basic model of one light, from the Cg Tutorial's formulas, in double.
  static dvec3 expected_surface(const PlacedLight& light, float light_extent, const dvec3& position,
                                const dvec3& normal, const dvec3& to_eye, const dvec3& diffuse_color,
                                const dvec3& specular_color, double shininess) {
    const dvec3 offset = light.position - position;
    const double range = glm::length(offset);
    if (range > double(light_extent)) return dvec3(0);
    const dvec3 to_light = offset / range;
    const double diffuse = std::max(glm::dot(normal, to_light), 0.0);
    const double facing = std::max(glm::dot(normal, glm::normalize(to_light + to_eye)), 0.0);
    const double specular = diffuse > 0 ? std::pow(facing, shininess) : 0;
    const dvec3 color =
        light.light.color * (attenuation_at(light.light.attenuation, range) * expected_cone(light, position));
    return color * (diffuse_color * diffuse + specular_color * specular);
  }
};

TEST_F(SurfaceShader, LitSurfaceIsTheBasicModels) {
  const Fog fog{FogMode::exp, 0.02};
  upload_lights(fog);
  const std::vector<vec4> positions = random_positions();
  std::vector<vec4> to_eyes;
  const auto normals = random_points([&](Random& random) {
    to_eyes.emplace_back(vec3(draw_direction(random)), 0);
    return vec4(vec3(draw_direction(random)), 0);
  });
  for (std::size_t k = 0; k < lights_.size(); ++k) {
    const auto results = draw(
        "LitfogSurface surface = LitfogSurface(given(0).xyz, given(1).xyz, given(2).xyz, vec3(9.0), vec3(9.0), "
        "vec3(0.5, 0.25, "
        "0.125), "
        "vec3(0.25, 0.5, 0.75), 8.0); result = vec4(litfog_light_surface(surface, litfog_block_light(" +
            std::to_string(k) + ")), 1.0);",
        {positions, normals, to_eyes});
    WorstError error("litfog_light_surface, GL", lights_[k].light.name, 1e-4, "absolute");
    int lit = 0;
    int dark = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const dvec3 position(positions[i]);
      const dvec3 to_light = glm::normalize(lights_[k].position - position);
      const float light_extent = block().kinds[k].attenuation_extent.w;
      // Where a bright side begins, or the extent is, rounding decides.
      if (std::abs(glm::dot(dvec3(normals[i]), to_light)) < 1e-6) continue;
      if (std::abs(glm::length(lights_[k].position - position) - double(light_extent)) < 1e-4) continue;
      const dvec3 expected = expected_surface(lights_[k], light_extent, position, dvec3(normals[i]), dvec3(to_eyes[i]),
                                              {0.5, 0.25, 0.125}, {0.25, 0.5, 0.75}, 8);
      error.add(color_error(results[i], expected),
                [&] { return describe(positions[i]) + " normal " + describe(normals[i]); });
      if (expected == dvec3(0)) {
        ++dark;
        EXPECT_EQ(vec3(results[i]), vec3(0)) << describe(positions[i]);
      } else {
        ++lit;
      }
    }
    error.check();
    EXPECT_GT(lit, 100) << lights_[k].light.name;
    EXPECT_GT(dark, 100) << lights_[k].light.name;
  }
}

TEST_F(SurfaceShader, AmbientTermIsEmissionAndReflectedAmbientLight) {
  const auto results = draw(
      "LitfogSurface surface = LitfogSurface(vec3(0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.125, 0.25, "
      "0.5), "
      "vec3(0.5, 0.25, 0.125), vec3(9.0), vec3(1.0), 8.0); result = vec4(litfog_ambient(surface, vec3(1.0, 2.0, 4.0)), "
      "1.0);",
      {{vec4(0)}});
  EXPECT_EQ(results[0], vec4(0.625, 0.75, 1, 1));
}

TEST_F(SurfaceShader, SurfaceAtALightItselfIsFinite) {
  for (const Cone& cone : {Cone{}, Cone::cosine(0.5, 3), Cone::smoothstep(0.2, 0.5)}) {
    std::vector<PlacedLight> lights = {three_lights().front()};
    lights.front().light.cone = cone;
    const Fog fog{FogMode::exp, 0.1};
    upload(fog, kAmbient, lights, solve_all(lights, fog));
    const auto results = draw(
        "vec3 position = given(0).xyz; LitfogSurface surface = LitfogSurface(position, vec3(0.0, 1.0, 0.0), vec3(0.0, "
        "0.0, 1.0), "
        "vec3(0.0), vec3(0.5), vec3(0.5), vec3(0.5), 8.0); result = vec4(litfog_fog_color(position).r, "
        "litfog_apply_fog(vec3(0.5), "
        "position, vec3(0.0)).r, litfog_light_surface(surface, litfog_block_light(0)).r, 1.0);",
        {{vec4(vec3(lights.front().position), 0)}});
    EXPECT_TRUE(results[0].x >= 0 && results[0].y >= 0) << describe(results[0]);
    EXPECT_EQ(results[0].z, 0) << "turned to no side";
  }
}

}  // namespace
}  // namespace litfog::test
