// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "gl/shader_test.h"
#include "litfog/cone.h"
#include "litfog/fog_light_block.h"

namespace litfog::test {

/// Three lights: two carried, of both cones, and one that is not.
inline std::vector<PlacedLight> three_lights() {
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

inline std::vector<FogIntensity> solve_all(std::span<const PlacedLight> lights, const Fog& fog) {
  std::vector<FogIntensity> solutions;
  for (const PlacedLight& light : lights) solutions.push_back(solve_fog_intensity(light.light, fog));
  return solutions;
}

/// A test of what the three lights do to random points.
class ExampleLightsTest : public ShaderTest {
 protected:
  static constexpr glm::dvec3 kAmbient{0.125, 0.25, 0.375};

  const std::vector<PlacedLight> lights_ = three_lights();

  void upload_lights(const Fog& fog) { upload(fog, kAmbient, lights_, solve_all(lights_, fog)); }

  /// Fraction of a light's axial intensity towards a point, in double from the definitions.
  static double expected_cone(const PlacedLight& light, const glm::dvec3& point) {
    return cone_at(light.light.cone, glm::dot(light.direction, glm::normalize(point - light.position)));
  }

  /// Points of which none is so near the edge of a hard cone that rounding may put it on the other side.
  std::vector<glm::vec4> random_positions() const {
    return random_points([&](Random& random) {
      for (;;) {
        const glm::dvec3 drawn = draw_direction(random) * random.log_uniform(0.1, 100) + glm::dvec3(0, 0, -5);
        const glm::vec4 point(glm::vec3(drawn), 0);
        if (std::ranges::none_of(lights_, [&](const auto& light) { return is_at_an_edge(light, glm::dvec3(point)); }))
          return point;
      }
    });
  }

  /// NaN where a channel is NaN.
  static double color_error(const glm::vec4& actual, const glm::dvec3& expected) {
    return glm::length(glm::dvec3(actual) - expected);
  }

 private:
  static bool is_at_an_edge(const PlacedLight& light, const glm::dvec3& point) {
    if (light.light.cone.profile != ConeProfile::cosine) return false;
    const double cos_angle = glm::dot(light.direction, glm::normalize(point - light.position));
    return std::abs(cos_angle - std::cos(light.light.cone.half_angle)) < 1e-6;
  }
};

}  // namespace litfog::test
