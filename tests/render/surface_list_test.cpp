// SPDX-License-Identifier: Apache-2.0
#include "render/surface/surface_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <span>
#include <string>

#include "gl/gl_test.h"
#include "litfog/attenuation.h"
#include "render/light/light_finder.h"
#include "scene/file/scene_file.h"
#include "scene/model/model_catalogue.h"
#include "scene/paint/material_catalogue.h"

namespace litfog::test {
using namespace render;
using namespace scene;

namespace {

class SurfaceListTest : public test::GlTest {};

/// Boxes and lamps along a street.
Scene street(int boxes, int lamps) {
  Scene scene;
  scene.models = {make_model("box", {{"width_m", 1}, {"depth_m", 1}, {"height_m", 1}})};
  for (int i = 0; i < boxes; ++i) {
    scene.instances.push_back({0, glm::translate(glm::mat4(1), glm::vec3(0, 0, float(i)))});
  }
  for (int i = 0; i < lamps; ++i) {
    PlacedLight lamp;
    lamp.light.attenuation = {1, 0, 1};
    lamp.position = {2, 5, 1.5 * i};
    scene.lights.push_back(lamp);
  }
  add_materials(scene);
  return scene;
}

TEST_F(SurfaceListTest, LampsLightEverySurfaceByAirlightAndEndByPeak) {
  const Scene scene = street(100, 40);
  const SceneLights endless(scene, {.fog_lighting = FogLighting::airlight});
  const SurfaceList list(scene, endless, Skipping::on);
  EXPECT_TRUE(std::isinf(list.reach()));
  for (const Surface& surface : list.surfaces()) EXPECT_EQ(list.lights_of(surface).size(), 40u);
  const SceneLights ending(scene, {.fog_lighting = FogLighting::peak});
  const SurfaceList short_list(scene, ending, Skipping::on);
  EXPECT_EQ(short_list.reach(), 1);
  EXPECT_LT(short_list.lists().size(), list.lists().size() / 2);
}

TEST_F(SurfaceListTest, LampsEndFarAwayWhereListsWouldGrowTooLongWithoutEnds) {
  const Scene scene = street(3000, 2000);
  const SceneLights lights(scene, {.fog_lighting = FogLighting::airlight});
  const SurfaceList list(scene, lights, Skipping::on);
  EXPECT_EQ(list.reach(), 16);  // without an end all lamps reach all boxes: 6,000,000
  EXPECT_LE(list.lists().size(), std::size_t{1} << 22);
  const Surface& surface = list.surfaces()[list.surfaces().size() / 2];
  std::ptrdiff_t reaching = 0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    reaching += can_reach(lights.lights()[i], list.range_of(lights.extents()[i]), surface.bounds);
  }
  EXPECT_EQ(std::ssize(list.lights_of(surface)), reaching);
}

/// Upper bound of the light that any surface lacks in clear air because lamps end at their reach, of white: each lamp's
/// at the point of the surface's bounds that is nearest to it.
double most_left_out(const SurfaceList& list, const SceneLights& lights) {
  double most = 0;
  for (const Surface& surface : list.surfaces()) {
    const std::span<const std::int32_t> listed = list.lights_of(surface);
    double left_out = 0;
    for (std::size_t i = 0; i < lights.local_count(); ++i) {
      if (std::ranges::binary_search(listed, std::int32_t(i))) continue;
      const PlacedLight& lamp = lights.lights()[i];
      const double range = nearest_distance(lamp.position, surface.bounds);
      if (range < list.range_of(lights.extents()[i])) continue;  // its cone misses the surface
      left_out += largest_component(lamp.light.color) * attenuation_at(lamp.light.attenuation, range);
    }
    most = std::max(most, left_out);
  }
  return most;
}

TEST_F(SurfaceListTest, LampsOfCityAndApproachAloneEndFarAway) {
  for (const std::string& name : scene::bundled_scenes()) {
    const Scene scene = scene::read_scene(scene::bundled_scene_path(name));
    const SceneLights lights(scene, {.fog_lighting = FogLighting::airlight});
    const SurfaceList list(scene, lights, Skipping::on);
    const double reach = list.reach();
    EXPECT_EQ(reach, name == "approach" ? 16 : name == "city" ? 8 : std::numeric_limits<double>::infinity()) << name;
    if (std::isinf(reach)) continue;
    const double most = most_left_out(list, lights);
    std::printf("%s: no surface lacks more than %.2f/255 of white\n", name.c_str(), 255 * most);
    EXPECT_LE(255 * most, name == "approach" ? 0.5 : 3.7) << name;
  }
}

}  // namespace
}  // namespace litfog::test
