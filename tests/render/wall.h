// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

#include "render/pixel.h"
#include "scene/model/primitive.h"
#include "scene/scene.h"

namespace litfog::test {

// A wall that fills a picture, to be compared with formulas pixel by pixel.
inline constexpr int kWidth = 96;
inline constexpr int kHeight = 64;
inline constexpr double kWallZ = -5;
inline constexpr glm::dvec3 kAmbientLight{0.1, 0.12, 0.14};
inline constexpr glm::dvec3 kAmbientFogColor{0.02, 0.03, 0.04};
inline constexpr glm::dvec3 kMoonColor{0.05, 0.06, 0.09};
inline const glm::dvec3 kMoonDirection = glm::normalize(glm::dvec3(0.3, 0.4, 0.8));

/// The wall faces +Z, `cells` cells across and as many high. The scene has to be given its material.
inline scene::Scene make_wall(int cells, const std::string& material) {
  scene::Scene scene;
  scene.camera = {.position = {0, 0, 0}, .target = {0, 0, -1}, .field_of_view = 1.0f};
  scene.environment.ambient_light = kAmbientLight;
  scene.atmosphere.ambient_fog_color = kAmbientFogColor;
  scene.environment.moon_direction = kMoonDirection;
  scene.environment.moon_color = kMoonColor;
  std::vector<glm::vec3> points;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      points.emplace_back(12.0f * float(i) / float(cells) - 6, 8.0f * float(j) / float(cells) - 4, 0);
    }
  }
  scene.models.push_back({{material, scene::make_surface(points, cells + 1)}});
  scene.instances.push_back({0, glm::translate(glm::mat4(1), glm::vec3(0, 0, kWallZ))});
  return scene;
}

/// The point of the wall that the middle of a pixel shows.
inline glm::dvec3 wall_point(const scene::Scene& scene, int x, int y) {
  const glm::dvec3 view = view_direction(scene.camera, kWidth, kHeight, x + 0.5, y + 0.5);
  return view * (kWallZ / view.z);
}

}  // namespace litfog::test
