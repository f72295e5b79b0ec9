// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "gl/formula_pixels.h"
#include "gl/gl_test.h"
#include "litfog/attenuation.h"
#include "litfog/cone.h"
#include "litfog/fog_light_block.h"
#include "litfog/gl/fog_light_buffer.h"
#include "reference/random_airlight.h"

namespace litfog::test {
namespace {

class AirlightShader : public GlTest {};

constexpr int kRays = 8000;
constexpr double kFarthest = 4e5;    // fog scales to the lamp: of larger ranges, a float has too few digits
constexpr double kNarrowest = 0.02;  // radians: of narrower cones, a float has too few digits of the cosine

constexpr double kDim = 1e-5;  // fraction of white, a thirtieth of a step of the display: less is rounding of floats

/// A case as the shader's floats hold it: the same lamp, fog and ray, seen from the origin along -z.
struct ShaderCase {
  AirlightCase exact;
  std::array<glm::vec4, 6> members;  // LitfogAirlight's members, in order, the phase's lobes last; in layers see there
};

double rounded(double x) { return double(float(x)); }

ShaderCase shader_case(const AirlightCase& drawn) {
  const Light& light = drawn.light.light;
  const glm::dvec3 to_light = drawn.light.position - drawn.ray.origin;
  const double approach = rounded(glm::dot(to_light, drawn.ray.direction));
  const glm::dvec3 from_light = glm::dot(to_light, drawn.ray.direction) * drawn.ray.direction - to_light;
  const double offset = rounded(glm::length(from_light));
  AirlightCase exact = drawn;
  exact.ray = {.origin = {0, 0, 0}, .direction = {0, 0, -1}, .length = rounded(std::min(drawn.ray.length, 1e30))};
  exact.light.position = {offset, 0, -approach};
  exact.atmosphere.fog.density = rounded(drawn.atmosphere.fog.density);
  Attenuation& attenuation = exact.light.light.attenuation;
  attenuation = {rounded(attenuation.constant), rounded(attenuation.linear), rounded(attenuation.quadratic)};
  const double extent = compute_extent(attenuation, light.threshold);

  const double axis_slope = rounded(glm::dot(drawn.light.direction, drawn.ray.direction));
  const double outwards = glm::dot(drawn.light.direction, from_light);
  const double most = offset * std::sqrt(std::max(1 - axis_slope * axis_slope, 0.0)) * (1 - 1e-6);
  const double axis_offset = rounded(std::clamp(outwards, -most, most));
  const double across = offset > 0 ? -axis_offset / offset : 0;
  const double rest = 1 - axis_slope * axis_slope - across * across;
  exact.light.direction = glm::normalize(glm::dvec3(across, std::sqrt(std::max(rest, 0.0)), -axis_slope));

  Cone& cone = exact.light.light.cone;
  glm::vec2 cosines(0);
  if (cone.profile == ConeProfile::cosine) {
    cosines = {std::cos(cone.half_angle), cone.exponent};
    cone = Cone::cosine(std::acos(double(cosines.x)), double(cosines.y));
  } else if (cone.profile == ConeProfile::smoothstep) {
    cosines = {std::cos(cone.outer), std::cos(cone.inner)};
    cone = Cone::smoothstep(std::acos(double(cosines.y)), std::acos(double(cosines.x)));
  }
  const auto lobes = pack_fog_header(exact.atmosphere, 0).phase_lobes;
  return {exact,
          {glm::vec4(exact.atmosphere.fog.density, exact.atmosphere.fog.mode == FogMode::exp ? 0 : 1,
                     drawn.lamp_leg == LampLeg::fogged ? 1 : 0, 0),
           glm::vec4(attenuation.constant, attenuation.linear, attenuation.quadratic, std::min(extent, 1e30)),
           glm::vec4(int(cone.profile), cosines, exact.ray.length),
           glm::vec4(approach, offset, axis_offset, axis_slope), lobes[0], lobes[1]}};
}

std::vector<double> draw(const gl::Program& program, const std::vector<ShaderCase>& cases) {
  std::vector<std::vector<glm::vec4>> inputs(6);
  for (const ShaderCase& c : cases) {
    for (std::size_t row = 0; row < 6; ++row) inputs[row].push_back(c.members[row]);
  }
  std::vector<double> airlights;
  for (const glm::vec4& result : FormulaPixels().draw(program, inputs)) airlights.push_back(double(result.x));
  return airlights;
}

std::vector<double> draw(const std::vector<ShaderCase>& cases) {
  return draw(
      FormulaPixels::program(
          "#define LITFOG_KNOT_COUNT 0\n#include \"test/input.glsl\"\n#include \"litfog/shaders/airlight.glsl\"\n"
          "LitfogPhaseLobe lobe(vec4 x) { return LitfogPhaseLobe(x.x, x.y, x.z, x.w); }\n"
          "void main() { vec4 a = given(0), b = given(1), c = given(2), d = given(3);\n"
          "LitfogPhase phase = LitfogPhase(lobe(given(4)), lobe(given(5)));\n"
          "result = vec4(litfog_airlight(LitfogAirlight(a.x, a.y, a.z, phase, b.x, b.y, b.z, b.w, c.x, c.y, c.z, c.w,\n"
          "d.x, d.y, d.z, d.w, 0.0, 0.0, 0.0, 0.0, 0.0))); }\n"),
      cases);
}

void expect_stated_errors(const std::vector<ShaderCase>& cases, const std::vector<double>& airlights,
                          const std::string& what, double most = kAirlightMaxError) {
  double largest = 0;  // relative to the lamp's colour, or to the airlight where that is brighter
  std::string worst;
  std::vector<double> relative;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const AirlightCase& c = cases[i].exact;
    const double reference = picture_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg);
    ASSERT_TRUE(std::isfinite(airlights[i])) << what << ": " << to_string(c);
    const double error = std::abs(airlights[i] - reference);
    const double share = error / std::max(reference, 1.0);
    if (share > largest) {
      largest = share;
      worst = to_string(c);
    }
    if (reference > kDim) relative.push_back(error / reference);
  }
  std::ranges::sort(relative);
  const double typical = relative[relative.size() * 99 / 100];
  const std::string measured =
      fmt::format("{}: largest {:.3f}/255, 99 % within {:.2f} %", what, 255 * largest, 100 * typical);
  fmt::print("{}\n", measured);
  EXPECT_LE(largest, most) << measured << worst;
  EXPECT_LE(typical, kAirlightTypicalError) << measured;
}

std::vector<ShaderCase> draw_cases(Random& random, FogMode mode, LampLeg leg, bool is_spot, bool is_isotropic) {
  std::vector<ShaderCase> cases;
  while (cases.size() < kRays) {
    AirlightCase drawn = is_spot ? draw_spot_airlight_case(random, mode, leg) : draw_airlight_case(random, mode, leg);
    if (is_spot && cutoff_angle(drawn.light.light.cone) <= kNarrowest) continue;
    if (glm::distance(drawn.light.position, drawn.ray.origin) * drawn.atmosphere.fog.density > kFarthest) continue;
    if (!is_isotropic) drawn.atmosphere.phase = draw_phase(random);
    cases.push_back(shader_case(drawn));
  }
  return cases;
}

TEST_F(AirlightShader, AirlightInFloatsHasItsStatedErrors) {
  Random random(77);
  for (const FogMode mode : kModes) {
    for (const LampLeg leg : kLampLegs) {
      for (const bool is_spot : {false, true}) {
        const std::string what =
            fmt::format("{}, {}, k = {}", is_spot ? "spots" : "points", name_of(mode), leg == LampLeg::fogged ? 1 : 0);
        const auto isotropic = draw_cases(random, mode, leg, is_spot, true);
        expect_stated_errors(isotropic, draw(isotropic), what);
        const auto lobes = draw_cases(random, mode, leg, is_spot, false);
        const bool is_shaped = mode == FogMode::exp && leg == LampLeg::fogged && !is_spot;
        expect_stated_errors(lobes, draw(lobes), what + ", lobes",
                             is_shaped ? kShapedAirlightMaxError : kAirlightMaxError);
      }
    }
  }
}

/// A lamp in or near layers, and a ray: eye and length, direction and quadratic attenuation, lamp and extent, axis and
/// profile, the cone's cosines.
ShaderCase draw_layered_case(Random& random, const Atmosphere& atmosphere, bool is_spot) {
  const auto draw_vector = [&](double size) {
    const glm::dvec3 direction = draw_direction(random);  // a statement each: compilers order operands differently
    return glm::vec3(size * random.uniform(0, 1) * direction);
  };
  const glm::vec3 eye = draw_vector(60), lamp = draw_vector(30), direction(draw_direction(random));
  const glm::vec3 axis(draw_direction(random));
  const float length = float(random.log_uniform(1, 500)), quadratic = float(random.log_uniform(1e-4, 1));
  AirlightCase exact{.light = {}, .atmosphere = atmosphere, .ray = {}};
  Light& light = exact.light.light;
  light.attenuation = {1, 0, double(quadratic)};
  light.threshold = 1e-3;
  glm::vec2 cosines(0);
  if (is_spot) {
    cosines = {float(random.uniform(-0.9, 0.9)), float(random.uniform(0.91, 0.99))};
    light.cone = Cone::smoothstep(std::acos(double(cosines.y)), std::acos(double(cosines.x)));
  }
  exact.light.position = glm::dvec3(lamp);
  exact.light.direction = glm::normalize(glm::dvec3(axis));
  exact.ray = {glm::dvec3(eye), glm::normalize(glm::dvec3(direction)), double(length)};
  const double extent = compute_extent(light.attenuation, light.threshold);
  return {exact,
          {glm::vec4(eye, length), glm::vec4(direction, quadratic), glm::vec4(lamp, extent),
           glm::vec4(axis, int(light.cone.profile)), glm::vec4(cosines, 0, 0), glm::vec4(0)}};
}

TEST_F(AirlightShader, AirlightInLayersInFloatsHasItsStatedErrors) {
  const std::array<DensityKnot, 4> knots{{{-3, 0.02}, {0, 0.3}, {2, 0}, {40, 0.01}}};
  Random random(79);
  for (const Phase& phase : {Phase{}, Phase::droplets(10)}) {
    const Atmosphere atmosphere{
        .fog = {FogMode::exp, double(1e-4f)}, .phase = phase, .profile = make_density_profile(knots)};
    const gl::Program program = FormulaPixels::program(
        "#include \"test/input.glsl\"\n#include \"litfog/shaders/light_airlight.glsl\"\n"
        "void main() { vec4 eye = given(0), ray = given(1), lamp = given(2), axis = given(3);\n"
        "vec3 to_lamp = lamp.xyz - eye.xyz; float approach = dot(to_lamp, ray.xyz);\n"
        "vec3 offset = approach * ray.xyz - to_lamp;\n"
        "result = vec4(litfog_airlight(LitfogAirlight(litfog_fog.x, litfog_fog_mode(), 1.0, litfog_fog_phase(), 1.0, "
        "0.0,\n"
        "ray.w, lamp.w, axis.w, given(4).x, given(4).y, eye.w, approach, length(offset), dot(offset, axis.xyz),\n"
        "dot(ray.xyz, axis.xyz), 0.0, 1.0, eye.y + approach * ray.y, ray.y, lamp.y))); }\n");
    gl::FogLightBuffer buffer;
    buffer.upload(pack_fog_light_block(atmosphere, {}, {}));
    buffer.bind(program, 3);
    for (const bool is_spot : {false, true}) {
      std::vector<ShaderCase> cases;
      while (cases.size() < kRays) cases.push_back(draw_layered_case(random, atmosphere, is_spot));
      const bool is_shaped = !is_isotropic(phase) && !is_spot;
      expect_stated_errors(cases, draw(program, cases), is_spot ? "spots in layers" : "points in layers",
                           is_shaped ? kShapedAirlightMaxError : kLayeredAirlightMaxError);
    }
  }
}

// Points seen through fog whose density changes over one stretch of heights. What is counted is how often the lamp's
// law is asked for, once for each node, and both legs' optical depth, for each node and in the search for steps.
TEST_F(AirlightShader, RaysThroughOneRampAreEvaluatedAFewDozenTimes) {
  const std::array<DensityKnot, 2> knots{{{0, 0.1}, {4, 0}}};
  Random random(80);
  for (const Phase& phase : {Phase{}, Phase::droplets(10)}) {
    const Atmosphere atmosphere{.fog = {FogMode::exp, 0}, .phase = phase, .profile = make_density_profile(knots)};
    const gl::Program program = FormulaPixels::program(
        "#include \"test/input.glsl\"\n#include \"litfog/shaders/formulas.glsl\"\n"
        "#include \"litfog/shaders/density_profile.glsl\"\n"
        "float nodes = 0.0, depths = 0.0;\n"
        "float counted_law(float r, float c, float l, float q) { ++nodes; return litfog_attenuation(r, c, l, q); }\n"
        "float counted_mean(float a, float b) { depths += 0.5; return litfog_mean_density(a, b); }\n"
        "#define litfog_attenuation counted_law\n#define litfog_mean_density counted_mean\n"
        "#include \"litfog/shaders/light_airlight.glsl\"\n"
        "void main() { vec4 eye = given(0), ray = given(1), lamp = given(2);\n"
        "vec3 to_lamp = lamp.xyz - eye.xyz; float approach = dot(to_lamp, ray.xyz);\n"
        "result.x = litfog_airlight(LitfogAirlight(litfog_fog.x, litfog_fog_mode(), 1.0, litfog_fog_phase(), 1.0,\n"
        "0.0, ray.w, lamp.w, 0.0, 0.0, 0.0, eye.w, approach, length(approach * ray.xyz - to_lamp), 0.0, 0.0, 0.0,\n"
        "1.0, eye.y + approach * ray.y, ray.y, lamp.y));\n"
        "result.yz = vec2(nodes, depths); }\n");
    gl::FogLightBuffer buffer;
    buffer.upload(pack_fog_light_block(atmosphere, {}, {}));
    buffer.bind(program, 3);
    std::vector<std::vector<glm::vec4>> inputs(3);
    for (int i = 0; i < kRays; ++i) {
      const ShaderCase c = draw_layered_case(random, atmosphere, false);
      for (std::size_t row = 0; row < 3; ++row) inputs[row].push_back(c.members[row]);
    }
    std::vector<float> nodes, depths;
    for (const glm::vec4& result : FormulaPixels().draw(program, inputs)) {
      if (!(result.x > 0)) continue;
      nodes.push_back(result.y);
      depths.push_back(result.z);
    }
    ASSERT_GT(nodes.size(), std::size_t(kRays / 4));
    const auto part = [](std::vector<float>& counts, double fraction) {
      std::ranges::sort(counts);
      return counts[std::size_t(fraction * double(counts.size() - 1))];
    };
    fmt::print("{}: nodes {}, {} and {}, depths {}, {} and {}: median, of 9 in 10, most\n",
               is_isotropic(phase) ? "isotropic" : "droplets", part(nodes, 0.5), part(nodes, 0.9), part(nodes, 1),
               part(depths, 0.5), part(depths, 0.9), part(depths, 1));
    EXPECT_LE(part(nodes, 0.5), 12);
    EXPECT_LE(part(nodes, 0.9), 36);
  }
}

}  // namespace
}  // namespace litfog::test
