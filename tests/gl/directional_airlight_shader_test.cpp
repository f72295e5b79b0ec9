// SPDX-License-Identifier: Apache-2.0
#include "litfog/directional_airlight.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "gl/shader_test.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

using glm::dvec3;
using glm::vec4;

class DirectionalAirlightShader : public ShaderTest {};

TEST_F(DirectionalAirlightShader, AirlightAndFactorAreThoseOfTheLibrary) {
  const std::array<DensityKnot, 4> knots{{{0, 0.01}, {90, 0.02}, {100, 0.02}, {120, 0}}};
  const std::array<DensityKnot, 4> cloud{{{60, 0}, {80, 0.05}, {100, 0.05}, {105, 0}}};
  const Phase droplets = Phase::droplets(10);
  std::array<Atmosphere, 7> airs{{{.fog = {FogMode::exp, double(0.02f)}, .phase = droplets, .top = 90},
                                  {.fog = {FogMode::exp, double(0.5f)}, .top = 90},
                                  {.phase = droplets, .profile = make_density_profile(knots)},
                                  {.profile = make_density_profile(cloud)}}};
  for (int i = 4; i < 7; ++i) {  // haze and layers, up to a top and without one
    airs[std::size_t(i)] = {.fog = {FogMode::exp, double(2e-4f)},
                            .top = i == 4 ? 200 : std::numeric_limits<double>::infinity(),
                            .profile = airs[std::size_t(i - 2)].profile};
  }
  airs[6].profile = make_density_profile(std::span(cloud).first(3));  // goes on upwards
  const auto rays = random_points(
      [](Random& random) { return vec4(glm::vec3(draw_direction(random)), float(random.log_uniform(1e-2, 5e4))); });
  Random more(4144);
  std::vector<vec4> lights(rays.size());
  for (vec4& light : lights) {
    light = vec4(glm::vec3(draw_direction(more)), float(more.chance(0.1) ? 90 : more.uniform(-50, 300)));
  }
  WorstError error("litfog_directional_airlight, GL", "tops and layers", 2e-5, "of the phase function");
  WorstError factor_error("litfog_directional_factor, GL", "tops and layers", 2e-5, "absolute");
  for (const Atmosphere& air : airs) {
    upload(air);
    const auto results = draw(
        "vec3 eye = vec3(3.0, given(1).w, -2.0);"
        "float top = " +
            std::to_string(air.light_top()) +
            ";"
            "result = vec4(litfog_directional_airlight(eye, given(0).xyz, given(0).w, given(1).xyz, top),"
            "              litfog_directional_factor(eye.y, given(1).xyz, top), 0.0, 0.0);",
        {rays, lights});
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const dvec3 direction = glm::normalize(dvec3(rays[i])), to_light = glm::normalize(dvec3(lights[i]));
      const EyeRay ray{{3, double(lights[i].w), -2}, direction, double(rays[i].w)};
      const double most = std::max(phase_at(air.phase, glm::dot(direction, to_light)), 1.0);
      const auto text = [&] { return describe(rays[i]) + ", " + describe(lights[i]); };
      error.add(std::abs(double(results[i].x) - directional_airlight(air, to_light, ray)) / most, text);
      factor_error.add(std::abs(double(results[i].y) - directional_fog_factor(air, to_light, ray.origin.y)), text);
    }
  }
  error.check();
  factor_error.check();
}

}  // namespace
}  // namespace litfog::test
