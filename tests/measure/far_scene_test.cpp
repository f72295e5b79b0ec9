// SPDX-License-Identifier: Apache-2.0
// Scenes far from the world's origin: floats there are metres apart, scenes are in doubles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "gl/gl_test.h"
#include "measure/picture_error.h"
#include "measure/reference_picture.h"
#include "render/renderer.h"
#include "scene/model/model_catalogue.h"
#include "scene/paint/cookie_pattern.h"
#include "scene/paint/material_catalogue.h"

namespace litfog::test {
using namespace render;
using namespace scene;
using namespace measure;

namespace {

constexpr int kWidth = 72;
constexpr int kHeight = 48;

/// Up to the limit of a scene's coordinates, some of which are hundreds of metres off a whole number of 1024.
constexpr glm::dvec3 kFarPlace(1e6, 3000, -9'999'990);

class FarScene : public GlTest {};

/// Boxes on a floor under the moon; lamps of each profile, one of them at the eye, one with a cookie.
Scene yard() {
  Scene scene;
  scene.camera = {.position = {0.3, 2.1, 7.7}, .target = {0.2, 0.9, 0}, .field_of_view = 0.9f};
  scene.environment = {.ambient_light = glm::vec3(0.02f),
                       .sky_zenith = {0.01f, 0.01f, 0.02f},
                       .sky_horizon = glm::vec3(0.03f),
                       .star_brightness = 0.5f,
                       .moon_direction = glm::normalize(glm::vec3(0.4f, 1, 0.6f)),
                       .moon_color = glm::vec3(0.05f)};
  scene.atmosphere.ambient_fog_color = glm::vec3(0.02f);
  scene.atmosphere.top = 1000;  // or moonlight would enter at a height above 0, wherever the scene is
  scene.models.push_back(make_model("box", {{"width_m", 14}, {"depth_m", 14}, {"height_m", 0.2}}));
  scene.models.push_back(make_model("box", {{"width_m", 1.1}, {"depth_m", 0.9}, {"height_m", 1.3}}));
  scene.models.push_back(make_model("crate", {}));
  scene.instances = {{0, glm::translate(glm::dmat4(1), glm::dvec3(0, -0.2, 0))},
                     {1, glm::translate(glm::dmat4(1), glm::dvec3(1.6, 0, -0.7))},
                     {2, glm::translate(glm::dmat4(1), glm::dvec3(-1.3, 0, 0.4))}};
  add_materials(scene);
  const auto add = [&](const glm::dvec3& color, const glm::dvec3& position, const glm::dvec3& aim, const Cone& cone) {
    PlacedLight light;
    light.light = {.name = "lamp", .color = color, .attenuation = {1, 0, 0.08}, .threshold = 0.01, .cone = cone};
    light.position = position;
    light.direction = glm::normalize(aim - position);
    scene.lights.push_back(light);
  };
  add({1.5, 1.2, 0.9}, {1.2, 3.4, 1.1}, {0.3, 0, -0.4}, Cone::smoothstep(0.3, 0.7));
  add({0.3, 0.5, 0.9}, {-2.2, 1.5, -1.3}, {0, 0, 0}, Cone{});
  add({0.8, 0.8, 0.7}, {0.8, 1.8, 7.5}, {0.1, 0.4, 0}, Cone::cosine(0.6, 4));
  scene.lights.back().carried = true;
  add({0.9, 0.3, 0.2}, {-0.4, 2.6, 1.9}, {-1, 0, 0.5}, Cone{});
  scene.cookies.push_back(paint_cookie(std::string(kCookiePatterns[0])));
  scene.cookie_uses[3] = {.cookie = 0, .roll = 0.3};
  return scene;
}

Scene moved(Scene scene, const glm::dvec3& by) {
  scene.camera.position += by;
  scene.camera.target += by;
  scene.atmosphere.top += by.y;
  for (Instance& instance : scene.instances) instance.world_from_model[3] += glm::dvec4(by, 0);
  for (PlacedLight& light : scene.lights) light.position += by;
  return scene;
}

Picture draw(const Scene& scene, const Fog& fog, const RenderSettings& settings) {
  Renderer renderer(scene, kWidth, kHeight, settings);
  renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
  renderer.draw();
  return renderer.read();
}

/// Expects that two pictures look the same: no more than a sample of a few pixels on an outline falls on its other
/// side.
void expect_alike(const Picture& drawn, const Picture& expected, const std::string& what) {
  const PictureError error = picture_error(drawn, expected);
  const auto seen = std::ranges::count_if(error.pixels, [](float steps) { return !(steps <= 1); });
  std::printf("%-60s largest %.3f, mean %.5f, %td pixels beyond a step\n", what.c_str(), error.largest, error.mean,
              seen);
  EXPECT_LE(seen, std::ssize(error.pixels) / 500) << what;
  EXPECT_LT(error.mean, 0.02) << what;
}

void expect_alike_far_away(const Scene& scene, const Fog& fog, const RenderSettings& settings,
                           const std::string& what) {
  const Picture expected = draw(scene, fog, settings);
  expect_alike(draw(moved(scene, kFarPlace), fog, settings), expected, what);
}

class FarScenePath : public FarScene, public testing::WithParamInterface<LightingPath> {};

TEST_P(FarScenePath, PictureStaysAsItIsAtTheOrigin) {
  const Fog fog = Fog::from_visibility(FogMode::exp2, 30.0);
  expect_alike_far_away(yard(), fog, {.path = &GetParam()}, std::string(GetParam().name));
}

INSTANTIATE_TEST_SUITE_P(FarScene, FarScenePath, testing::ValuesIn(lighting_paths()),
                         [](const testing::TestParamInfo<LightingPath>& path) {
                           std::string name(path.param.name);
                           std::erase(name, '-');
                           return name;
                         });

TEST_F(FarScene, AirlightStaysAsItIsAtTheOrigin) {
  Scene scene = yard();
  scene.atmosphere.phase = Phase::henyey_greenstein(0.6);
  scene.atmosphere.top = 4;
  const Fog fog = Fog::from_visibility(FogMode::exp, 30.0);
  expect_alike_far_away(scene, fog, {.fog_lighting = FogLighting::airlight}, "airlight");
}

TEST_F(FarScene, ShaftsStayAsTheyAreAtTheOrigin) {
  const RenderSettings settings{
      .fog_lighting = FogLighting::airlight, .shadows = Shadows::shafts, .shadow_map_size = 512};
  expect_alike_far_away(yard(), Fog::from_visibility(FogMode::exp, 30.0), settings, "shafts");
}

// Moved by what the origin of its floats moves by, a scene has the same floats.
TEST_F(FarScene, PictureMovedByWholeKilometresOf1024MetresIsTheSame) {
  const glm::dvec3 place(1024 * 977.0, 0, 1024 * -9000.0);
  const Fog fog = Fog::from_visibility(FogMode::exp, 30.0);
  const RenderSettings settings{.fog_lighting = FogLighting::airlight};
  EXPECT_EQ(draw(moved(yard(), place), fog, settings).rgb, draw(yard(), fog, settings).rgb);
}

// The reference takes lamps and camera from the scene's doubles, and every corner relative to the camera's
// surroundings.
TEST_F(FarScene, ReferenceStaysAsItIsAtTheOrigin) {
  const Fog fog = Fog::from_visibility(FogMode::exp, 30.0);
  const RenderSettings settings{.shadows = Shadows::surfaces, .shadow_map_size = 512};
  const Scene near = yard();
  Renderer at_origin(near, 36, 24, settings);
  at_origin.set_atmosphere(at_origin.scene().atmosphere.with(fog));
  const ReferencePicture expected = shade_reference(at_origin);
  const Scene far = moved(near, kFarPlace);
  Renderer renderer(far, 36, 24, settings);
  renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
  renderer.draw(LightPoints::off);
  const Picture drawn = renderer.read();
  const ReferencePicture reference = shade_reference(renderer);
  EXPECT_LE(picture_error(reference.picture, expected).largest, 1);  // but where rounding decides on a shadow's edge
  const PictureError error = picture_error(drawn, reference);
  EXPECT_LE(error.largest, 1);
  EXPECT_LE(error.excluded, error.pixels.size() / 5);
}

// It is farther from the camera than the library takes lights.
TEST_F(FarScene, LampOnTheOtherSideOfTheWorldLightsFromItsDirection) {
  Scene scene = yard();
  scene.lights.resize(1);
  scene.cookie_uses.clear();
  scene.lights[0].light.attenuation = {1, 0, 0};  // without end
  scene.lights[0].light.cone = Cone{};
  scene.lights[0].position = glm::dvec3(4e6, 3e6, 1e6);
  const Picture expected = draw(scene, Fog{FogMode::exp, 0}, {});
  scene = moved(scene, {-1e7, -1e7, -1e7});
  scene.lights[0].position = scene.camera.position + 4.9 * glm::dvec3(4e6, 3e6, 1e6);  // at most 1e7 each
  expect_alike(draw(scene, Fog{FogMode::exp, 0}, {}), expected, "another side of the world");
}

TEST_F(FarScene, CameraThatTravelsFarTakesTheOriginAlong) {
  const Fog fog = Fog::from_visibility(FogMode::exp, 30.0);
  const Scene near = yard();
  Scene both = moved(near, kFarPlace);
  both.instances.insert(both.instances.end(), near.instances.begin(), near.instances.end());
  both.lights.insert(both.lights.end(), near.lights.begin(), near.lights.end());
  std::erase_if(both.lights, [](const PlacedLight& light) { return light.carried; });
  both.cookie_uses.clear();
  const Camera far_camera = both.camera;
  both.camera = near.camera;
  Renderer renderer(both, kWidth, kHeight, {});
  renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
  renderer.draw();
  const Picture before = renderer.read();
  both.camera = far_camera;
  renderer.draw();
  const Picture after = renderer.read();
  EXPECT_EQ(after.rgb, draw(both, fog, {}).rgb);
  both.camera = near.camera;
  renderer.draw();
  EXPECT_EQ(renderer.read().rgb, before.rgb);
  expect_alike(after, before, "the far end of a journey");
}

}  // namespace
}  // namespace litfog::test
