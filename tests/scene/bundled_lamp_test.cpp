// SPDX-License-Identifier: Apache-2.0
#include "scene/file/scene_file.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace litfog::test {
using namespace scene;

namespace {

/// The materials of the lenses that lie within 0.1 m of a point.
std::vector<std::string> lenses_at(const Scene& scene, const glm::vec3& point) {
  std::vector<std::string> lenses;
  for (const Instance& instance : scene.instances) {
    const glm::vec3 in_model(glm::inverse(instance.world_from_model) * glm::dvec4(point, 1));
    for (const Part& part : scene.models[instance.model]) {
      if (!part.material.starts_with("lamp_")) continue;
      const Bounds box = bounds(part.mesh);
      const glm::vec3 nearest = glm::clamp(in_model, box.low, box.high);
      if (glm::distance(nearest, in_model) < 0.1f) lenses.push_back(part.material);
    }
  }
  return lenses;
}

TEST(BundledLamps, ApproachLampsHaveLensesOfTheirColor) {
  const Scene scene = read_scene(bundled_scene_path("approach"));
  int red = 0;
  int white = 0;
  for (const PlacedLight& light : scene.lights) {
    if (!light.light.name.starts_with("approach") || light.position.z < 0) continue;
    const bool is_red = light.light.color.g < 0.5 * light.light.color.r;
    ++(is_red ? red : white);
    EXPECT_EQ(lenses_at(scene, light.position), std::vector<std::string>{is_red ? "lamp_red" : "lamp_white"})
        << light.light.name << " at " << light.position.x << ", " << light.position.z;
  }
  EXPECT_EQ(red, 54);
  EXPECT_EQ(white, 168);
}

TEST(BundledLamps, LampsOfStreetsAndOfTheLighthouseAreAtTheirLenses) {
  const std::map<std::string, std::string> lenses{{"street lamp, sodium", "lamp_sodium"},
                                                  {"headlight, lower beam", "lamp_white"},
                                                  {"position light, left, red", "lamp_red"},
                                                  {"tail lamp, 10 cd", "lamp_red"},
                                                  {"aerobeacon DCB-224", "lamp_white"}};
  for (const char* name : {"city", "street", "lighthouse"}) {
    const Scene scene = read_scene(bundled_scene_path(name));
    for (const PlacedLight& light : scene.lights) {
      if (light.light.name.starts_with("shop")) continue;
      EXPECT_EQ(lenses_at(scene, light.position), std::vector<std::string>{lenses.at(light.light.name)})
          << light.light.name << " at " << light.position.x << ", " << light.position.z;
    }
  }
}

}  // namespace
}  // namespace litfog::test
