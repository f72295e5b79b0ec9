// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>
#include <limits>
#include <vector>

#include "gl/shader_test.h"
#include "reference/reference_solver.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

using glm::vec4;

using FormulasShader = ShaderTest;

class OpacityShader : public ShaderTest {
 protected:
  void check(const char* range, double bound, double nearest, double farthest) {
    const auto points =
        random_points([&](Random& random) { return vec4(float(random.log_uniform(nearest, farthest)), 0, 0, 0); });
    const auto results =
        draw("result = vec4(litfog_expm1(-given(0).x), litfog_opacity(given(0).x), 0.0, 0.0);", {points});
    WorstError expm1_error("litfog_expm1, GL", range, bound);
    WorstError opacity_error("litfog_opacity, GL", range, bound);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Digits50 reference = reference_opacity(FogMode::exp, 1, double(points[i].x));
      const auto text = [&] { return describe(points[i]); };
      expm1_error.add(ulp_error(-results[i].x, reference), text);
      opacity_error.add(ulp_error(results[i].y, reference), text);
    }
    expm1_error.check();
    opacity_error.check();
  }
};

TEST_F(OpacityShader, OpacityInThinFogIsExactToFourUlp) {
  check("depth 1e-8..0.6875", 4, 1e-8, 0.6875);
  check("depth 1e-37..1e-8", 4, 1e-37, 1e-8);
  check("depth 0.6..0.6875", 4, 0.6, 0.6875);
}

// GLSL 4.60, 4.7.1: exp is right to 3 + 2 |x| ulp, 4.4 where the two forms meet; an ulp of 1 - exp is half as large
// there.
TEST_F(OpacityShader, OpacityInThickFogIsExactToTheDriversExp) {
  check("depth 0.6876..0.75", 10, 0.6876, 0.75);
  check("depth 0.75..80", 10, 0.75, 80);
}

TEST_F(OpacityShader, OpacityHasNoStepWhereItsTwoFormsMeet) {
  std::vector<vec4> points;
  float depth = 0.6875f;
  for (int i = 0; i < 64; ++i) depth = std::nextafter(depth, 0.0f);
  for (int i = 0; i < 128; ++i, depth = std::nextafter(depth, 1.0f)) points.emplace_back(depth);
  const auto results = draw("result = vec4(litfog_opacity(given(0).x));", {points});
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_NEAR(results[i].x, results[i - 1].x, 16 * 0x1p-25) << describe(points[i]);
  }
}

TEST_F(OpacityShader, OpacityOfNoDepthIsZeroAndOfEndlessDepthOne) {
  const auto results = draw("result = vec4(litfog_opacity(given(0).x));",
                            {{vec4(0), vec4(100), vec4(1e30f), vec4(std::numeric_limits<float>::max()),
                              vec4(std::numeric_limits<float>::infinity())}});
  EXPECT_EQ(results[0].x, 0);
  for (std::size_t i = 1; i < results.size(); ++i) EXPECT_EQ(results[i].x, 1) << i;
}

TEST_F(FormulasShader, AttenuationIsTheLibrarys) {
  std::vector<vec4> ranges;
  const auto coefficients = random_points([&](Random& random) {
    ranges.emplace_back(float(random.log_uniform(1e-3, 1e5)));
    return vec4(random.chance(0.1) ? 0 : random.log_uniform(1e-3, 10),
                random.chance(0.1) ? 0 : random.log_uniform(1e-6, 10), random.log_uniform(1e-9, 10), 0);
  });
  const auto results =
      draw("vec4 c = given(0); result = vec4(litfog_attenuation(given(1).x, c.x, c.y, c.z));", {coefficients, ranges});
  WorstError error("litfog_attenuation, GL", "r 1e-3..1e5, C 0..10", 8);  // 4 roundings, a division to 2.5 ulp
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const vec4& c = coefficients[i];
    error.add(ulp_error(results[i].x, reference_attenuation({c.x, c.y, c.z}, double(ranges[i].x))),
              [&] { return describe(c) + " at " + describe(ranges[i]); });
  }
  error.check();
}

// pow is exp2(y log2 x): with y log2 x up to 8 its error of a few ulp is up to 8 times that of its parts.
TEST_F(FormulasShader, CosineConeIsTheLibrarys) {
  const auto points = random_points([](Random& random) {
    return vec4(random.uniform(-1, 1), random.uniform(0, 1), random.chance(0.1) ? 0 : random.log_uniform(0.1, 8), 0);
  });
  const auto results = draw("vec4 p = given(0); result = vec4(litfog_cosine_cone(p.x, p.y, p.z));", {points});
  WorstError error("litfog_cosine_cone, GL", "cosine -1..1, exponent 0..8", 1e-5, "absolute");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const vec4& p = points[i];
    const double expected = p.x > p.y ? std::pow(double(p.x), double(p.z)) : 0;
    error.add(std::abs(results[i].x - expected), [&] { return describe(p); });
  }
  error.check();
}

TEST_F(FormulasShader, SmoothstepConeIsTheLibrarys) {
  const auto points = random_points([](Random& random) {
    const double outer = random.uniform(-1, 0.9);
    const double inner = random.uniform(outer + 0.05, 1);
    return vec4(random.chance(0.5) ? random.uniform(outer, inner) : random.uniform(-1, 1), inner, outer, 0);
  });
  const auto results = draw("vec4 p = given(0); result = vec4(litfog_smoothstep_cone(p.x, p.y, p.z));", {points});
  // Three roundings of values up to 1 over a width from 0.05 on, times the largest slope 1.5.
  WorstError error("litfog_smoothstep_cone, GL", "cosines -1..1, width 0.05..2", 3 * 0x1p-24 / 0.05 * 1.5, "absolute");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const vec4& p = points[i];
    const double t = std::clamp((double(p.x) - double(p.z)) / (double(p.y) - double(p.z)), 0.0, 1.0);
    error.add(std::abs(results[i].x - t * t * (3 - 2 * t)), [&] { return describe(p); });
  }
  error.check();
}

TEST_F(FormulasShader, EveryProfilesConeIsTheLibrarysAndAnyOtherNumberIsDark) {
  for (const ConeProfileFacts& facts : kConeProfiles) {
    PlacedLight light;
    light.light.cone = facts.first;
    const vec4 packed = pack_fog_light_kind(light, {}).cone_scale_intensity;
    const float number = pack_fog_light_instance(light, 0).axis_profile.w;
    const auto points =
        random_points([&](Random& random) { return vec4(number, random.uniform(-1, 1), packed.x, packed.y); });
    const auto results = draw("vec4 p = given(0); result = vec4(litfog_cone_at(p.x, p.y, p.z, p.w));", {points});
    WorstError error(facts.name, "cosine -1..1", 1e-5, "absolute");
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double cosine = double(points[i].y);
      if (std::abs(cosine - double(packed.x)) < 1e-6) continue;  // where floats round a cut-off
      error.add(std::abs(double(results[i].x) - cone_at(light.light.cone, cosine)),
                [&] { return describe(points[i]); });
    }
    error.check();
  }
  const auto results = draw("vec4 p = given(0); result = vec4(litfog_cone_at(p.x, 1.0, 0.5, 0.5));",
                            {{vec4(float(kConeProfiles.size())), vec4(254), vec4(-1)}});
  for (const vec4& result : results) EXPECT_EQ(result.x, 0);
}

TEST_F(FormulasShader, NarrowSmoothstepConeIsAStep) {
  const auto results = draw("vec4 p = given(0); result = vec4(litfog_smoothstep_cone(p.x, p.y, p.z));",
                            {{vec4(1, 1, 1, 0), vec4(0.99f, 1, 1, 0)}});
  EXPECT_EQ(results[0].x, 1);
  EXPECT_EQ(results[1].x, 0);
}

}  // namespace
}  // namespace litfog::test
