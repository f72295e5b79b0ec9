// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <string>
#include <vector>

#include "gl/formula_pixels.h"
#include "gl/gl_test.h"
#include "litfog/fog_light_block.h"
#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/shader_library.h"
#include "reference/random_light.h"
#include "reference/reference_solver.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

using glm::dvec3;
using glm::vec3;
using glm::vec4;

constexpr int kPoints = 8192;
constexpr std::array kModes{FogMode::exp, FogMode::exp2};
constexpr float kLargestFloat = std::numeric_limits<float>::max();

std::string describe(const vec4& a) {
  char text[128];
  std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g, %.9g)", double(a.x), double(a.y), double(a.z), double(a.w));
  return text;
}

class FormulaPixelsTest : public GlTest {
 protected:
  /// Answers of a formula `vec4 result = ...` to inputs; the text may name given(k) and, after upload(), the block.
  std::vector<vec4> draw(const std::string& statements, const std::vector<std::vector<vec4>>& inputs) {
    const gl::Program program = FormulaPixels::program(
        "#include \"test/input.glsl\"\n#include \"litfog/shaders/fog.glsl\"\n"
        "#include \"litfog/shaders/surface.glsl\"\nvoid main() { " +
        statements + " }\n");
    gl::FogLightBuffer buffer;
    buffer.upload(block_);
    buffer.bind(program, 3);
    return FormulaPixels().draw(program, inputs);
  }

  void upload(const Fog& fog, const dvec3& ambient, const std::vector<PlacedLight>& lights,
              const std::vector<FogIntensity>& solutions) {
    block_ = pack_fog_light_block(fog, ambient, lights, solutions);
  }
  const FogLightBlock& block() const { return block_; }

 private:
  FogLightBlock block_{};
};

/// kPoints random inputs, drawn by draw(random).
template <typename Draw>
std::vector<vec4> random_points(const Draw& draw) {
  Random random(2005);
  std::vector<vec4> points(kPoints);
  for (vec4& point : points) point = draw(random);
  return points;
}

dvec3 random_direction(Random& random) {
  for (;;) {
    const dvec3 v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double length = glm::length(v);
    if (length > 0.1 && length < 1) return v / length;
  }
}

// --- formulas ---

class OpacityPixels : public FormulaPixelsTest {
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

TEST_F(OpacityPixels, AreExactToFourUlpInThinFog) {
  check("depth 1e-8..0.6875", 4, 1e-8, 0.6875);
  check("depth 1e-37..1e-8", 4, 1e-37, 1e-8);
  check("depth 0.6..0.6875", 4, 0.6, 0.6875);
}

// GLSL 4.60, 4.7.1: exp is right to 3 + 2 |x| ulp, 4.4 where the two forms meet; an ulp of 1 - exp is half as large
// there.
TEST_F(OpacityPixels, AreExactToTheDriversExpInThickFog) {
  check("depth 0.6876..0.75", 10, 0.6876, 0.75);
  check("depth 0.75..80", 10, 0.75, 80);
}

TEST_F(OpacityPixels, HaveNoStepWhereTheFormsMeet) {
  std::vector<vec4> points;
  float depth = 0.6875f;
  for (int i = 0; i < 64; ++i) depth = std::nextafter(depth, 0.0f);
  for (int i = 0; i < 128; ++i, depth = std::nextafter(depth, 1.0f)) points.emplace_back(depth);
  const auto results = draw("result = vec4(litfog_opacity(given(0).x));", {points});
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_NEAR(results[i].x, results[i - 1].x, 16 * 0x1p-25) << describe(points[i]);
  }
}

TEST_F(OpacityPixels, OfNoAndOfEndlessDepthAreZeroAndOne) {
  const auto results =
      draw("result = vec4(litfog_opacity(given(0).x));",
           {{vec4(0), vec4(100), vec4(1e30f), vec4(kLargestFloat), vec4(std::numeric_limits<float>::infinity())}});
  EXPECT_EQ(results[0].x, 0);
  for (std::size_t i = 1; i < results.size(); ++i) EXPECT_EQ(results[i].x, 1) << i;
}

TEST_F(FormulaPixelsTest, OfAttenuationAreThoseOfTheLibrary) {
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
TEST_F(FormulaPixelsTest, OfTheCosineConeAreThoseOfTheLibrary) {
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

TEST_F(FormulaPixelsTest, OfTheSmoothstepConeAreThoseOfTheLibrary) {
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

TEST_F(FormulaPixelsTest, OfANarrowSmoothstepConeAreAStep) {
  const auto results = draw("vec4 p = given(0); result = vec4(litfog_smoothstep_cone(p.x, p.y, p.z));",
                            {{vec4(1, 1, 1, 0), vec4(0.99f, 1, 1, 0)}});
  EXPECT_EQ(results[0].x, 1);
  EXPECT_EQ(results[1].x, 0);
}

// --- the block ---

/// Three lights: two carried, of both cones, and one that is not.
std::vector<PlacedLight> three_lights() {
  return {{.light = {.name = "headlight",
                     .color = {1, 0.75, 0.5},
                     .attenuation = {1, 0.02, 0.001},
                     .threshold = 0.05,
                     .cone = Cone::cosine(0.7, 4),
                     .density_scale = 1},
           .position = {-1, 0.5, 0},
           .direction = {0, 0, -1},
           .carried = true},
          {.light = {.name = "fog lamp",
                     .color = {0.5, 0.5, 1},
                     .attenuation = {0.5, 0.1, 0},
                     .threshold = 0.05,
                     .cone = Cone::smoothstep(0.3, 0.9),
                     .density_scale = 0.5},
           .position = {1, 0.25, 0},
           .direction = {0.6, 0, -0.8},
           .carried = true},
          {.light = {.name = "street lamp",
                     .color = {8, 8, 8},
                     .attenuation = {1, 0, 0.01},
                     .threshold = 0.02,
                     .cone = {},
                     .density_scale = 1},
           .position = {0, 6, -20},
           .direction = {0, -1, 0},
           .carried = false}};
}

std::vector<FogIntensity> solve_all(const std::vector<PlacedLight>& lights, const Fog& fog) {
  std::vector<FogIntensity> solutions;
  for (const PlacedLight& light : lights) solutions.push_back(solve_fog_intensity(light.light, fog));
  return solutions;
}

TEST_F(FormulaPixelsTest, ReadEveryNumberOfTheBlockBack) {
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
                 .direction = {n + 12, n + 13, n + 14},
                 .carried = true};
    solutions[i] = {.intensity = n + 15, .peak_range = 0, .extent = n + 16, .status = SolveStatus::ok};
    for (int field = 0; field < 7; ++field) indices.emplace_back(i, field, 0, 0);
  }
  upload({FogMode::exp2, 0.125}, {0.25, 0.5, 0.75}, lights, solutions);
  const auto results = draw(R"(
    LitfogLight light = litfog_lights[int(given(0).x)];
    vec4 fields[7] = vec4[7](light.position_extent, light.axis_profile, light.color_intensity, light.attenuation,
                             light.cone, litfog_fog, litfog_ambient_fog_color);
    result = fields[int(given(0).y)];)",
                            {indices});
  for (std::size_t i = 0; i < results.size(); ++i) {
    const FogLight& light = block().lights[i / 7];
    const vec4 expected[] = {light.position_extent,    light.axis_profile, light.color_intensity,
                             light.attenuation,        light.cone,         block().fog,
                             block().ambient_fog_color};
    EXPECT_EQ(results[i], expected[i % 7]) << "light " << i / 7 << ", field " << i % 7;
  }
}

TEST_F(FormulaPixelsTest, OfALightsRangeEndAtItsExtent) {
  const std::vector<PlacedLight> lights = three_lights();
  const Fog fog{FogMode::exp, 0.01};
  upload(fog, {}, lights, solve_all(lights, fog));
  std::vector<vec4> points;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const float light_extent = block().lights[i].position_extent.w;
    for (const float range :
         {0.0f, 1.0f, light_extent / 2, light_extent, std::nextafter(light_extent, 1e9f), 2 * light_extent, 1e30f}) {
      points.emplace_back(i, range, 0, 0);
    }
  }
  const auto results =
      draw("result = vec4(litfog_range_attenuation(litfog_lights[int(given(0).x)], given(0).y));", {points});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& light = lights[std::size_t(points[i].x)].light;
    const double range = double(points[i].y);
    const double expected = range > double(block().lights[std::size_t(points[i].x)].position_extent.w)
                                ? 0
                                : attenuation_at(light.attenuation, range);
    EXPECT_NEAR(results[i].x, expected, 1e-6) << light.name << " at " << range;
  }
}

TEST_F(FormulaPixelsTest, OfALightWithoutEndNeverEnd) {
  const std::vector<PlacedLight> lights = {
      {.light =
           {.name = {}, .color = dvec3(1), .attenuation = {2, 0, 0}, .threshold = 0.05, .cone = {}, .density_scale = 1},
       .position = dvec3(0),
       .direction = {0, 0, -1},
       .carried = true}};
  const Fog fog{FogMode::exp, 0.01};
  upload(fog, {}, lights, solve_all(lights, fog));
  const auto results = draw(
      "result = vec4(litfog_range_attenuation(litfog_lights[0], given(0).x), litfog_lights[0].color_intensity.w, 0, "
      "0);",
      {{vec4(1), vec4(1e30f), vec4(kLargestFloat)}});
  for (const vec4& result : results) {
    EXPECT_EQ(result.x, 0.5f);
    EXPECT_EQ(result.y, 0.5f);
  }
}

TEST_F(FormulaPixelsTest, OfFogOpacityAreThoseOfTheScaledFog) {
  for (const FogMode mode : kModes) {
    const Fog fog{mode, double(0.0173f)};
    upload(fog, {}, {}, {});
    const auto points = random_points([](Random& random) {
      return vec4(random.log_uniform(1e-2, 1e4), random.pick(std::array{1.0, 0.4, 0.75, 0.0}), 0, 0);
    });
    const auto results = draw("result = vec4(litfog_fog_opacity(given(0).x, given(0).y));", {points});
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

TEST_F(FormulaPixelsTest, OfTotalFogAndOfClearAirAreFinite) {
  for (const FogMode mode : kModes) {
    upload({mode, std::numeric_limits<double>::infinity()}, {}, {}, {});
    const std::vector<std::vector<vec4>> points = {{vec4(1e-3f), vec4(1), vec4(1e5f)}};
    for (const vec4& result : draw("result = vec4(litfog_fog_opacity(given(0).x, 1.0));", points))
      EXPECT_EQ(result.x, 1);
    upload({mode, 0}, {}, {}, {});
    for (const vec4& result : draw("result = vec4(litfog_fog_opacity(given(0).x, 1.0));", points))
      EXPECT_EQ(result.x, 0);
  }
}

/// Share of a light's axial intensity towards a point, in double from the definitions.
double expected_cone(const PlacedLight& light, const dvec3& point) {
  return cone_at(light.light.cone, glm::dot(light.direction, glm::normalize(point - light.position)));
}

/// True where rounding may put a point on the other side of a hard cone's edge.
bool is_at_an_edge(const PlacedLight& light, const dvec3& point) {
  if (light.light.cone.profile != ConeProfile::cosine) return false;
  const double cos_angle = glm::dot(light.direction, glm::normalize(point - light.position));
  return std::abs(cos_angle - std::cos(light.light.cone.half_angle)) < 1e-6;
}

dvec3 expected_fog_color(const std::vector<PlacedLight>& lights, const Fog& fog, const dvec3& ambient,
                         const dvec3& point) {
  dvec3 color = ambient;
  for (const PlacedLight& light : lights) {
    if (!light.carried) continue;
    color += light.light.color * (expected_cone(light, point) * solve_fog_intensity(light.light, fog).intensity);
  }
  return color;
}

double largest_difference(const vec4& actual, const dvec3& expected) {
  const dvec3 difference = glm::abs(dvec3(actual) - expected);
  return std::max({difference.x, difference.y, difference.z});
}

constexpr dvec3 kAmbient{0.125, 0.25, 0.375};
constexpr double kColorBound = 2e-5;  // of colours up to 8: a two-hundredth of a step of 1/255

std::vector<vec4> random_positions(const std::vector<PlacedLight>& lights) {
  return random_points([&](Random& random) {
    for (;;) {
      const vec4 point(vec3(random_direction(random) * random.log_uniform(0.1, 100) + dvec3(0, 0, -5)), 0);
      if (std::ranges::none_of(lights, [&](const auto& light) { return is_at_an_edge(light, dvec3(point)); }))
        return point;
    }
  });
}

TEST_F(FormulaPixelsTest, OfTheFogsColorAddTheCarriedLightsToTheAmbient) {
  const std::vector<PlacedLight> lights = three_lights();
  const std::vector<vec4> points = random_positions(lights);
  for (const FogMode mode : kModes) {
    const Fog fog{mode, 0.02};
    upload(fog, kAmbient, lights, solve_all(lights, fog));
    const auto results = draw("result = vec4(litfog_fog_color(given(0).xyz), 1.0);", {points});
    WorstError error("litfog_fog_color, GL", "two carried lights and one not", kColorBound, "absolute");
    double brightest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const dvec3 expected = expected_fog_color(lights, fog, kAmbient, dvec3(points[i]));
      brightest = std::max(brightest, expected.r);
      error.add(largest_difference(results[i], expected), [&] { return describe(points[i]); });
    }
    error.check();
    EXPECT_GT(brightest, kAmbient.r + 0.1) << "the lights are to be seen";
  }
}

TEST_F(FormulaPixelsTest, OfAFragmentInFogMixSurfaceAndFogByTheEyesRange) {
  const std::vector<PlacedLight> lights = three_lights();
  const std::vector<vec4> points = random_positions(lights);
  const dvec3 eye{0, 1, 0.5};
  const dvec3 surface{0.75, 0.5, 0.25};
  for (const FogMode mode : kModes) {
    const Fog fog{mode, 0.02};
    upload(fog, kAmbient, lights, solve_all(lights, fog));
    const auto results = draw(
        "result = vec4(litfog_apply_fog(vec3(0.75, 0.5, 0.25), given(0).xyz, vec3(0.0, 1.0, 0.5)), 1.0);", {points});
    WorstError error("litfog_apply_fog, GL", "range 0.1..100, d = 0.02", kColorBound, "absolute");
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double factor = fog_factor_at(fog, glm::length(dvec3(points[i]) - eye));
      const dvec3 expected =
          factor * surface + (1 - factor) * expected_fog_color(lights, fog, kAmbient, dvec3(points[i]));
      error.add(largest_difference(results[i], expected), [&] { return describe(points[i]); });
    }
    error.check();
  }
}

TEST_F(FormulaPixelsTest, OfAFragmentInClearAirAreTheSurface) {
  const std::vector<PlacedLight> lights = three_lights();
  upload({FogMode::exp, 0}, kAmbient, lights, solve_all(lights, {FogMode::exp, 0}));
  const auto points = random_positions(lights);
  for (const vec4& result :
       draw("result = vec4(litfog_apply_fog(vec3(0.75, 0.5, 0.25), given(0).xyz, vec3(0.0, 1.0, 0.5)), 1.0);",
            {points})) {
    ASSERT_EQ(result, vec4(0.75, 0.5, 0.25, 1));
  }
}

/// The Basic model of one light, from the Cg Tutorial's formulas, in double.
dvec3 expected_surface(const PlacedLight& light, float light_extent, const dvec3& position, const dvec3& normal,
                       const dvec3& to_eye, const dvec3& diffuse_color, const dvec3& specular_color, double shininess) {
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

TEST_F(FormulaPixelsTest, OfALitSurfaceAreTheBasicModels) {
  const std::vector<PlacedLight> lights = three_lights();
  const Fog fog{FogMode::exp, 0.02};
  upload(fog, kAmbient, lights, solve_all(lights, fog));
  const std::vector<vec4> positions = random_positions(lights);
  std::vector<vec4> to_eyes;
  const auto normals = random_points([&](Random& random) {
    to_eyes.emplace_back(vec3(random_direction(random)), 0);
    return vec4(vec3(random_direction(random)), 0);
  });
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const auto results = draw(
        "LitfogSurface surface = LitfogSurface(given(0).xyz, given(1).xyz, given(2).xyz, vec3(9.0), vec3(0.5, 0.25, "
        "0.125), "
        "vec3(0.25, 0.5, 0.75), 8.0); result = vec4(litfog_light_surface(surface, litfog_lights[" +
            std::to_string(k) + "]), 1.0);",
        {positions, normals, to_eyes});
    WorstError error("litfog_light_surface, GL", lights[k].light.name, 1e-4, "absolute");
    int lit = 0;
    int dark = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const dvec3 position(positions[i]);
      const dvec3 to_light = glm::normalize(lights[k].position - position);
      const float light_extent = block().lights[k].position_extent.w;
      // Where a bright side begins, or the extent is, rounding decides.
      if (std::abs(glm::dot(dvec3(normals[i]), to_light)) < 1e-6) continue;
      if (std::abs(glm::length(lights[k].position - position) - double(light_extent)) < 1e-4) continue;
      const dvec3 expected = expected_surface(lights[k], light_extent, position, dvec3(normals[i]), dvec3(to_eyes[i]),
                                              {0.5, 0.25, 0.125}, {0.25, 0.5, 0.75}, 8);
      error.add(largest_difference(results[i], expected),
                [&] { return describe(positions[i]) + " normal " + describe(normals[i]); });
      if (expected == dvec3(0)) {
        ++dark;
        EXPECT_EQ(vec3(results[i]), vec3(0)) << describe(positions[i]);
      } else {
        ++lit;
      }
    }
    error.check();
    EXPECT_GT(lit, 100) << lights[k].light.name;
    EXPECT_GT(dark, 100) << lights[k].light.name;
  }
}

TEST_F(FormulaPixelsTest, OfTheAmbientTermAreEmissionAndReflectedAmbientLight) {
  const auto results = draw(
      "LitfogSurface surface = LitfogSurface(vec3(0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.125, 0.25, "
      "0.5), "
      "vec3(0.5, 0.25, 0.125), vec3(1.0), 8.0); result = vec4(litfog_ambient(surface, vec3(1.0, 2.0, 4.0)), 1.0);",
      {{vec4(0)}});
  EXPECT_EQ(results[0], vec4(0.625, 0.75, 1, 1));
}

TEST_F(FormulaPixelsTest, AtALightItselfAreFinite) {
  for (const Cone& cone : {Cone{}, Cone::cosine(0.5, 3), Cone::smoothstep(0.2, 0.5)}) {
    std::vector<PlacedLight> lights = {three_lights().front()};
    lights.front().light.cone = cone;
    const Fog fog{FogMode::exp, 0.1};
    upload(fog, kAmbient, lights, solve_all(lights, fog));
    const auto results = draw(
        "vec3 position = given(0).xyz; LitfogSurface surface = LitfogSurface(position, vec3(0.0, 1.0, 0.0), vec3(0.0, "
        "0.0, 1.0), "
        "vec3(0.0), vec3(0.5), vec3(0.5), 8.0); result = vec4(litfog_fog_color(position).r, "
        "litfog_apply_fog(vec3(0.5), "
        "position, vec3(0.0)).r, litfog_light_surface(surface, litfog_lights[0]).r, 1.0);",
        {{vec4(vec3(lights.front().position), 0)}});
    EXPECT_TRUE(results[0].x >= 0 && results[0].y >= 0) << describe(results[0]);
    EXPECT_EQ(results[0].z, 0) << "turned to no side";
  }
}

// --- the owners ---

class FogLightLayout : public GlTest {
 protected:
  /// What check_fog_light_layout says of a program with this uniform block.
  static std::string refusal_of_block(const std::string& block) {
    const gl::Program program =
        FormulaPixels::program(block +
                               "out vec4 result;\nvoid main() { result = litfog_fog + litfog_ambient_fog_color + "
                               "litfog_lights[int(gl_FragCoord.x)].cone; }\n");
    try {
      gl::check_fog_light_layout(program);
    } catch (const gl::Unsupported& refusal) {
      return refusal.what();
    }
    return "accepted";
  }
};

TEST_F(FogLightLayout, OfTheDriverIsOurs) {
  EXPECT_EQ(refusal_of_block("#include \"litfog/shaders/light_block.glsl\"\n"), "accepted");
}

TEST_F(FogLightLayout, WithSwappedMembersIsRefused) {
  EXPECT_EQ(refusal_of_block(R"(
struct LitfogLight { vec4 axis_profile; vec4 position_extent; vec4 color_intensity; vec4 attenuation; vec4 cone; };
layout(std140) uniform LitfogLightBlock { vec4 litfog_fog; vec4 litfog_ambient_fog_color; LitfogLight litfog_lights[128]; };
)"),
            "LitfogLightBlock: the driver puts litfog_lights[0].position_extent at byte 48, std140 has it at 32");
}

TEST_F(FogLightLayout, WithAMemberTooManyIsRefused) {
  EXPECT_EQ(refusal_of_block(R"(
struct LitfogLight { vec4 position_extent; vec4 axis_profile; vec4 color_intensity; vec4 attenuation; vec4 cone, extra; };
layout(std140) uniform LitfogLightBlock { vec4 litfog_fog; vec4 litfog_ambient_fog_color; LitfogLight litfog_lights[128]; };
)"),
            "LitfogLightBlock: the driver puts litfog_lights[1].position_extent at byte 128, std140 has it at 112");
}

TEST_F(FogLightLayout, WithSwappedFogAndAmbientColorIsRefused) {
  EXPECT_EQ(refusal_of_block(R"(
struct LitfogLight { vec4 position_extent; vec4 axis_profile; vec4 color_intensity; vec4 attenuation; vec4 cone; };
layout(std140) uniform LitfogLightBlock { vec4 litfog_ambient_fog_color; vec4 litfog_fog; LitfogLight litfog_lights[128]; };
)"),
            "LitfogLightBlock: the driver puts litfog_fog at byte 16, std140 has it at 0");
}

TEST_F(FogLightLayout, WithTooFewLightsIsRefused) {
  EXPECT_EQ(refusal_of_block(R"(
struct LitfogLight { vec4 position_extent; vec4 axis_profile; vec4 color_intensity; vec4 attenuation; vec4 cone; };
layout(std140) uniform LitfogLightBlock { vec4 litfog_fog; vec4 litfog_ambient_fog_color; LitfogLight litfog_lights[64]; };
)"),
            "LitfogLightBlock: the driver puts litfog_lights[127].position_extent at byte -1, std140 has it at 10192");
}

class ProgramTest : public GlTest {
 protected:
  /// Why a program of these files is refused.
  static std::string refusal_of_files(const std::vector<gl::ShaderSource>& files,
                                      const char* vertex = "test/row.vert") {
    std::vector<gl::ShaderSource> all = {FormulaPixels::kVertexShader};
    all.insert(all.end(), files.begin(), files.end());
    try {
      gl::Program(vertex, "a.frag", all);
    } catch (const std::logic_error& refusal) {
      return refusal.what();
    }
    return "accepted";
  }
};

/// Mesa writes 1:2(3), NVIDIA 1(2).
bool names_place(const std::string& message, int file, int line) {
  const std::string number = std::to_string(line);
  return message.find(std::to_string(file) + ":" + number + "(") != std::string::npos ||
         message.find(std::to_string(file) + "(" + number + ")") != std::string::npos;
}

TEST_F(ProgramTest, NamesFileAndLineOfACompileErrorInAnIncludedFile) {
  const std::string message =
      refusal_of_files({{"a.frag", "// first\n#include \"b.glsl\"\nvoid main() {}\n"},
                        {"b.glsl", "float one() { return 1.0; }\nfloat two() { return ); }\n"}});
  EXPECT_NE(message.find("shader a.frag does not compile:"), std::string::npos) << message;
  EXPECT_NE(message.find("0 = a.frag 1 = b.glsl"), std::string::npos) << message;
  EXPECT_TRUE(names_place(message, 1, 2)) << message;
}

TEST_F(ProgramTest, NamesTheLineOfACompileErrorBehindAnInclude) {
  const std::string message =
      refusal_of_files({{"a.frag", "// first\n#include \"b.glsl\"\nvoid main() {\n  no_such = 1.0;\n}\n"},
                        {"b.glsl", "\n\n\n\n\n\n\n"}});
  EXPECT_TRUE(names_place(message, 0, 4)) << message;
}

TEST_F(ProgramTest, RefusesAMissingInclude) {
  EXPECT_EQ(refusal_of_files({{"a.frag", "#include \"no_such.glsl\"\nvoid main() {}\n"}}),
            "no shader file no_such.glsl");
  EXPECT_EQ(refusal_of_files({{"a.frag", "void main() {}\n"}}, "no_such.vert"), "no shader file no_such.vert");
}

TEST_F(ProgramTest, RefusesShadersThatDoNotFit) {
  const std::string message = refusal_of_files(
      {{"a.vert", "uniform vec4 shared_value;\nvoid main() { gl_Position = shared_value; }\n"},
       {"a.frag", "uniform vec3 shared_value;\nout vec4 color;\nvoid main() { color = shared_value.xyzz; }\n"}},
      "a.vert");
  EXPECT_NE(message.find("shaders a.vert and a.frag do not link:"), std::string::npos) << message;
}

TEST_F(ProgramTest, TakesAFileInOnce) {
  EXPECT_EQ(refusal_of_files({{"a.frag",
                               "#include \"b.glsl\"\n#include \"c.glsl\"\n#include \"b.glsl\"\nout vec4 color;\n"
                               "void main() { color = vec4(one() + two()); }\n"},
                              {"b.glsl", "float one() { return 1.0; }\n"},
                              {"c.glsl", "#include \"b.glsl\"\nfloat two() { return 2.0 * one(); }"}}),
            "accepted");
}

TEST_F(ProgramTest, FindsItsUniforms) {
  const gl::Program program =
      FormulaPixels::program("uniform float used;\nout vec4 result;\nvoid main() { result = vec4(used); }\n");
  EXPECT_GE(program.uniform("used"), 0);
  EXPECT_EQ(program.uniform("no_such"), -1);
}

TEST_F(ProgramTest, OfEachShaderOfTheLibraryCompilesByItself) {
  for (const gl::ShaderSource& source : gl::shader_library()) {
    const std::string text =
        "#include \"" + std::string(source.name) + "\"\nout vec4 result;\nvoid main() { result = vec4(1.0); }\n";
    EXPECT_NO_THROW(FormulaPixels::program(text)) << source.name;
  }
}

TEST_F(GlTest, ContextNamesItsRendererAndGivesThreeThreeCore) {
  std::printf("%s, %s\n", context().renderer().c_str(), context().version().c_str());
  EXPECT_FALSE(context().renderer().empty());
  EXPECT_GE(epoxy_gl_version(), 33);
  GLint profile = 0;
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
}

TEST_F(GlTest, CheckErrorsNamesErrorAndPlaceOnce) {
  glEnable(GLenum(0xffff));
  try {
    gl::check_errors("an unknown capability");
    ADD_FAILURE() << "no error";
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "OpenGL error 1280 after an unknown capability");
  }
  EXPECT_NO_THROW(gl::check_errors("it"));
}

TEST(ShaderLibrary, HoldsTheInstalledFiles) {
  for (const char* name : {"litfog/shaders/expm1.glsl", "litfog/shaders/fog.glsl", "litfog/shaders/formulas.glsl",
                           "litfog/shaders/light.glsl", "litfog/shaders/surface.glsl"}) {
    const auto found = std::ranges::find(gl::shader_library(), name, &gl::ShaderSource::name);
    ASSERT_NE(found, gl::shader_library().end()) << name;
    EXPECT_TRUE(found->text.starts_with("// SPDX-License-Identifier: Apache-2.0")) << name;
  }
}

}  // namespace
}  // namespace litfog::test
