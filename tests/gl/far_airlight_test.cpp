// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/far_airlight.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/value_errors.h"
#include "gl/formula_pixels.h"
#include "gl/gl_test.h"
#include "litfog/airlight.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

using glm::dvec3;
using glm::vec4;

constexpr int kFarLamps = 150;
constexpr std::size_t kFarRays = 60;
constexpr double kEndless = 1e-9;  // threshold of a lamp without an end

class FarAirlight : public GlTest {
 protected:
  FarAirlight() {
    Random random(9);
    for (int i = 0; i < kFarLamps; ++i) {
      PlacedLight lamp;
      lamp.light.attenuation = {1, 0, random.uniform(0.02, 0.1)};
      lamp.light.threshold = 0.01;
      lamp.light.color = dvec3(random.uniform(1, 5), random.uniform(1, 5), random.uniform(0, 5));
      if (i % 3 == 0) lamp.light.cone = Cone::smoothstep(0.6, 1.2);
      if (i % 3 == 1) lamp.light.cone = Cone::cosine(1.5, 2);
      lamp.position = {random.uniform(-300, 300), random.uniform(3, 30), random.uniform(-300, 20)};
      lamp.direction = {0, -1, 0};
      lamps_.push_back(lamp);
    }
    for (std::size_t i = 0; i < kFarRays; ++i) {
      inputs_.emplace_back(random.uniform(0, 1), random.uniform(0, 1), random.log_uniform(10, 400), 0);
    }
  }

  /// What all lamps add beyond their extents along a ray of inputs_, in double, lamp by lamp.
  dvec3 reference(const Atmosphere& atmosphere, const vec4& input) const {
    const EyeRay ray{.origin = view_.eye,
                     .direction = glm::normalize(dvec3(2 * input.x - 1, 2 * input.y - 1, -1)),
                     .length = double(input.z)};
    dvec3 sum(0);
    for (PlacedLight lamp : lamps_) {
      const double within = litfog::reference_airlight(lamp, atmosphere, ray);
      lamp.light.threshold = kEndless;
      sum +=
          lamp.light.color * (airlight_unit(atmosphere) * (litfog::reference_airlight(lamp, atmosphere, ray) - within));
    }
    return sum;
  }

  std::vector<vec4> look_up(const Atmosphere& atmosphere) {
    FogUpdater updater;
    for (const PlacedLight& lamp : lamps_) updater.add(lamp);
    const FogLightChanges changes = updater.set_fog(atmosphere.fog);
    gl::FogLightTables tables;
    tables.upload(updater.kinds(), updater.instances(), changes);
    gl::FarAirlight far;
    far.draw(view_, atmosphere, tables, lamps_.size());

    const gl::VertexArrayName vertices;
    glBindVertexArray(vertices.id());
    const gl::Program program = FormulaPixels::program(R"(
#include "litfog/shaders/far_airlight.glsl"
#include "test/input.glsl"
uniform vec3 eye;
uniform int lamps;
void main() {
  vec3 direction = normalize(vec3(2.0 * given(0).xy - 1.0, -1.0));
  result.rgb = litfog_far_airlight(given(0).xy, eye, direction, given(0).z);
  for (int i = 0; i < lamps; ++i) {
    LitfogLight light = litfog_buffered_light(i);
    result.rgb += litfog_airlight_unit() * light.color_intensity.rgb *
                  litfog_far_peak(litfog_light_airlight_ray(light, eye, direction, given(0).z));
  }
}
)");
    gl::FogLightBuffer block;
    block.upload(pack_fog_header(atmosphere, 0));
    block.bind(program, 3);
    program.use();
    glUniform3f(program.uniform("eye"), float(view_.eye.x), float(view_.eye.y), float(view_.eye.z));
    glUniform1i(program.uniform("lamps"), kFarLamps);
    tables.bind_textures(program, 1, 2);
    far.bind(program, 3);
    return FormulaPixels().draw(program, {inputs_});
  }

  const View view_{.eye = {5, 10, 3}, .farthest = 400};
  std::vector<PlacedLight> lamps_;
  std::vector<vec4> inputs_;
};

TEST_F(FarAirlight, SumIsThatOfEachLampBeyondItsExtent) {
  const Fog thin{FogMode::exp, 0.003};
  const std::array kKnots{DensityKnot{15, 0.03}, DensityKnot{25, 0.001}};
  const struct {
    std::string name;
    Atmosphere atmosphere;
    double mean, largest;  // errors, fractions of the brightest
  } cases[] = {{"thin", {.fog = thin}, 0.01, 0.06},
               {"thick", {.fog = {FogMode::exp, 0.03}}, 0.01, 0.06},
               {"exp2", {.fog = {FogMode::exp2, 0.006}}, 0.01, 0.06},
               {"layered", Atmosphere{.fog = thin, .profile = make_density_profile(kKnots)}, 0.05, 0.15},
               {"droplets", {.fog = thin, .phase = Phase::droplets(10), .albedo = 0.9}, 0.01, 0.06}};
  for (const auto& [name, atmosphere, most_mean, most] : cases) {
    const std::vector<vec4> sums = look_up(atmosphere);
    double brightest = 0, sum = 0, largest = 0;
    for (std::size_t i = 0; i < kFarRays; ++i) {
      const dvec3 exact = reference(atmosphere, inputs_[i]);
      const dvec3 error = glm::abs(dvec3(sums[i]) - exact);
      brightest = std::max(brightest, std::max({exact.r, exact.g, exact.b}));
      sum += (error.r + error.g + error.b) / 3;
      largest = std::max(largest, std::max({error.r, error.g, error.b}));
    }
    const double mean = sum / kFarRays;
    fmt::print("{:<10}brightest {:.4f}, mean error {:.5f}, largest error {:.5f}\n", name, brightest, mean, largest);
    EXPECT_LE(mean, most_mean * brightest) << name;
    EXPECT_LE(largest, most * brightest) << name;
  }
}

TEST_F(FarAirlight, DrawingKeepsProgramFramebufferVertexArrayAndViewport) {
  const gl::Program program =
      FormulaPixels::program("#include \"test/input.glsl\"\nvoid main() { result = vec4(1.0); }\n");
  const gl::FramebufferName framebuffer;
  const gl::VertexArrayName vertices;
  glBindVertexArray(vertices.id());
  program.use();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glViewport(1, 2, 3, 4);
  FogUpdater updater;
  updater.add(lamps_[0]);
  gl::FogLightTables tables;
  tables.upload(updater.kinds(), updater.instances(), updater.set_fog({FogMode::exp, 0.01}));
  gl::FarAirlight({4, 3}).draw(view_, {.fog = {FogMode::exp, 0.01}}, tables, 1);
  GLint state[7] = {};
  glGetIntegerv(GL_CURRENT_PROGRAM, &state[0]);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &state[1]);
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &state[2]);
  glGetIntegerv(GL_VIEWPORT, &state[3]);
  EXPECT_EQ(std::to_array(state),
            (std::array{GLint(program.id()), GLint(framebuffer.id()), GLint(vertices.id()), 1, 2, 3, 4}));
}

TEST_F(FarAirlight, RefusesAGridOfOneRay) {
  EXPECT_EQ(error_of([] { gl::FarAirlight({1, 18}); }), "grid = 1: must be in [2, 512]");
  EXPECT_EQ(error_of([] { gl::FarAirlight({32, 513}); }), "grid = 513: must be in [2, 512]");
}

}  // namespace
}  // namespace litfog::test
