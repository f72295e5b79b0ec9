// SPDX-License-Identifier: Apache-2.0
#include "window/scene_changes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/glm.hpp>

#include "command/temporary_directory.h"
#include "litfog/input_error.h"
#include "scene/file/scene_file.h"

namespace litfog::test {
using namespace window;

namespace {

namespace fs = std::filesystem;
using scene::Scene;
using scene::SceneChange;

class SceneChangesTest : public testing::Test {
 protected:
  SceneChangesTest() {
    fs::create_directory(directory_.path() / "lights");
    write("lights/lamp.json", R"({"litfog": "light", "version": 1, "color": [1, 0.9, 0.8],
        "attenuation": {"constant": 1, "linear": 0.01, "quadratic": 0.002}, "fit": {"rms": 1}})");
    write("scene.json", R"({"litfog": "scene", "version": 1, "camera": {"position": [0, 1, 5], "target": [0, 1, 0]},
        "lights": [{"light": "lights/lamp.json", "position": [0, 2, 0], "repeat": [{"count": 3, "step": [4, 0, 0]}]},
                   {"light": {"attenuation": {"quadratic": 1}, "cone": {"profile": "cosine", "half_angle_deg": 20,
                    "exponent": 2}}, "position": [0, 3, 0], "color": [2, 2, 2]},
                   {"light": "lights/lamp.json", "position": [9, 2, 0]}],
        "objects": []})");
  }
  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
  /// The scene whose file says so, read from another folder.
  Scene saved(const std::optional<scene::Camera>& camera, const std::vector<SceneChange>& changes) const {
    fs::create_directory(directory_.path() / "out");
    write("out/changed.json", changed_scene(path("scene.json"), camera, changes, path("out/changed.json")));
    return scene::read_scene(path("out/changed.json"));
  }

  TemporaryDirectory directory_;
};

void expect_same(const Light& a, const Light& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.attenuation, b.attenuation);
  EXPECT_EQ(a.threshold, b.threshold);
  EXPECT_EQ(a.color, b.color);
  EXPECT_EQ(a.density_scale, b.density_scale);
  EXPECT_EQ(a.cone.profile, b.cone.profile);
  for (const auto angle : {&Cone::half_angle, &Cone::exponent, &Cone::inner, &Cone::outer}) {
    EXPECT_NEAR(a.cone.*angle, b.cone.*angle, 1e-11);
  }
}

Light changed(Light light) {
  light.attenuation = {0.7, 0.03, 1e-7};
  light.threshold = 0.02;
  light.density_scale = 0.4;
  light.cone = Cone::smoothstep(glm::radians(7.0), 0.3);
  light.color = glm::dvec3(glm::vec3(0.1f, 300.0f, 1e-3f));
  return light;
}

TEST_F(SceneChangesTest, OnlyWhatDiffersIsAChange) {
  const PlacedLight light = scene::read_scene(path("scene.json")).lights[0];
  EXPECT_TRUE(changes_of("lights[0]", light, light).empty());
  PlacedLight brighter = light;
  brighter.light.attenuation.quadratic = 0.0005;
  const auto changes = changes_of("lights[7]", light, brighter);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].member, "lights[7].attenuation.quadratic");
  EXPECT_EQ(changes[0].value, "0.0005");
}

TEST_F(SceneChangesTest, ReaderAndSavedFileGiveTheChangedLightBack) {
  const Scene original = scene::read_scene(path("scene.json"));
  for (const std::size_t entry : {0u, 1u}) {
    const std::size_t light = entry == 0 ? 1 : 3;
    PlacedLight wanted = original.lights[light];
    wanted.light = changed(wanted.light);
    const auto changes = changes_of(original.light_members[entry], original.lights[light], wanted);
    for (const Scene& scene : {scene::read_scene(path("scene.json"), {}, changes), saved({}, changes)}) {
      ASSERT_EQ(scene.lights.size(), original.lights.size());
      for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const bool is_changed = (i < 3) == (entry == 0) && i < 4;
        expect_same(scene.lights[i].light, is_changed ? wanted.light : original.lights[i].light);
        EXPECT_EQ(scene.lights[i].position, original.lights[i].position);
      }
    }
  }
}

TEST_F(SceneChangesTest, LightsAreMovedAddedAndRemovedInReadersAndSavedFiles) {
  const Scene original = scene::read_scene(path("scene.json"));
  PlacedLight moved = original.lights[3];
  moved.position = {1, 2, 3};
  moved.direction = glm::normalize(glm::dvec3(1, -1, 0.5));
  PlacedLight added{.light = changed(moved.light), .position = {7, 8, 9}, .direction = {0, -1, 0}, .carried = true};
  added.light.name = "it's new";
  auto changes = changes_of("lights[1]", original.lights[3], moved);
  changes.push_back({"lights[3]", light_entry(added)});
  changes.push_back({"lights[0]", "null"});
  for (const Scene& scene : {scene::read_scene(path("scene.json"), {}, changes), saved({}, changes)}) {
    ASSERT_EQ(scene.lights.size(), 3u);
    EXPECT_EQ(scene.lights[0].position, moved.position);
    EXPECT_LE(glm::distance(scene.lights[0].direction, moved.direction), 1e-15);
    EXPECT_EQ(scene.lights[1].position, original.lights[4].position);
    expect_same(scene.lights[2].light, added.light);
    EXPECT_EQ(scene.lights[2].position, added.position);
    EXPECT_TRUE(scene.lights[2].carried);
  }
}

TEST_F(SceneChangesTest, SavedCameraIsReadBackExactly) {
  const scene::Camera camera{.position = {9999999.1, -2.7, 1e-3}, .target = {3, 1.0 / 3, 2}, .field_of_view = 0.9f};
  const scene::Camera read = saved(camera, {}).camera;
  EXPECT_EQ(read.position, camera.position);
  EXPECT_EQ(read.target, camera.target);
  EXPECT_NEAR(double(read.field_of_view), double(camera.field_of_view), 2e-7);
}

TEST_F(SceneChangesTest, ChangesByHandAreSavedToo) {
  const Scene scene = saved({}, {{"fog_top_m", "40"}, {"lights[2].carried", "true"}, {"name", "fair"}});
  EXPECT_EQ(scene.atmosphere.top, 40);
  EXPECT_TRUE(scene.lights[4].carried);
  EXPECT_EQ(scene.name, "fair");
}

TEST_F(SceneChangesTest, FileThatHasGoneIsAnError) {
  fs::remove(path("lights/lamp.json"));
  EXPECT_THROW(changed_scene(path("scene.json"), {}, {{"lights[0].threshold", "0.1"}}, path("a.json")), InputError);
  EXPECT_THROW(changed_scene(path("none.json"), {}, {}, path("a.json")), InputError);
}

TEST(SceneChanges, BundledScenesAreSavedWithTheSameLightsAndCookies) {
  const TemporaryDirectory directory;
  const std::string place = (directory.path() / "copy.json").string();
  for (const std::string name : {"cookies", "headlights"}) {
    const Scene scene = scene::read_scene(scene::bundled_scene_path(name));
    std::ofstream(place) << changed_scene(scene.files.front(), {}, {}, place);
    const Scene copy = scene::read_scene(place);
    ASSERT_EQ(copy.lights.size(), scene.lights.size()) << name;
    for (std::size_t i = 0; i < copy.lights.size(); ++i) expect_same(copy.lights[i].light, scene.lights[i].light);
    EXPECT_EQ(copy.cookies.size(), scene.cookies.size());
  }
}

}  // namespace

}  // namespace litfog::test
