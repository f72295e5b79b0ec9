// SPDX-License-Identifier: Apache-2.0
#include "window/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string_view>

#include "command/temporary_directory.h"
#include "litfog/files/light_file.h"
#include "scene/file/scene_file.h"
#include "scene/gltf_bytes.h"
#include "window/visibility_preset.h"

namespace litfog::test {
using namespace window;

namespace {

const scene::Scene& street_scene() {
  static const scene::Scene scene = scene::read_scene(scene::bundled_scene_path("street"));
  return scene;
}

Session street(const drawing::SceneOptions& given = {.scene = "street"}) { return {given, street_scene(), {}}; }

TEST(Session, BeginsWithTheScenesVisibilityAndNothingChanged) {
  const Session session = street();
  EXPECT_EQ(session.settings[0].visibility, 120);
  EXPECT_TRUE(session.changes().empty());
  EXPECT_EQ(to_string(session.command(0, 320, 180)), "litfog-demo street --visibility 120 --size 320x180");
}

TEST(Session, RunwayVisualRangeBecomesAVisibility) {
  drawing::DrawingOptions options;
  options.runway_visual_range = 550;
  const Session session({.scene = "street"}, street_scene(), options);
  EXPECT_NEAR(session.settings[0].visibility.value_or(0), 155, 0.5);
  EXPECT_NEAR(runway_visual_range(session.fog(0), options.runway_lights), 550, 1e-9);
}

TEST(Session, PresetsOfCategoriesAreRunwayVisualRangesByAnyContrast) {
  const RunwayLights dim{.candela = 10, .illuminance_threshold = 1e-3};  // seen for 100 m in clear air
  for (const VisibilityPreset& preset : kVisibilityPresets) {
    const bool is_category = std::string_view(preset.name).starts_with("CAT");
    EXPECT_EQ(preset.is_runway_visual_range, is_category);
    for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
      for (const double contrast : {kContrastMor, kContrastFlightgear}) {
        const double metres = preset.visibility(mode, contrast).value();
        if (is_category) {
          EXPECT_NEAR(runway_visual_range(Fog::from_visibility(mode, metres, contrast)), preset.metres, 1e-9);
        } else {
          EXPECT_EQ(metres, preset.metres);
        }
      }
    }
    EXPECT_EQ(preset.visibility(FogMode::exp, 0.05, dim).has_value(), !is_category || preset.metres <= 100);
  }
}

TEST(Session, ChangedLightTakesItsCopiesAlongAndIsReset) {
  Session session = street();
  PlacedLight light = session.lights()[2];
  light.light.attenuation.quadratic = 0.5;
  session.change(2, light);
  EXPECT_EQ(session.copies(2), 6u);
  for (std::size_t i = 0; i < session.lights().size(); ++i) {
    EXPECT_EQ(session.is_changed(i), i < 6) << i;
    EXPECT_EQ(session.lights()[i].light.attenuation.quadratic == 0.5, i < 6) << i;
  }
  const auto changes = session.changes();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].member + "=" + changes[0].value, "lights[0].attenuation.quadratic=0.5");
  session.reset(5);
  EXPECT_TRUE(session.changes().empty());
}

TEST(Session, MovedLightTakesItsCopiesAlong) {
  Session session = street();
  PlacedLight light = session.lights()[2];
  light.position += glm::dvec3(1, 0, -2);
  session.change(2, light);
  for (std::size_t i = 0; i < session.lights().size(); ++i) {
    const glm::dvec3 step = session.lights()[i].position - session.scene().lights[i].position;
    EXPECT_LE(glm::distance(step, i < 6 ? glm::dvec3(1, 0, -2) : glm::dvec3(0)), 1e-12) << i;
  }
  EXPECT_EQ(session.changes()[0].member, "lights[0].position");
}

TEST(Session, AllChangesBetweenTwoEndsAreOneStepThatIsUndoneAndRedone) {
  Session session = street();
  EXPECT_FALSE(session.can_undo());
  PlacedLight light = session.lights()[0];
  for (const double quadratic : {0.5, 0.6}) {
    light.light.attenuation.quadratic = quadratic;
    session.change(0, light);
  }
  session.end_step();
  session.reset(0);
  session.end_step();
  EXPECT_FALSE(session.is_changed(0));
  session.undo();
  EXPECT_EQ(session.lights()[0].light.attenuation.quadratic, 0.6);
  session.undo();
  EXPECT_FALSE(session.has_changes());
  EXPECT_FALSE(session.can_undo());
  session.redo();
  EXPECT_EQ(session.lights()[0].light.attenuation.quadratic, 0.6);
  session.end_step();
  session.change(0, session.scene().lights[0]);  // another future
  EXPECT_FALSE(session.can_redo());
  session.reset_all();
  EXPECT_FALSE(session.has_changes());
}

TEST(Session, AddedAndRemovedLightsAreThoseOfTheCommandsScene) {
  Session session = street();
  const std::size_t count = session.lights().size();
  session.add(session.lights()[0]);
  EXPECT_EQ(session.picked, count);
  EXPECT_TRUE(session.is_changed(count));
  PlacedLight moved = session.lights()[count];
  moved.position = {3, 2, 1};
  session.change(count, moved);
  EXPECT_EQ(session.lights()[0].position, session.scene().lights[0].position);  // no copy of it
  session.end_step();
  session.remove(0);
  EXPECT_EQ(session.picked, count);
  EXPECT_EQ(session.firsts().front(), 6u);
  const scene::Scene again = scene::read_scene(scene::bundled_scene_path("street"), {}, session.changes());
  ASSERT_EQ(again.lights.size(), count - 6 + 1);
  EXPECT_EQ(again.lights.back().position, moved.position);
  EXPECT_EQ(again.lights[0].position, session.scene().lights[6].position);
  session.undo();
  session.undo();
  EXPECT_FALSE(session.has_changes());
  EXPECT_FALSE(session.picked);  // it is gone
}

TEST(Session, OrderDiffersWhereThePictureMay) {
  Session session = street();
  const PictureOrder order = session.order(100, 50, false);
  EXPECT_EQ(order, session.order(100, 50, false));
  EXPECT_NE(order, session.order(100, 51, false));
  session.camera.position.x += 1;
  EXPECT_NE(order, session.order(100, 50, false));
  session.camera = session.scene().camera;
  session.settings[1].visibility = 9;  // which nobody sees
  EXPECT_EQ(order, session.order(100, 50, false));
  session.settings[0].display.tone = render::ToneCurve::clip;
  EXPECT_NE(order, session.order(100, 50, false));
  session.settings[0].display.tone = render::ToneCurve::neutral;
  session.change(0, session.lights()[0]);
  EXPECT_NE(order, session.order(100, 50, false));  // it may be another
}

TEST(Session, SplitViewBeginsWithTwoOfTheSameAndKeepsB) {
  Session session = street();
  session.settings[0].visibility = 77;
  session.split(true);
  EXPECT_EQ(session.settings[1].visibility, 77);
  EXPECT_EQ(session.edited, 1u);
  EXPECT_EQ(session.order(9, 9, false).settings.size(), 2u);
  session.edited_settings().visibility = 20;
  session.split(false);
  EXPECT_EQ(session.edited, 0u);
  EXPECT_EQ(session.order(9, 9, false).settings.size(), 1u);
  session.split(true);
  EXPECT_EQ(session.settings[1].visibility, 20);
}

TEST(Session, CommandHasTheGivenAndTheMovedCamera) {
  Session session = street({.scene = "street", .changes = {{"fog_top_m", "40"}}, .target = glm::dvec3(0, 2, -40)});
  const std::string given = to_string(session.command(0, 8, 8));
  EXPECT_NE(given.find("--target"), std::string::npos) << given;
  EXPECT_NE(given.find("--set fog_top_m=40"), std::string::npos) << given;
  const Session city = street({.scene = "city", .city_lights = 40});  // saved scenes have them, too
  EXPECT_NE(to_string(city.command(0, 8, 8)).find("--set city.lights=40"), std::string::npos);
  ASSERT_EQ(city.changes().size(), 1u);
  EXPECT_EQ(city.changes()[0].member, "city.lights");
  Session other = street();
  EXPECT_FALSE(other.own_camera());
  other.camera.field_of_view = 1;
  EXPECT_TRUE(other.own_camera());
}

TEST(Session, LightsOfACityChangeWithAllOfTheirKind) {
  const std::string path = scene::bundled_scene_path("city");
  const scene::Scene city = scene::read_scene(path);
  Session session({.scene = "city"}, city, {});
  const std::size_t last = city.lights.size() - 1;
  PlacedLight light = city.lights[last];
  const auto kind = std::size_t(
      std::ranges::count_if(city.lights, [&](const PlacedLight& each) { return each.light.name == light.light.name; }));
  EXPECT_EQ(session.copies(last), kind);
  EXPECT_EQ(session.firsts().size(), 4u);
  light.light.threshold = 0.2;
  session.change(last, light);
  const auto changes = session.changes();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].member + "=" + changes[0].value, "city.shop_window.threshold=0.2");
  const scene::Scene again = scene::read_scene(path, {}, changes);
  for (std::size_t i = 0; i <= last; ++i) {
    EXPECT_EQ(again.lights[i].light.threshold, session.lights()[i].light.threshold) << i;
  }
}

TEST(Session, LightsOfAGltfFileMoveComeAndGoAndTheReaderAgrees) {
  const TemporaryDirectory directory;
  const std::string path = (directory.path() / "floor.gltf").string();
  json file = floor_scene();
  file["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(floor_bytes());
  std::ofstream(path) << file;
  Session session({.scene = path}, scene::read_scene(path), {});
  ASSERT_EQ(session.lights().size(), 1u);
  PlacedLight light = session.lights()[0];
  light.position = {1, 2, 3};
  session.change(0, light);
  session.end_step();
  session.add(light);
  EXPECT_EQ(scene::read_scene(path, {}, session.changes()).lights.at(0).position, light.position);
  session.end_step();
  session.remove(0);
  const scene::Scene again = scene::read_scene(path, {}, session.changes());
  ASSERT_EQ(again.lights.size(), 1u);
  EXPECT_EQ(again.lights[0].position, light.position);
  EXPECT_EQ(again.lights[0].direction, light.direction);
  EXPECT_EQ(format_light(again.lights[0].light), format_light(light.light));
  for (int i = 0; i < 3; ++i) session.undo();
  EXPECT_FALSE(session.has_changes());
}

TEST(Session, LightOfACityMovesAndGoesAloneAndTheReaderAgrees) {
  const std::string path = scene::bundled_scene_path("city");
  scene::Scene scene = scene::read_scene(path);
  const std::vector<PlacedLight> given = scene.lights;
  drawing::SceneOptions options{.scene = "city"};
  // The same twice: of the scene as it is, and of the one that the first changes give.
  for (const std::size_t before : {0u, 2u}) {
    Session session(options, scene, {});
    const std::size_t count = session.lights().size();
    session.picked = 5;
    PlacedLight light = session.lights()[5];
    for (const double x : {1.0, 2.0}) {  // a drag
      light.position = {x, 9, 4};
      session.change(*session.picked, light);
    }
    EXPECT_EQ(session.picked, count);
    ASSERT_EQ(session.lights().size(), count + 1);
    EXPECT_EQ(session.lights()[5].light.color, glm::dvec3(0));
    EXPECT_EQ(session.copies(count), 1u);
    session.end_step();
    const std::size_t first = *std::ranges::find_if(session.firsts(), [&](auto i) { return session.is_of_city(i); });
    const std::size_t copies = session.copies(first);
    session.remove(first);
    EXPECT_EQ(session.copies(first + 1), copies - 1);
    options.changes = session.changes();
    scene = scene::read_scene(path, {}, options.changes);
    ASSERT_EQ(scene.lights.size(), given.size() - 1 - before / 2);
    EXPECT_EQ(scene.lights[before / 2].position, light.position);
    session.undo();
    EXPECT_EQ(session.copies(first), copies);
    session.undo();
    EXPECT_FALSE(session.has_changes());
  }
}

TEST(Session, WipedPictureHasItsLeftFromOneAndItsRightFromTheOther) {
  const render::Picture left{4, 2, std::vector<float>(24, 1)};
  const render::Picture right{4, 2, std::vector<float>(24, 2)};
  const render::Picture both = wiped(left, right, 0.25);
  for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(both.rgb[i], i % 12 < 3 ? 1 : 2) << i;
  EXPECT_EQ(wiped(left, right, 1).rgb, left.rgb);
  EXPECT_EQ(wiped(left, right, 0).rgb, right.rgb);
}

TEST(Session, FileNamesAreNumberedPastThoseThatAreThere) {
  const TemporaryDirectory directory;
  const std::string stem = (directory.path() / "room").string();
  std::ofstream(stem + "-1.png") << "x";
  EXPECT_EQ(free_file_name(stem, ".png"), stem + "-2.png");
  EXPECT_EQ(free_file_name(stem, ".json"), stem + "-1.json");
}

}  // namespace

}  // namespace litfog::test
