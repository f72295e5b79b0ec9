// SPDX-License-Identifier: Apache-2.0
// What skipping leaves out changes no pixel of the display by more than a step.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "gl/gl_test.h"
#include "reference/srgb.h"
#include "render/display.h"
#include "render/light/hidden_range.h"
#include "render/renderer.h"
#include "scene/file/scene_file.h"
#include "scene/model/model_catalogue.h"
#include "scene/paint/material_catalogue.h"

namespace litfog::test {
using namespace scene;
using namespace render;

namespace {

constexpr int kWidth = 48;
constexpr int kHeight = 27;
constexpr double kClear = std::numeric_limits<double>::infinity();

/// A scene drawn with and without skipping.
class Pair {
 public:
  Pair(const Scene& scene, const RenderSettings& settings, int width = kWidth, int height = kHeight)
      : skipping_(scene, width, height, with(settings, Skipping::on)),
        whole_(scene, width, height, with(settings, Skipping::off)) {}

  void set_atmosphere(const Atmosphere& air) {
    skipping_.set_atmosphere(air);
    whole_.set_atmosphere(air);
  }
  void set_fog(const Fog& fog) { set_atmosphere(skipping_.scene().atmosphere.with(fog)); }
  void set_exposure(double ev) {
    skipping_.set_exposure({.ev = ev});
    exposure_ = ev;
  }

  /// What skipping changes, in steps of the display: a value a channel.
  std::vector<double> changes() {
    counts = skipping_.draw();
    whole_.draw();
    const Picture skipped = skipping_.read();
    const Picture whole = whole_.read();
    std::vector<double> changes;
    for (const ToneCurve tone : {ToneCurve::neutral, ToneCurve::clip}) {
      const Display display{.exposure = {.ev = exposure_}, .tone = tone};
      const Picture a = displayed(skipped, display);
      const Picture b = displayed(whole, display);
      for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        changes.push_back(255 * (srgb_from_linear(double(a.rgb[i])) - srgb_from_linear(double(b.rgb[i]))));
      }
    }
    return changes;
  }

  FrameCounts counts;

 private:
  static RenderSettings with(RenderSettings settings, Skipping skipping) {
    settings.skipping = skipping;
    return settings;
  }

  Renderer skipping_;
  Renderer whole_;
  double exposure_ = 0;
};

double largest(const std::vector<double>& changes) {
  double largest = 0;
  for (const double change : changes) largest = std::max(largest, std::abs(change));
  return largest;
}

RenderSettings lit_by(FogLighting lighting, Scattering scattering = Scattering::all) {
  return {.fog_lighting = lighting, .scattering = scattering};
}

class SkippingTest : public test::GlTest {};

TEST_F(SkippingTest, NoPixelOfAnySceneChangesByAStepInAnyFog) {
  struct Weather {
    FogMode mode;
    double visibility;
  };
  double worst = 0;
  for (const std::string& name : bundled_scenes()) {
    const Scene scene = read_scene(bundled_scene_path(name));
    const bool is_large = scene.lights.size() > 100;  // every pixel of the whole picture is lit by all of them
    for (const FogLighting lighting : {FogLighting::airlight, FogLighting::peak}) {
      Pair pair(scene, lit_by(lighting), is_large ? 16 : kWidth, is_large ? 9 : kHeight);
      for (const auto& [mode, visibility] : {Weather{FogMode::exp, kClear},
                                             {FogMode::exp2, 400},
                                             {FogMode::exp, 120},
                                             {FogMode::exp2, 50},
                                             {FogMode::exp, 25},
                                             {FogMode::exp2, 10}}) {
        if (is_large && lighting == FogLighting::peak && visibility > 120) continue;
        if (mode == FogMode::exp2 && scene.atmosphere.profile.count > 0) continue;  // which has no layers
        pair.set_fog(Fog::from_visibility(mode, visibility));
        const double change = largest(pair.changes());
        EXPECT_LE(change, 1) << name << " at " << visibility << " m, "
                             << (lighting == FogLighting::peak ? "peak" : "airlight");
        worst = std::max(worst, change);
      }
    }
  }
  std::printf("largest change by skipping: %.2f steps\n", worst);
  EXPECT_GT(worst, 0);  // something is left out
}

/// Boxes beside a road, lamps between them and two headlights: small, because every path draws it.
Scene road() {
  Scene scene;
  scene.camera = {.position = {0, 2, 0}, .target = {0, 1, -10}, .field_of_view = 0.8f};
  scene.environment.ambient_light = {0.04f, 0.05f, 0.07f};
  scene.atmosphere.ambient_fog_color = {0.01f, 0.012f, 0.015f};
  scene.environment.moon_direction = glm::normalize(glm::vec3(-0.5f, 0.3f, 0.8f));
  scene.environment.moon_color = {0.07f, 0.08f, 0.1f};
  scene.models = {make_model("box", {{"width_m", 20}, {"depth_m", 120}, {"height_m", 0.1}}),
                  make_model("box", {{"width_m", 3}, {"depth_m", 3}, {"height_m", 3}})};
  scene.models[0].front().material = "asphalt";
  scene.instances = {{0, glm::translate(glm::mat4(1), glm::vec3(0, -0.1f, -60))}};
  for (int i = 0; i < 8; ++i) {
    const float side = i % 2 == 0 ? 4 : -4;
    const float z = -6 - 14 * float(i);
    scene.instances.push_back({1, glm::translate(glm::mat4(1), glm::vec3(side, 0, z))});
    PlacedLight lamp;
    lamp.light = {.name = "lamp", .color = {3, 2.5, 1.5}, .attenuation = {1, 0, 0.05}, .cone = {}};
    if (i % 3 == 0) lamp.light.cone = Cone::smoothstep(0.4, 1.2);
    lamp.position = {-side, 4, z};
    lamp.direction = {0, -1, 0};
    scene.lights.push_back(lamp);
  }
  for (const double side : {-0.7, 0.7}) {
    PlacedLight headlight;
    headlight.light = {.name = "headlight", .attenuation = {1, 0, 0.01}, .cone = Cone::smoothstep(0.1, 0.4)};
    headlight.position = {side, 0.7, 0};
    headlight.direction = glm::normalize(glm::dvec3(0, -0.05, -1));
    headlight.carried = true;
    scene.lights.push_back(headlight);
  }
  add_materials(scene);
  return scene;
}

TEST_F(SkippingTest, NoPixelOfAnyPathOrProgramChangesByAStep) {
  const Scene scene = road();
  for (const LightingPath& path : all_paths()) {
    Pair pair(scene, {.path = &path, .samples = 1}, 24, 14);
    pair.set_fog(Fog::from_visibility(FogMode::exp, 25));
    EXPECT_LE(largest(pair.changes()), 1) << path.name;
    EXPECT_EQ(pair.counts.chunks_as_fog + pair.counts.lights_hidden > 0, path.has_light_bound) << path.name;
  }
}

TEST_F(SkippingTest, NoPixelChangesByAStepInLayersAboveAroundAndBelowTheEye) {
  Scene scene = road();
  for (const RenderSettings& settings :
       {lit_by(FogLighting::airlight), lit_by(FogLighting::airlight, Scattering::single), lit_by(FogLighting::peak)}) {
    Pair pair(scene, settings);
    for (const double haze : {0.0, 0.01}) {
      for (const FogLayer& layer : {FogLayer{.top = 1, .transition = 0.5, .visibility = 15},
                                    FogLayer{.top = 2, .transition = 1, .visibility = 15},
                                    FogLayer{.top = 40, .visibility = 30}, FogLayer{.base = 3, .visibility = 5}}) {
        Atmosphere air = scene.atmosphere.with({FogMode::exp, haze});
        air.profile = make_density_profile(std::span(&layer, 1));
        pair.set_atmosphere(air);
        EXPECT_LE(largest(pair.changes()), 1) << haze << ", " << layer.base << " to " << layer.top;
      }
    }
  }
}

TEST_F(SkippingTest, SkippingPopsNowhereAlongAFlight) {
  Scene scene = read_scene(bundled_scene_path("city"), 60);
  for (const FogLighting lighting : {FogLighting::airlight, FogLighting::peak}) {
    Pair pair(scene, lit_by(lighting), 32, 18);
    pair.set_fog(Fog::from_visibility(FogMode::exp, 70));
    std::vector<double> before;
    const glm::vec3 start = scene.camera.position;
    for (int frame = 0; frame < 5; ++frame) {
      scene.camera.position.z = start.z - 6.0f * float(frame);
      scene.camera.target.z = scene.camera.position.z - 60;
      std::vector<double> now = pair.changes();
      EXPECT_GT(pair.counts.chunks_hidden, 0u);
      for (std::size_t i = 0; i < before.size(); ++i) ASSERT_LE(std::abs(now[i] - before[i]), 1) << frame;
      before = std::move(now);
    }
    scene.camera.position = start;
  }
}

TEST_F(SkippingTest, ExposureOfThePictureDecidesWhatIsVisible) {
  const Scene scene = read_scene(bundled_scene_path("street"));
  Pair pair(scene, lit_by(FogLighting::airlight));
  std::size_t hidden_before = 0;
  for (const double exposure : {10.0, 5.0, -5.0}) {
    pair.set_fog(Fog::from_visibility(FogMode::exp, 30));
    pair.set_exposure(exposure);
    EXPECT_LE(largest(pair.changes()), 1) << exposure;
    const std::size_t hidden = pair.counts.chunks_hidden + pair.counts.chunks_as_fog;
    EXPECT_GT(hidden, hidden_before) << exposure;
    hidden_before = hidden;
  }
}

TEST_F(SkippingTest, SurfaceBeyondLightsIsUnlitWithAndWithoutSkipping) {
  Scene scene;
  scene.camera = {.position = {0, 2, 5}, .target = {0, 0, 0}, .field_of_view = 0.5f};
  scene.environment.ambient_light = {0.1f, 0.1f, 0.1f};
  scene.models = {make_model("box", {{"width_m", 20}, {"depth_m", 20}, {"height_m", 1}})};
  scene.instances = {{0, glm::translate(glm::mat4(1), glm::vec3(0, -1, 0))}};
  scene.instances[0].is_beyond_lights = true;
  add_materials(scene);
  PlacedLight lamp;
  lamp.light = {.name = "lamp", .attenuation = {1, 0, 0.01}, .cone = {}};
  lamp.position = {0, 3, 0};
  scene.lights.push_back(lamp);
  Pair pair(scene, {.fog_lighting = FogLighting::peak});
  EXPECT_EQ(largest(pair.changes()), 0);
  EXPECT_EQ(pair.counts.lights_listed, 0u);
}

TEST_F(SkippingTest, ApproachInDenseFogIsWhatTheFogHolds) {
  const Scene scene = read_scene(bundled_scene_path("approach"));
  Renderer renderer(scene, kWidth, kHeight, {.fog_lighting = FogLighting::airlight});
  const auto counts_at = [&](double visibility) {
    renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp, visibility)));
    return renderer.draw();
  };
  const FrameCounts clear = counts_at(kClear);
  EXPECT_GT(clear.chunks_outside_view, 0u);
  EXPECT_GT(clear.lights_out_of_reach, 10 * clear.lights_listed);
  EXPECT_EQ(clear.chunks_as_fog + clear.chunks_hidden, 0u);
  EXPECT_EQ(clear.sky, SkyDrawing::sky);
  const FrameCounts fog = counts_at(50);
  EXPECT_LT(fog.chunks_drawn, clear.chunks_drawn / 100);
  EXPECT_LT(fog.chunks_drawn + fog.chunks_as_fog, clear.chunks_drawn / 10);
  EXPECT_LT(fog.lights_listed, clear.lights_listed / 100);
  EXPECT_LT(fog.points_drawn, clear.points_drawn / 4);
  EXPECT_EQ(fog.sky, SkyDrawing::fog);  // the moon lights it
  EXPECT_EQ(fog.chunks_drawn + fog.chunks_as_fog + fog.chunks_hidden, clear.chunks_drawn);
}

// --- what stands behind a surface that fog hides ---

/// A dark wall in fog that hides it, and whatever the tests put behind it: its faces are at 100 m and 101 m.
class HiddenWall : public SkippingTest {
 protected:
  HiddenWall() {
    scene_.camera = {.position = {0, 2, 0}, .target = {0, 2, -10}, .field_of_view = 0.5f};
    scene_.atmosphere.ambient_fog_color = {0.01f, 0.01f, 0.01f};
    scene_.environment.ambient_light = {0.1f, 0.1f, 0.1f};
    add_box({0, -5, -100.5}, "box");
    add_materials(scene_);
  }

  /// A box 20 m wide and high, 1 m deep.
  void add_box(const glm::vec3& position, const std::string& material) {
    scene_.models.push_back(make_model("box", {{"width_m", 20}, {"depth_m", 1}, {"height_m", 20}}));
    if (material != "box") scene_.models.back().front().material = material;
    scene_.instances.push_back({scene_.models.size() - 1, glm::translate(glm::mat4(1), position)});
  }

  /// Adds a lamp of {1, 0, quadratic} in air of a fraction of the fog's density.
  void add_lamp(const glm::dvec3& position, const glm::dvec3& direction, const Cone& cone, double quadratic,
                bool is_carried, double density_scale = 1) {
    scene_.lights.push_back({.light = {.name = "lamp", .attenuation = {1, 0, quadratic}, .cone = cone},
                             .position = position,
                             .direction = direction,
                             .carried = is_carried});
    scene_.lights.back().light.density_scale = density_scale;
  }

  /// Compares, and says how the wall was drawn.
  FrameCounts counts_in_fog(FogLighting lighting) {
    Pair pair(scene_, {.fog_lighting = lighting});
    pair.set_fog(Fog::from_visibility(FogMode::exp, 30));
    EXPECT_LE(largest(pair.changes()), 1);
    return pair.counts;
  }

  Scene scene_;
};

TEST_F(HiddenWall, WallIsLeftOutWhereNothingIsSeenBehind) {
  const FrameCounts counts = counts_in_fog(FogLighting::airlight);
  EXPECT_EQ(counts.chunks_hidden, 1u);
  EXPECT_EQ(counts.sky, SkyDrawing::background);
}

TEST_F(HiddenWall, WallThatIsBrightWithoutLampsIsDrawn) {
  const auto expect_drawn = [this](SkyDrawing sky) {
    const FrameCounts counts = counts_in_fog(FogLighting::airlight);
    EXPECT_EQ(counts.chunks_drawn, 1u);
    EXPECT_EQ(counts.sky, sky);
  };
  const glm::vec3 bright(5000);
  const scene::Environment dark = scene_.environment;
  scene_.environment.ambient_light = bright;
  expect_drawn(SkyDrawing::background);
  scene_.environment = dark;
  scene_.environment.moon_direction = {0, 0, 1};
  scene_.environment.moon_color = bright;  // its light alone: in the sky it is as bright as ever
  expect_drawn(SkyDrawing::fog);           // which it may light
  scene_.environment = dark;
  scene_.materials.front().emissive = bright;
  expect_drawn(SkyDrawing::background);
}

TEST_F(HiddenWall, WallHidesABrightSurface) {
  scene::Material glowing = scene_.materials.front();
  glowing.name = "glowing";
  glowing.emissive = glm::vec3(5000);
  scene_.materials.push_back(glowing);
  add_box({0, -5, -110}, "glowing");
  EXPECT_EQ(counts_in_fog(FogLighting::airlight).chunks_as_fog, 1u);
}

TEST_F(HiddenWall, WallHidesTheSkyAboveTheFog) {
  scene_.camera.target = {0, 4, -10};
  scene_.instances[0].world_from_model = glm::scale(scene_.instances[0].world_from_model, glm::dvec3(1, 5, 1));
  scene_.atmosphere.top = 10;
  scene_.environment.sky_zenith = scene_.environment.sky_horizon = {0.5f, 0.5f, 0.5f};
  const FrameCounts counts = counts_in_fog(FogLighting::airlight);
  EXPECT_EQ(counts.chunks_as_fog, 1u);
  EXPECT_EQ(counts.sky, SkyDrawing::sky);
}

TEST_F(HiddenWall, WallHidesThePointAndTheGlowOfALampAndTheGlowAlone) {
  add_lamp({0, 4, -130}, {0, 0, -1}, {}, 0.001, false, 0.2);
  EXPECT_EQ(counts_in_fog(FogLighting::airlight).chunks_as_fog, 1u);
  EXPECT_EQ(counts_in_fog(FogLighting::peak).chunks_as_fog, 1u);
  scene_.lights.back().carried = true;  // no point is drawn of it
  EXPECT_EQ(counts_in_fog(FogLighting::airlight).chunks_as_fog, 1u);
}

TEST_F(HiddenWall, MoonIsSeenThroughTheTopOfTheFog) {
  scene_.camera.target = {0, 12, -10};
  scene_.atmosphere.top = 52;
  scene_.environment.moon_direction = glm::normalize(glm::vec3(0, 1, -1));
  scene_.environment.moon_color = glm::vec3(1e-3f);
  EXPECT_EQ(counts_in_fog(FogLighting::airlight).sky, SkyDrawing::sky);
}

TEST_F(HiddenWall, ChangedFogAndExposureDecideAnew) {
  Pair pair(scene_, {.fog_lighting = FogLighting::peak});
  const auto drawn = [&](double visibility, double exposure) {
    pair.set_fog(Fog::from_visibility(FogMode::exp, visibility));
    pair.set_exposure(0);
    EXPECT_LE(largest(pair.changes()), 1);
    pair.set_exposure(exposure);
    EXPECT_LE(largest(pair.changes()), 1);
    return pair.counts.chunks_drawn;
  };
  EXPECT_EQ(drawn(30, 0), 0u);
  EXPECT_EQ(drawn(30, 12), 1u);
  EXPECT_EQ(drawn(3000, 0), 1u);
  EXPECT_EQ(drawn(30, 0), 0u);
}

TEST_F(HiddenWall, WallThatIsLeftOutWasBelowItsShare) {
  scene_.atmosphere.ambient_fog_color = glm::vec3(0);
  Pair pair(scene_, {.fog_lighting = FogLighting::peak});
  double most = 0;
  for (double visibility = 40; visibility < 80; visibility *= 1.02) {
    pair.set_fog(Fog::from_visibility(FogMode::exp, visibility));
    const double change = largest(pair.changes());
    if (pair.counts.chunks_drawn == 0) most = std::max(most, change);
  }
  EXPECT_LE(most, kHiddenShare);
  EXPECT_GT(most, kHiddenShare / 4);
}

TEST_F(HiddenWall, LampsThatAreLeftOutOfASurfaceWereBelowTheirShare) {
  scene_.environment.ambient_light = scene_.atmosphere.ambient_fog_color = glm::vec3(0);
  for (int i = 0; i < 64; ++i) {
    add_lamp({0.1 * i - 3.2, 2, -95}, {0, 0, -1}, Cone::smoothstep(1.0, 1.2), 0.01, false);  // not to the eye
    scene_.lights.back().light.color = glm::dvec3(2e-5 * (1 + 0.01 * i));
  }
  Pair pair(scene_, {.fog_lighting = FogLighting::peak});
  pair.set_fog(Fog{});
  const double change = largest(pair.changes());
  EXPECT_GT(pair.counts.lights_hidden, 0u);
  EXPECT_LE(change, kSurfaceLightShare);
  EXPECT_GT(change, kSurfaceLightShare / 8);
}

TEST_F(HiddenWall, WallIsLitFogBeforeACarriedLight) {
  add_lamp({3, 2, -5}, {0, 0, -1}, Cone::smoothstep(0.05, 0.06), 0.01, true);
  const FrameCounts counts = counts_in_fog(FogLighting::peak);
  EXPECT_EQ(counts.chunks_as_fog, 1u);
  EXPECT_EQ(counts.sky, SkyDrawing::fog);
}

TEST_F(HiddenWall, IsLeftOutBesideTheBeamOfACarriedLight) {
  add_lamp({0.5, 2, 0}, glm::normalize(glm::dvec3(0.4, 0, -1)), Cone::smoothstep(0.05, 0.06), 0.01, true);
  const FrameCounts counts = counts_in_fog(FogLighting::peak);
  EXPECT_EQ(counts.chunks_hidden, 1u);
  EXPECT_EQ(counts.sky, SkyDrawing::fog);
}

std::vector<float> draw_rejecting(const Scene& scene, EarlyRejection rejection, int samples) {
  Renderer renderer(scene, 2 * kWidth, 2 * kHeight, {.papers = {.early_rejection = rejection}, .samples = samples});
  renderer.set_atmosphere(scene.atmosphere.with(Fog::from_visibility(FogMode::exp, 200)));
  renderer.draw();
  return renderer.read().rgb;
}

TEST_F(SkippingTest, PassOfDepthsChangesNoPixel) {
  for (const char* name : {"headlights", "room"}) {
    const Scene scene = read_scene(bundled_scene_path(name));
    for (const int samples : {1, 4}) {
      EXPECT_EQ(draw_rejecting(scene, EarlyRejection::depth_pass, samples),
                draw_rejecting(scene, EarlyRejection::none, samples))
          << name << ", " << samples;
    }
  }
}

TEST_F(SkippingTest, OrderFromFrontToBackChangesNoPixelWithoutCoplanarSurfaces) {
  const Scene room = read_scene(bundled_scene_path("room"));
  EXPECT_EQ(draw_rejecting(room, EarlyRejection::front_to_back, 1), draw_rejecting(room, EarlyRejection::none, 1));
}

}  // namespace
}  // namespace litfog::test
