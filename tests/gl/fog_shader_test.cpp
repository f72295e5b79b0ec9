// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <vector>

#include "gl/example_lights.h"
#include "reference/double_limits.h"
#include "reference/reference_solver.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

using glm::dvec3;
using glm::vec4;

class FogShader : public ExampleLightsTest {
 protected:
  dvec3 expected_fog_color(const Fog& fog, const dvec3& point) const {
    dvec3 color = kAmbient;
    for (const PlacedLight& light : lights_) {
      if (!light.carried) continue;
      color += light.light.color * (expected_cone(light, point) * solve_fog_intensity(light.light, fog).intensity);
    }
    return color;
  }
};

TEST_F(FogShader, OpacityIsThatOfTheScaledFog) {
  for (const FogMode mode : kModes) {
    const Fog fog{mode, double(0.0173f)};
    upload(fog, {}, {}, {});
    const auto points = random_points([](Random& random) {
      return vec4(random.log_uniform(1e-2, 1e4), random.pick(std::array{1.0, 0.4, 0.75, 0.0}), 0, 0);
    });
    const auto results = draw("result = vec4(litfog_fog_opacity(0.0, 0.0, given(0).x, given(0).y));", {points});
    // The function's 4 ulp (10 in thick fog) and up to 5 roundings of the depth before it.
    WorstError error("litfog_fog_opacity, GL", mode == FogMode::exp ? "exp, scales 0..1" : "exp2, scales 0..1", 10);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double scale = double(points[i].y);
      error.add(ulp_error(results[i].x, reference_opacity(mode, Digits50(fog.density) * scale, double(points[i].x))),
                [&] { return describe(points[i]); });
    }
    error.check();
  }
}

TEST_F(FogShader, OpacityOfTotalFogIsOneAndOfClearAirZero) {
  for (const FogMode mode : kModes) {
    upload({mode, std::numeric_limits<double>::infinity()}, {}, {}, {});
    const std::vector<std::vector<vec4>> points = {{vec4(1e-3f), vec4(1), vec4(1e5f)}};
    for (const vec4& result : draw("result = vec4(litfog_fog_opacity(0.0, 0.0, given(0).x, 1.0));", points))
      EXPECT_EQ(result.x, 1);
    upload({mode, 0}, {}, {}, {});
    for (const vec4& result : draw("result = vec4(litfog_fog_opacity(0.0, 0.0, given(0).x, 1.0));", points))
      EXPECT_EQ(result.x, 0);
  }
}

TEST_F(FogShader, OpacityOfLayeredFogIsThatOfTheMeanDensityAlongTheWay) {
  const std::array<DensityKnot, 5> knots{{{0, 0.001}, {90, 0.02}, {100, 0.02}, {120, 0}, {1000, 0.005}}};
  const Atmosphere air{.fog = {FogMode::exp, double(0.0005f)}, .profile = make_density_profile(knots)};
  upload(air);
  const auto points = random_points([&](Random& random) {
    const float height = random.chance(0.3) ? float(random.pick(knots).height) : float(random.uniform(-50, 1200));
    const double other = random.chance(0.3) ? double(height) : double(height) + random.uniform(-300, 300);
    return vec4(height, float(other), random.log_uniform(1e-2, 1e4), random.pick(std::array{1.0, 0.4}));
  });
  const auto results = draw(
      "vec4 p = given(0);"
      "LitfogLight light;"
      "light.position_extent.y = p.y;"
      "light.attenuation.w = p.w;"
      "result = vec4(litfog_fog_density(p.x, p.y), litfog_fog_opacity(p.x, p.y, p.z, p.w), "
      "litfog_lamp_factor(light, p.x, p.z), 0.0);",
      {points});
  WorstError density_error("litfog_fog_density, GL", "5 knots, rises 0..300 m", 1e-5, "relative");
  WorstError opacity_error("litfog_fog_opacity, GL", "5 knots, rises 0..300 m", 1e-5, "absolute");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const vec4& p = points[i];
    const Fog fog = air.fog_between(double(p.x), double(p.y));
    const auto text = [&] { return describe(p); };
    density_error.add(relative_error(results[i].x, fog.density), text);
    opacity_error.add(std::abs(double(results[i].z) - fog_factor_at(scaled(fog, double(p.w)), double(p.z))), text);
    opacity_error.add(std::abs(double(results[i].y) - opacity_at(scaled(fog, double(p.w)), double(p.z))), text);
  }
  density_error.check();
  opacity_error.check();
}

constexpr double kColorBound = 2e-5;  // for colours up to 8: a two-hundredth of a step of 1/255

TEST_F(FogShader, FogColorAddsTheCarriedLightsToTheAmbient) {
  const std::vector<vec4> points = random_positions();
  for (const FogMode mode : kModes) {
    const Fog fog{mode, 0.02};
    upload_lights(fog);
    const auto results = draw("result = vec4(litfog_fog_color(given(0).xyz), 1.0);", {points});
    WorstError error("litfog_fog_color, GL", "two carried lights and one not", kColorBound, "absolute");
    double brightest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const dvec3 expected = expected_fog_color(fog, dvec3(points[i]));
      brightest = std::max(brightest, expected.r);
      error.add(color_error(results[i], expected), [&] { return describe(points[i]); });
    }
    error.check();
    EXPECT_GT(brightest, kAmbient.r + 0.1) << "the lights are to be seen";
  }
}

TEST_F(FogShader, FragmentInFogMixesSurfaceAndFogByTheEyesRange) {
  const std::vector<vec4> points = random_positions();
  const dvec3 eye{0, 1, 0.5};
  const dvec3 surface{0.75, 0.5, 0.25};
  for (const FogMode mode : kModes) {
    const Fog fog{mode, 0.02};
    upload_lights(fog);
    const auto results = draw(
        "result = vec4(litfog_apply_fog(vec3(0.75, 0.5, 0.25), given(0).xyz, vec3(0.0, 1.0, 0.5)), 1.0);", {points});
    WorstError error("litfog_apply_fog, GL", "range 0.1..100, d = 0.02", kColorBound, "absolute");
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double factor = fog_factor_at(fog, glm::length(dvec3(points[i]) - eye));
      const dvec3 expected = factor * surface + (1 - factor) * expected_fog_color(fog, dvec3(points[i]));
      error.add(color_error(results[i], expected), [&] { return describe(points[i]); });
    }
    error.check();
  }
}

TEST_F(FogShader, FragmentInClearAirIsTheSurface) {
  upload_lights({FogMode::exp, 0});
  const auto points = random_positions();
  for (const vec4& result :
       draw("result = vec4(litfog_apply_fog(vec3(0.75, 0.5, 0.25), given(0).xyz, vec3(0.0, 1.0, 0.5)), 1.0);",
            {points})) {
    ASSERT_EQ(result, vec4(0.75, 0.5, 0.25, 1));
  }
}

}  // namespace
}  // namespace litfog::test
