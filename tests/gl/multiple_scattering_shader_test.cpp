// SPDX-License-Identifier: Apache-2.0
#include "litfog/multiple_scattering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "gl/formula_pixels.h"
#include "gl/gl_test.h"
#include "litfog/fog_light_block.h"
#include "litfog/gl/fog_light_buffer.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

using glm::vec4;

class MultipleScatteringShader : public GlTest {};

gl::TextureName linear_texture(int unit, GLint format, GLsizei width, GLsizei height, GLenum channels,
                               const void* texels) {
  gl::TextureName texture;
  glActiveTexture(GLenum(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, channels, GL_FLOAT, texels);
  for (const auto filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D, GLenum(filter), GL_LINEAR);
  }
  for (const auto wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    glTexParameteri(GL_TEXTURE_2D, GLenum(wrap), GL_CLAMP_TO_EDGE);
  }
  return texture;
}

/// A point lamp and two cones, of laws with 1 / r^2 or of softer ones, as shaders know them.
struct Lamps {
  ScatteringTable table;
  std::array<Light, 3> lights;
  std::array<ScatteringSource, 3> sources;
  gl::TextureName logs, cones;

  Lamps(const Atmosphere& air, bool is_soft) : table(make_scattering_table(air)) {
    const ThinBeams thin = make_thin_beams(air, table);
    for (Light& light : lights) light.attenuation = {.constant = 0, .linear = 0, .quadratic = 1e8};
    lights[1].cone = Cone::smoothstep(0.1, 0.4);
    lights[2].cone = Cone::smoothstep(0.5, 1.5);
    if (is_soft) lights[0].attenuation = lights[1].attenuation = {.constant = 1, .linear = 0, .quadratic = 2};
    for (std::size_t i = 0; i < 3; ++i) sources[i] = scattering_source(lights[i], air, thin);
    const std::array beams{sources[1].beam, sources[2].beam};
    logs = linear_texture(1, GL_R32F, kScatteringAngles, kScatteringDepths, GL_RED, table.logs.data());
    cones = linear_texture(2, GL_RGBA32F, kBeamAngles, 2 * kBeamDepths, GL_RGBA, beams.data());
  }

  void set(const gl::Program& program) const {
    program.use();
    glUniform1i(program.uniform("litfog_scattering_table"), 1);
    glUniform1i(program.uniform("litfog_scattered_beams"), 2);
    for (std::size_t i = 0; i < 3; ++i) {
      glUniform1f(program.uniform(("soft_ranges[" + std::to_string(i) + "]").c_str()), float(sources[i].soft_range));
    }
  }
};

// Lamps are seen along rays in fog of density 1; what they scatter on a surface that faces them is drawn, too.
TEST_F(MultipleScatteringShader, IsThatOfTheLibrary) {
  for (const auto& [phase, is_soft] : {std::pair{Phase{}, false},
                                       {Phase::droplets(10), false},
                                       {Phase{}, true},
                                       {Phase::droplets(10), true},
                                       {Phase::henyey_greenstein(0.9), true}}) {
    const Atmosphere air{.fog = {FogMode::exp, 1}, .phase = phase};
    const Lamps known(air, is_soft);
    const auto& [table, lights, sources, logs, cones] = known;
    Random random(4205);
    std::array<std::vector<vec4>, 2> inputs;
    std::vector<EyeRay> rays;
    std::vector<PlacedLight> lamps;
    for (int i = 0; i < 3000; ++i) {
      const auto kind = std::size_t(i % 3);
      const double depth = random.log_uniform(0.03, 8), angle = random.uniform(0.02, std::numbers::pi);
      const double aim = random.uniform(0, 2 * std::numbers::pi);
      const double length = random.chance(0.5) ? 1e30 : random.log_uniform(0.1, 10);
      PlacedLight lamp{
          .light = lights[kind], .position = {0, 0, -depth}, .direction = {std::sin(aim), 0, std::cos(aim)}};
      const EyeRay ray{.direction = {std::sin(angle), 0, -std::cos(angle)}, .length = length};
      const double approach = depth * std::cos(angle);
      const glm::dvec3 offset = approach * ray.direction - lamp.position;
      inputs[0].emplace_back(length, approach, glm::length(offset), glm::dot(offset, lamp.direction));
      inputs[1].emplace_back(glm::dot(ray.direction, lamp.direction), double(kind) - 1, sources[kind].phase_cosine,
                             lamp.direction.z);
      rays.push_back(ray);
      lamps.push_back(lamp);
    }
    const gl::Program program = FormulaPixels::program(
        "#define LITFOG_KNOT_COUNT 0\n#include \"test/input.glsl\"\n"
        "#include \"litfog/shaders/multiple_scattering.glsl\"\n"
        "#include \"litfog/shaders/diffuse_light.glsl\"\n"
        "uniform vec4 lobes[2];\n"
        "uniform float soft_ranges[3];\n"
        "LitfogPhaseLobe lobe(vec4 x) { return LitfogPhaseLobe(x.x, x.y, x.z, x.w); }\n"
        "void main() { vec4 a = given(0), b = given(1);\n"
        "LitfogPhase phase = LitfogPhase(lobe(lobes[0]), lobe(lobes[1]));\n"
        "LitfogAirlight air = LitfogAirlight(1.0, 0.0, 1.0, phase, 0.0, 0.0, 1.0, 1e30, 0.0, 0.0, 0.0, a.x,\n"
        "a.y, a.z, a.w, b.x, 0.0, 0.0, 0.0, 0.0, 0.0);\n"
        "float soft_range = soft_ranges[int(b.y) + 1];\n"
        "result = vec4(b.y < 0.0 ? litfog_multiple_scattering(air, soft_range)\n"
        "                        : litfog_multiple_scattering(air, soft_range, b.y, b.z));\n"
        "LitfogScatteredLight light =\n"
        "    litfog_scattered_light(1.0, length(a.yz), soft_range, max(b.y, 0.0), b.w, b.z);\n"
        "result.y = litfog_diffuse_irradiance(light.all, length(vec2(light.radial, light.turned)), light.radial); }\n");
    known.set(program);
    const auto lobes = pack_fog_header(air, 0).phase_lobes;
    glUniform4fv(program.uniform("lobes"), 2, &lobes[0].x);
    const auto results = FormulaPixels().draw(program, {inputs[0], inputs[1]});
    double largest = 0, largest_on_surfaces = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
      const ScatteringSource& source = sources[i % 3];
      ASSERT_TRUE(std::isfinite(results[i].x) && std::isfinite(results[i].y)) << i;
      const double expected = multiple_scattering(lamps[i], source, air, table, rays[i]) / source.intensity;
      // Rays that end are differences of the endless ones.
      EyeRay endless = rays[i];
      endless.length = 1e30;
      const double whole = multiple_scattering(lamps[i], source, air, table, endless) / source.intensity;
      largest = std::max(largest, std::abs(double(results[i].x) - expected) / whole);
      if (i % 3 == 0) continue;
      const DiffuseLight scattered = scattered_light(lamps[i], source, air, {});
      const double received = irradiance(scattered, {0, 0, -1}) / source.intensity;
      largest_on_surfaces = std::max(largest_on_surfaces, std::abs(double(results[i].y) - received) / received);
    }
    std::printf("largest error %.2g of the endless ray's, %.2g on surfaces\n", largest, largest_on_surfaces);
    EXPECT_LE(largest, 0.005);
    EXPECT_LE(largest_on_surfaces, 0.005);
  }
}

// Lamps and eyes in a layer with ramps, above and below it.
TEST_F(MultipleScatteringShader, InLayersIsThatOfTheLibrary) {
  for (const auto& [phase, is_soft] : {std::pair{Phase{}, false}, {Phase::droplets(10), false}, {Phase{}, true}}) {
    Atmosphere air{.fog = {FogMode::exp, double(0.01f)}, .phase = phase};
    air.profile = make_density_profile(std::array<DensityKnot, 4>{{{-1, 0}, {0, 1}, {2, 1}, {4, 0}}});
    const Lamps known(air, is_soft);
    const gl::Program program = FormulaPixels::program(
        "#include \"test/input.glsl\"\n"
        "#include \"litfog/shaders/layered_scattering.glsl\"\n"
        "uniform float soft_ranges[3];\n"
        "void main() { vec4 eye = given(0), ray = given(1), lamp = given(2), axis = given(3);\n"
        "vec3 to_lamp = lamp.xyz - eye.xyz; float approach = dot(to_lamp, ray.xyz);\n"
        "vec3 offset = approach * ray.xyz - to_lamp;\n"
        "result = vec4(litfog_layered_scattering(LitfogAirlight(litfog_fog.x, litfog_fog_mode(), 1.0,\n"
        "litfog_fog_phase(), 0.0, 0.0, 1.0, 1e30, 0.0, 0.0, 0.0, eye.w, approach, length(offset),\n"
        "dot(offset, axis.xyz), dot(ray.xyz, axis.xyz), 0.0, 1.0, eye.y + approach * ray.y, ray.y, lamp.y),\n"
        "soft_ranges[int(ray.w) + 1], ray.w, axis.w)); }\n");
    known.set(program);
    gl::FogLightBuffer buffer;
    buffer.upload(pack_fog_light_block(air, {}, {}));
    buffer.bind(program, 3);
    Random random(4206);
    std::array<std::vector<vec4>, 4> inputs;
    std::vector<double> expected, endless;
    for (int i = 0; i < 1500; ++i) {
      const auto kind = std::size_t(i % 3);
      const ScatteringSource& source = known.sources[kind];
      const glm::vec3 eye(0, random.uniform(-2, 6), 0), to(draw_direction(random)), axis(draw_direction(random));
      const glm::vec3 lamp(0, random.uniform(-2, 6), -random.log_uniform(0.1, 8));
      const float length = random.chance(0.5) ? 1e30f : float(random.log_uniform(0.1, 10));
      inputs[0].emplace_back(eye, length);
      inputs[1].emplace_back(to, float(kind) - 1);
      inputs[2].emplace_back(lamp, 0);
      inputs[3].emplace_back(axis, source.phase_cosine);
      const PlacedLight light{.light = known.lights[kind],
                              .position = glm::dvec3(lamp),
                              .direction = glm::normalize(glm::dvec3(axis))};
      EyeRay ray{.origin = glm::dvec3(eye), .direction = glm::normalize(glm::dvec3(to)), .length = double(length)};
      expected.push_back(multiple_scattering(light, source, air, known.table, ray) / source.intensity);
      ray.length = 1e30;
      endless.push_back(multiple_scattering(light, source, air, known.table, ray) / source.intensity);
    }
    const auto results = FormulaPixels().draw(program, {inputs[0], inputs[1], inputs[2], inputs[3]});
    double largest = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
      ASSERT_TRUE(std::isfinite(results[i].x)) << i;
      if (endless[i] > 0) largest = std::max(largest, std::abs(double(results[i].x) - expected[i]) / endless[i]);
    }
    std::printf("largest error in layers %.2g of the endless ray's\n", largest);
    EXPECT_LE(largest, 0.005);
  }
}

}  // namespace
}  // namespace litfog::test
