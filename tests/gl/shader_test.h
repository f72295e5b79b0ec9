// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "gl/formula_pixels.h"
#include "gl/gl_test.h"
#include "litfog/fog_light_block.h"
#include "litfog/gl/fog_light_buffer.h"
#include "reference/random_light.h"

namespace litfog::test {

inline std::string describe(const glm::vec4& a) {
  char text[128];
  std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g, %.9g)", double(a.x), double(a.y), double(a.z), double(a.w));
  return text;
}

/// The members of the LitfogLight that a kind and an instance make, in order.
inline std::array<glm::vec4, 5> shader_light(const FogLightKind& kind, const FogLightInstance& instance) {
  const auto& [attenuation, cone] = kind;
  return {glm::vec4(glm::vec3(instance.position_kind), attenuation.w), instance.axis_profile,
          glm::vec4(glm::vec3(instance.color), cone.w), glm::vec4(glm::vec3(attenuation), cone.z),
          glm::vec4(cone.x, cone.y, 0, 0)};
}

/// A test of litfog's shaders, evaluated by the driver.
class ShaderTest : public GlTest {
 protected:
  static constexpr int kPoints = 8192;

  /// Answers of the statements `result = ...`, which may call litfog's functions on given(k) and the uploaded block.
  std::vector<glm::vec4> draw(const std::string& statements, const std::vector<std::vector<glm::vec4>>& inputs) {
    const gl::Program program = FormulaPixels::program(
        "#include \"test/input.glsl\"\n#include \"litfog/shaders/fog.glsl\"\n"
        "#include \"litfog/shaders/directional_airlight.glsl\"\n"
        "#include \"litfog/shaders/surface.glsl\"\nvoid main() { " +
        statements + " }\n");
    gl::FogLightBuffer buffer;
    buffer.upload(block_);
    buffer.bind(program, 3);
    return FormulaPixels().draw(program, inputs);
  }

  void upload(const Fog& fog, const glm::dvec3& ambient, std::span<const PlacedLight> lights,
              std::span<const FogIntensity> solutions) {
    block_ = pack_fog_light_block({.fog = fog, .ambient_fog_color = ambient}, lights, solutions);
  }
  void upload(const Atmosphere& atmosphere) { block_ = pack_fog_light_block(atmosphere, {}, {}); }
  const FogLightBlock& block() const { return block_; }

  /// kPoints inputs, each drawn by draw_point(random).
  template <typename Draw>
  static std::vector<glm::vec4> random_points(const Draw& draw_point) {
    Random random(2005);
    std::vector<glm::vec4> points(kPoints);
    for (glm::vec4& point : points) point = draw_point(random);
    return points;
  }

 private:
  FogLightBlock block_{};
};

}  // namespace litfog::test
