// SPDX-License-Identifier: Apache-2.0
#include "render/renderer.h"

#include <epoxy/gl.h>

#include <chrono>
#include <ctime>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <numeric>
#include <tuple>

#include "gl/gl_test.h"
#include "litfog/gl/unsupported.h"
#include "render/gpu/texture.h"
#include "render/gpu/texture_unit.h"
#include "render/pixel.h"
#include "scene/file/scene_file.h"
#include "scene/model/model_catalogue.h"
#include "scene/paint/material_catalogue.h"
#include "scene/texels.h"

namespace litfog::test {
using namespace scene;
using namespace render;

namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 64;
constexpr double kPixelTolerance = 1.0 / 255;

/// Nothing but sky over a carried spot light beside the eye.
Scene open_air(const Cone& cone) {
  Scene scene;
  scene.camera = {.position = {0, 2, 0}, .target = {0, 2, -10}, .field_of_view = 1.0f};
  scene.atmosphere.ambient_fog_color = {0.02f, 0.03f, 0.04f};
  scene.environment.sky_zenith = scene.environment.sky_horizon = {0.3f, 0.2f, 0.1f};
  PlacedLight light;
  light.light = {.name = "spot", .color = {0.9, 0.8, 0.7}, .attenuation = {1, 0, 0.01}, .cone = cone};
  light.position = {0.5, 1.5, 0};
  light.direction = glm::normalize(glm::dvec3(0.1, 0.05, -1));
  light.carried = true;
  scene.lights.push_back(light);
  return scene;
}

Picture draw(Renderer& renderer, const Fog& fog) {
  renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
  renderer.draw();
  return renderer.read();
}

Picture draw(const Scene& scene, const Fog& fog, const RenderSettings& settings = {}) {
  Renderer renderer(scene, kWidth, kHeight, settings);
  return draw(renderer, fog);
}

class RendererTest : public test::GlTest {};

// Far sky in fog shows the fog alone: ambient fog + colour * cone * intensity, in every pixel.
TEST_F(RendererTest, BeamInTheFogFollowsTheConeInEveryPixel) {
  for (const Cone& cone : {Cone::cosine(0.3, 20), Cone::smoothstep(0.1, 0.4), Cone{}}) {
    const Scene scene = open_air(cone);
    const PlacedLight& light = scene.lights[0];
    for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
      const Fog fog = Fog::from_visibility(mode, 60.0);
      const Picture picture = draw(scene, fog);
      const double intensity = solve_fog_intensity(light.light, fog).intensity;
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          // The four samples lie within the pixel; a cone that is cut off between its corners has an edge here.
          double low = 1;
          double high = 0;
          for (const double dx : {0.0, 0.5, 1.0}) {
            for (const double dy : {0.0, 0.5, 1.0}) {
              const double value = cone_at(
                  cone, glm::dot(view_direction(scene.camera, kWidth, kHeight, x + dx, y + dy), light.direction));
              low = std::min(low, value);
              high = std::max(high, value);
            }
          }
          const glm::dvec3 ambient = scene.atmosphere.ambient_fog_color;
          const glm::dvec3 least = ambient + light.light.color * (low * intensity) - kPixelTolerance;
          const glm::dvec3 most = ambient + light.light.color * (high * intensity) + kPixelTolerance;
          const glm::dvec3 drawn = pixel(picture, x, y);
          ASSERT_TRUE(glm::all(glm::lessThanEqual(least, drawn)) && glm::all(glm::lessThanEqual(drawn, most)))
              << "pixel " << x << ", " << y << ": " << drawn.r << " not in [" << least.r << ", " << most.r << "]";
        }
      }
    }
  }
}

TEST_F(RendererTest, CarriedLampLightsLayersByTheDensityAtTheEye) {
  Scene scene = open_air(Cone{});
  const FogLayer layer{.base = 10, .top = 30, .transition = 2, .visibility = 20};
  const double haze = Fog::from_visibility(FogMode::exp, 60.0).density;
  const double dense = Fog::from_visibility(FogMode::exp, layer.visibility).density;
  Atmosphere air = scene.atmosphere.with({FogMode::exp, haze});
  air.profile = make_density_profile(std::span(&layer, 1));
  Renderer renderer(scene, kWidth, kHeight, {});
  renderer.set_atmosphere(air);
  for (const auto& [height, density] :
       {std::pair{2.0, haze}, {9.0, haze + dense / 2}, {20.0, haze + dense}, {31.0, haze + dense / 2}, {40.0, haze}}) {
    scene.camera.position.y = scene.camera.target.y = height;
    renderer.draw();
    const Light& lamp = scene.lights[0].light;
    const double intensity = solve_fog_intensity(lamp, {FogMode::exp, density}).intensity;
    const glm::dvec3 expected = air.ambient_fog_color + lamp.color * intensity;
    const Picture picture = renderer.read();
    for (int x = 0; x < kWidth; ++x) {
      ASSERT_LT(glm::distance(pixel(picture, x, kHeight / 2), expected), kPixelTolerance) << "eye at " << height;
    }
  }
}

TEST_F(RendererTest, TotalFogHidesTheScene) {
  const Scene scene = read_scene(bundled_scene_path("room"));
  const Picture picture = draw(scene, Fog{FogMode::exp, std::numeric_limits<double>::infinity()});
  for (const float value : picture.rgb) ASSERT_TRUE(std::isfinite(value));
  EXPECT_NEAR(pixel(picture, kWidth - 1, kHeight - 1).r, double(scene.atmosphere.ambient_fog_color.r), kPixelTolerance);
}

TEST_F(RendererTest, MoonOfABundledSceneFadesAsTheFogThickens) {
  for (const std::string& name : bundled_scenes()) {
    Scene scene = read_scene(bundled_scene_path(name));
    if (!scene.environment.has_moon() || std::isinf(scene.atmosphere.top)) continue;
    scene.instances.clear();
    scene.lights.clear();
    scene.camera.target = scene.camera.position + glm::dvec3(scene.environment.moon_direction);
    double before = 2;
    for (const double visibility : {20'000.0, 5000.0, 1500.0, 400.0}) {
      const Picture picture = draw(scene, Fog::from_visibility(FogMode::exp, visibility));
      const double moon = pixel(picture, kWidth / 2, kHeight / 2).b - scene.atmosphere.ambient_fog_color.b;
      EXPECT_LT(moon, 0.9 * before) << name << " at " << visibility;
      EXPECT_GT(moon, visibility < 1000 ? 0 : kPixelTolerance) << name << " at " << visibility;
      before = moon;
    }
    const Picture hidden = draw(scene, Fog::from_visibility(FogMode::exp, 100.0));
    EXPECT_LT(pixel(hidden, kWidth / 2, kHeight / 2).b - scene.atmosphere.ambient_fog_color.b, kPixelTolerance) << name;
  }
}

// Rays of one elevation have the same depths: only their angle from the moon tells them apart.
TEST_F(RendererTest, MoonHasAnAureoleInThinGroundFogByThePhaseFunction) {
  constexpr int kSide = 9;
  const FogLayer layer{.top = 40, .transition = 10, .visibility = 300};
  Scene scene;
  scene.environment.moon_direction = glm::normalize(glm::vec3(0, 0.4f, -1));
  scene.environment.moon_color = {0.2f, 0.2f, 0.3f};
  scene.atmosphere.phase = Phase::droplets(10);
  const auto shown = [&](double azimuth) {
    const glm::dvec3 towards{std::sin(azimuth), 0.3, -std::cos(azimuth)};
    scene.camera = {.position = {0, 2, 0}, .target = glm::dvec3{0, 2, 0} + towards, .field_of_view = 0.02f};
    Renderer renderer(scene, kSide, kSide, {.fog_lighting = FogLighting::airlight});
    Atmosphere air = scene.atmosphere;
    air.profile = make_density_profile(std::span(&layer, 1));
    renderer.set_atmosphere(air);
    renderer.draw();
    return pixel(renderer.read(), kSide / 2, kSide / 2).b;
  };
  const auto phase = [&](double azimuth) {
    const glm::dvec3 towards{std::sin(azimuth), 0.3, -std::cos(azimuth)};
    return phase_at(scene.atmosphere.phase,
                    glm::dot(glm::normalize(towards), glm::dvec3(scene.environment.moon_direction)));
  };
  const double away = shown(2.5);
  EXPECT_GT(away, 0);
  EXPECT_GT(shown(0.35), 30 * away);
  for (const double azimuth : {0.35, 0.5, 1.0, 1.5}) {
    EXPECT_NEAR(shown(azimuth) / away, phase(azimuth) / phase(2.5), 0.01 * phase(azimuth) / phase(2.5)) << azimuth;
  }
}

TEST_F(RendererTest, LightPointIsSeenThroughTheFogAtTheDensityOfItsClass) {
  const auto brightness = [](double density_scale) {
    Scene scene = open_air(Cone{});
    PlacedLight lamp = scene.lights[0];
    lamp.carried = false;
    lamp.position = {0, 2, -300};
    lamp.light.density_scale = density_scale;
    scene.lights = {lamp};
    const Picture picture = draw(scene, Fog::from_visibility(FogMode::exp, 200.0));
    double sum = 0;  // over what the fog alone shows
    const double fog_alone = pixel(picture, 2, 2).r;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) sum += pixel(picture, x, y).r - fog_alone;
    }
    return sum;
  };
  // Below full brightness a point's size is fixed, so sums compare as transmittances: e^(-d r) and e^(-0.4 d r).
  const double depth = -std::log(0.05) * 300 / 200;
  EXPECT_GT(brightness(1.0), 0);
  EXPECT_NEAR(std::log(brightness(0.4) / brightness(1.0)), 0.6 * depth, 0.15 * depth);
}

// A lamp's disc is white where the eye is dazzled. Fog that is white all around it would hide the scene. Three scenes
// are darker than the others: before one's own beams isotropic fog is so bright that the rest is dark, and most of
// what breakout shows is the night between a cloud and the ground.
TEST_F(RendererTest, BundledScenesAreReadableAtTheirVisibilitiesByAirlight) {
  for (const std::string& name : bundled_scenes()) {
    const Scene scene = read_scene(bundled_scene_path(name));
    Renderer renderer(scene, 160, 90, {.fog_lighting = FogLighting::airlight});
    for (const double visibility :
         scene.visibilities.empty() ? std::vector{suggested_visibility(scene)} : scene.visibilities) {
      renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp, visibility)));
      const Exposure exposure = renderer.set_exposure(
          {.ev = scene.display.exposure.value_or(0), .is_auto = !scene.display.exposure.has_value()});
      renderer.draw();
      const Picture shown = displayed(renderer.read(), {.exposure = exposure});
      std::vector<int> levels;
      std::ptrdiff_t white = 0;
      for (std::size_t i = 0; i < shown.rgb.size(); i += 3) {
        const auto [least, most] = std::minmax_element(&shown.rgb[i], &shown.rgb[i] + 3);
        levels.push_back(srgb_level_of(*most));
        if (srgb_level_of(*least) == 255) ++white;
      }
      const auto pixels = std::ptrdiff_t(levels.size());
      std::nth_element(levels.begin(), levels.begin() + pixels / 2, levels.end());
      const int median = levels[std::size_t(pixels / 2)];
      std::printf("%-12s %7g m: EV %.2f, median %d, %td of %td pixels white\n", name.c_str(), visibility, exposure.ev,
                  median, white, pixels);
      EXPECT_LE(white, pixels / 100) << name << ", " << visibility << " m";
      EXPECT_GE(median, name == "breakout" || name == "headlights" || name == "road" ? 8 : 20)
          << name << ", " << visibility << " m";
      EXPECT_LE(median, 160) << name << ", " << visibility << " m";
    }
  }
}

TEST_F(RendererTest, OnlyAnAutomaticExposureIsChosen) {
  const Scene scene = open_air({});
  Renderer renderer(scene, kWidth, kHeight, {});
  const Exposure chosen = renderer.set_exposure({.ev = 7, .is_auto = true});
  EXPECT_TRUE(chosen.is_auto);
  renderer.draw(LightPoints::off);
  EXPECT_EQ(chosen.ev, auto_exposure(renderer.read()));
  EXPECT_NE(chosen.ev, 7);
  const Exposure given = renderer.set_exposure({.ev = 1.5});
  EXPECT_FALSE(given.is_auto);
  EXPECT_EQ(given.ev, 1.5);
}

/// Changes what a renderer may be told of, for a scene with two lights or more: camera, lights and their order of
/// extents.
void change(Scene& scene) {
  scene.camera.position += glm::vec3(0.7f, 0.3f, -0.4f);
  scene.camera.field_of_view *= 0.8f;
  Light& first = scene.lights.front().light;
  first.attenuation = {.constant = 0.5, .linear = 0.02, .quadratic = 0.004};  // with a knee, which it did not have
  first.color = glm::dvec3(2, 0.5, 0.1);
  first.cone = Cone::smoothstep(0.2, 0.9);
  scene.lights.back().light.color = glm::dvec3(0);  // off: left out of all lists
}

// Airlight's grids depend on it.
TEST_F(RendererTest, ChangedFieldOfViewGivesThePictureOfANewRenderer) {
  Scene scene = read_scene(bundled_scene_path("room"));
  const Fog fog = Fog::from_visibility(FogMode::exp, 30.0);
  scene.camera.field_of_view = 0.2f;
  Renderer renderer(scene, kWidth, kHeight, {});
  const std::vector<float> narrow = draw(renderer, fog).rgb;
  scene.camera.field_of_view = 2.4f;
  Renderer wide(scene, kWidth, kHeight, {});
  EXPECT_EQ(draw(renderer, fog).rgb, draw(wide, fog).rgb);
  scene.camera.field_of_view = 0.2f;
  EXPECT_EQ(draw(wide, fog).rgb, narrow);
}

TEST_F(RendererTest, ChangedLightsCameraAndSizeGiveThePictureOfANewRenderer) {
  const Scene original = read_scene(bundled_scene_path("room"));
  const Fog fog = Fog::from_visibility(FogMode::exp, 30.0);
  for (const auto& [path, fog_lighting, shadows] : {std::tuple{"unified", FogLighting::airlight, Shadows::shafts},
                                                    std::tuple{"unified", FogLighting::peak, Shadows::none},
                                                    std::tuple{"lookup-3d", FogLighting::peak, Shadows::none}}) {
    const RenderSettings settings{.path = find_lighting_path(path),
                                  .fog_lighting = fog_lighting,
                                  .papers = {.map_size = 16},
                                  .shadows = shadows,
                                  .shadow_map_size = 64};
    Scene scene = original;
    Renderer renderer(scene, kWidth, kHeight, settings);
    const Picture before = draw(renderer, fog);
    change(scene);
    renderer.set_size(80, 45);
    renderer.set_lights();
    renderer.draw();
    Renderer made_anew(scene, 80, 45, settings);
    EXPECT_EQ(renderer.read().rgb, draw(made_anew, fog).rgb) << path;
    scene.lights = original.lights;
    scene.camera = original.camera;
    renderer.set_size(kWidth, kHeight);
    renderer.set_lights();
    renderer.draw();
    EXPECT_EQ(renderer.read().rgb, before.rgb) << path;
    EXPECT_NE(made_anew.read().rgb, before.rgb) << path;
  }
}

TEST_F(RendererTest, ChangedObjectsGiveThePictureOfANewRenderer) {
  const Scene original = read_scene(bundled_scene_path("room"));
  const Scene other = read_scene(bundled_scene_path("tessellation"));
  const RenderSettings settings{.fog_lighting = FogLighting::airlight,
                                .samples = 1,
                                .shadows = Shadows::surfaces,
                                .shadow_lamps = 1,
                                .shadow_map_size = 64};
  const Fog fog = Fog::from_visibility(FogMode::exp, 300.0);
  Scene scene = original;
  Renderer renderer(scene, 80, 45, settings);
  const std::vector<float> before = draw(renderer, fog).rgb;
  for (const Scene* from : {&other, &original}) {
    scene.models = from->models;
    scene.materials = from->materials;
    scene.instances = from->instances;
    scene.lights.push_back(scene.lights[0]);
    scene.lights.back().position.x += 1;
    renderer.set_objects();
    renderer.set_lights();
    const std::vector<float> after = draw(renderer, fog).rgb;
    Renderer made_anew(scene, 80, 45, settings);
    EXPECT_EQ(after, draw(made_anew, fog).rgb) << from->name;
    EXPECT_EQ(renderer.materials().size(), made_anew.materials().size()) << from->name;
    EXPECT_NE(after, before) << from->name;
  }
}

TEST_F(RendererTest, TurnedCookiesGiveThePictureOfANewRenderer) {
  Scene scene = read_scene(bundled_scene_path("cookies"));
  const RenderSettings settings{.fog_lighting = FogLighting::airlight};
  Renderer renderer(scene, 80, 45, settings);
  renderer.draw();
  const std::vector<float> before = renderer.read().rgb;
  for (auto& [light, use] : scene.cookie_uses) use.roll += 1;
  renderer.set_lights();
  renderer.draw();
  Renderer made_anew(scene, 80, 45, settings);
  made_anew.draw();
  EXPECT_EQ(renderer.read().rgb, made_anew.read().rgb);
  EXPECT_NE(made_anew.read().rgb, before);
}

// What drawing a frame leaves bound must not be what drawing the next one takes for its own.
TEST_F(RendererTest, NextFrameOfTheSameFogIsTheFirstInEveryBundledScene) {
  for (const std::string& name : bundled_scenes()) {
    const Scene scene = read_scene(bundled_scene_path(name));
    for (const Shadows shadows : {Shadows::none, Shadows::shafts}) {
      if (shadows == Shadows::shafts && name != "cookies") continue;
      Renderer renderer(scene, 32, 18,
                        {.fog_lighting = FogLighting::airlight,
                         .samples = 1,
                         .shadows = shadows,
                         .shadow_map_size = 64,
                         .shaft_steps = 4});
      const double visibility = 3 * suggested_visibility(scene);  // lamps have far airlight
      const Picture first = draw(renderer, Fog::from_visibility(FogMode::exp, visibility));
      renderer.draw();
      EXPECT_EQ(renderer.read().rgb, first.rgb) << name << ", shadows " << int(shadows);
    }
  }
}

TEST_F(RendererTest, InterruptedFrameLeavesTheNextOneAsItIs) {
  const Scene scene = read_scene(bundled_scene_path("room"));
  Renderer renderer(scene, 40, 24, {.fog_lighting = FogLighting::airlight});
  const std::vector<float> whole = draw(renderer, Fog::from_visibility(FogMode::exp, 40.0)).rgb;
  int interruptions = 0;
  for (bool is_interrupted = true; is_interrupted; interruptions += is_interrupted) {
    int asked = 0;
    renderer.interrupt_when([&] { return asked++ == interruptions; });
    is_interrupted = false;
    try {
      renderer.draw();
    } catch (const Interrupted&) {
      is_interrupted = true;
    }
    EXPECT_EQ(asked, interruptions + (is_interrupted ? 1 : 0));  // and no more
    renderer.interrupt_when({});
    renderer.draw();
    EXPECT_EQ(renderer.read().rgb, whole) << interruptions;
  }
  EXPECT_GT(interruptions, 5);
}

TEST_F(RendererTest, MoreSamplesThanTheDriverHasAreUnsupported) {
  EXPECT_THROW(draw(open_air(Cone{}), Fog{}, {.samples = 1 << 16}), gl::Unsupported);
}

/// Boxes in a row and lamps in a row beside it.
Scene rows(int boxes, int lamps, const Attenuation& attenuation) {
  Scene scene;
  scene.camera = {.position = {0, 6, 0}, .target = {0, 0, -20}, .field_of_view = 1.0f};
  scene.models.push_back(make_model("box", {}));
  add_materials(scene);
  for (int i = 0; i < boxes; ++i) {
    scene.instances.push_back({0, glm::translate(glm::mat4(1), glm::vec3(0, 0, -float(i)))});
  }
  PlacedLight lamp;
  lamp.light = {.name = "lamp", .attenuation = attenuation, .cone = {}};
  lamp.direction = {0, -1, 0};
  for (int i = 0; i < lamps; ++i) {
    lamp.position = {3, 2, -double(i) * boxes / lamps};
    scene.lights.push_back(lamp);
  }
  return scene;
}

/// The light of a picture's pixels together.
double total(const Picture& picture) { return std::accumulate(picture.rgb.begin(), picture.rgb.end(), 0.0); }

/// What the point of a lamp adds to a picture, whose height shows 6 m at the middle of a thin wall.
///
/// range   metres from the eye to the wall
/// before  metres from the middle of the wall, towards the eye, to the lamp
double seen_point(float range, double before) {
  Scene scene;
  scene.camera = {.position = {0, 1, range}, .target = {0, 1, 0}, .field_of_view = 6 / range};
  scene.models.push_back(make_model("box", {{"width_m", 20}, {"depth_m", 0.02}, {"height_m", 20}}));
  scene.instances.push_back({0, glm::translate(glm::mat4(1), glm::vec3(0, -5, 0))});
  add_materials(scene);
  PlacedLight lamp;
  lamp.light.attenuation = {1, 0, 1e-4};
  lamp.position = {0, 1, before};
  scene.lights = {lamp};
  Renderer renderer(scene, kWidth, kHeight, {});
  renderer.draw(LightPoints::on);
  const double with_points = total(renderer.read());
  renderer.draw(LightPoints::off);
  return with_points - total(renderer.read());
}

TEST_F(RendererTest, LightBeyondHalfFloatsIsWholeWhenDrawnInFloats) {
  for (const FogLighting fog_lighting : {FogLighting::peak, FogLighting::airlight}) {
    Scene scene = open_air(Cone{});
    scene.environment.sky_zenith = scene.environment.sky_horizon = glm::vec3(0.3f, 8e4f, 2e6f);
    Renderer renderer(scene, kWidth, kHeight, {.fog_lighting = fog_lighting});
    EXPECT_TRUE(is_cut_off(draw(renderer, Fog{FogMode::exp, 0})));
    const glm::dvec3 whole = pixel(renderer.draw_in_floats(), kWidth / 2, kHeight / 4);
    EXPECT_NEAR(whole.g, 8e4, 1);
    EXPECT_NEAR(whole.b, 2e6, 10);
    renderer.draw();  // in half floats again
    EXPECT_LT(pixel(renderer.read(), kWidth / 2, kHeight / 4).g, 7e4);
    scene.environment.sky_zenith = scene.environment.sky_horizon = glm::vec3(0.3f);
    renderer.draw();
    EXPECT_FALSE(is_cut_off(renderer.read()));
  }
}

TEST_F(RendererTest, PointOfALampShortlyBehindAWallIsHidden) {
  EXPECT_GT(seen_point(20, 0.05), 0);
  EXPECT_EQ(seen_point(20, -0.2), 0);  // its light passes the wall all the same: there are no shadows
  EXPECT_EQ(seen_point(20, -0.35), 0);
}

TEST_F(RendererTest, PointOfALampShortlyBehindAWallIsHiddenFromKilometresAway) {
  if (!has_clip_control()) GTEST_SKIP() << "the driver has no GL_ARB_clip_control, which exact depths need";
  for (const float range : {400.0f, 2000.0f, 10'000.0f}) {
    EXPECT_GT(seen_point(range, 0.05), 0) << range;
    EXPECT_EQ(seen_point(range, -0.2), 0) << range;
    EXPECT_EQ(seen_point(range, -0.5), 0) << range;
  }
}

TEST_F(RendererTest, GlareOfALampDoesNotShrinkAsFogThickens) {
  Scene scene = open_air(Cone{});
  scene.environment = {};
  scene.lights[0].carried = false;
  scene.lights[0].position = {0, 2, -30};
  std::ptrdiff_t widest = 0;
  for (const double visibility : {1000.0, 300.0, 100.0}) {
    const Picture picture = draw(scene, Fog::from_visibility(FogMode::exp, visibility));
    const auto lit = std::ranges::count_if(picture.rgb, [](float value) { return value > 0; });
    EXPECT_GE(lit, widest) << visibility;
    widest = std::max(widest, lit);
  }
  EXPECT_GT(widest, 3 * 12);  // more than a point that has not grown
}

// By airlight the fog around a lamp is lit apart, so that its point has to stay as small as in clear air.
TEST_F(RendererTest, PointOfALampMakesNoHaloOfItsOwnByAirlight) {
  Scene scene = open_air(Cone{});
  scene.environment = {};
  scene.lights[0].carried = false;
  scene.lights[0].position = {0, 2, -30};
  const auto lit_by_point = [&](const Fog& fog) {
    Renderer renderer(scene, kWidth, kHeight, {.fog_lighting = FogLighting::airlight});
    renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
    renderer.draw(LightPoints::on);
    const Picture with = renderer.read();
    renderer.draw(LightPoints::off);
    const Picture without = renderer.read();
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < with.rgb.size(); ++i) count += with.rgb[i] != without.rgb[i];
    return count;
  };
  const std::ptrdiff_t in_clear_air = lit_by_point(Fog{});
  EXPECT_GT(in_clear_air, 0);
  for (const double visibility : {1000.0, 100.0, 30.0}) {
    const std::ptrdiff_t in_fog = lit_by_point(Fog::from_visibility(FogMode::exp, visibility));
    EXPECT_GT(in_fog, 0) << visibility;
    EXPECT_LE(in_fog, in_clear_air) << visibility;
  }
}

TEST_F(RendererTest, PartOfAMaterialThatTheSceneLacksIsAnError) {
  Scene scene = rows(1, 1, {1, 0, 0.01});
  scene.materials.clear();
  EXPECT_THROW(Renderer(scene, 8, 8, {}), std::invalid_argument);
}

TEST_F(RendererTest, FiftyThousandBoxesUnderTwentyThousandLampsLoadInSeconds) {
  const auto start = std::chrono::steady_clock::now();
  const Scene scene = rows(50'000, 20'000, {1, 0, 19.0 / 16});
  EXPECT_NO_THROW(Renderer(scene, 8, 8, {.skipping = Skipping::on}));
  EXPECT_NO_THROW(Renderer(scene, 8, 8, {.skipping = Skipping::off}));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST_F(RendererTest, LightsPerFragmentAreExactBeyondWhatHalfFloatsHold) {
  constexpr std::size_t kLights = 70'001;
  const Scene scene = rows(12, kLights, {1, 0, 0.01});
  Renderer renderer(scene, 4, 4, {.skipping = Skipping::off});
  EXPECT_EQ(renderer.draw_and_measure().lights_per_fragment, double(kLights));
}

TEST_F(RendererTest, LightListThatMemoryCannotHoldIsAnError) {
  const Scene scene = rows(50'000, 20'000, {1, 0, 0});  // each lamp reaches everything
  EXPECT_THROW(Renderer(scene, 8, 8, {.skipping = Skipping::on}), gl::Unsupported);
}

TEST_F(RendererTest, MoreLightMapsThanMemoryHoldsAreAnErrorBeforeTheFirstIsMade) {
  Scene scene = open_air(Cone{});
  const PlacedLight lamp = scene.lights[0];
  for (int i = 0; i < 64; ++i) {
    scene.lights.push_back(lamp);
    scene.lights.back().light.attenuation = {1, 0.01 * i, 0.1};
  }
  const RenderSettings large{.path = find_lighting_path("lookup-3d"), .papers = {.map_size = 256}};  // 32 MiB a lamp
  const std::clock_t start = std::clock();
  EXPECT_THROW(Renderer(scene, 8, 8, large), gl::Unsupported);
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 1);  // a GiB of maps takes five
}

TEST_F(RendererTest, FillingATextureLeavesThoseThatAreBound) {
  const float texel[] = {1, 2, 3, 4};
  const BufferTexture buffer(texel, sizeof(texel), BufferTexture::Texel::float4);
  const LayeredTexture layers(1, 1, {7});
  const Texture plain(glm::vec4(1));
  buffer.bind(kCookieConeUnit);
  layers.bind(kCookieConeUnit);
  plain.bind(kCookieConeUnit);
  const auto bound = [] {
    glActiveTexture(GL_TEXTURE0 + kCookieConeUnit);
    std::array<GLint, 3> names{};
    glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &names[0]);
    glGetIntegerv(GL_TEXTURE_BINDING_2D_ARRAY, &names[1]);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &names[2]);
    return names;
  };
  const std::array<GLint, 3> before = bound();
  EXPECT_TRUE(std::ranges::none_of(before, [](GLint name) { return name == 0; }));
  const BufferTexture other_buffer(texel, sizeof(texel), BufferTexture::Texel::float4);
  EXPECT_EQ(bound(), before);
  const LayeredTexture other_layers(1, 1, {7});
  EXPECT_EQ(bound(), before);
  const Texture other_plain(glm::vec4(1));
  EXPECT_EQ(bound(), before);
}

TEST_F(RendererTest, BufferTextureLargerThanTheContextAllowsIsAnError) {
  const std::vector<std::int32_t> texels(BufferTexture::max_texels() + 1);
  EXPECT_THROW(BufferTexture(texels.data(), texels.size() * sizeof(std::int32_t), BufferTexture::Texel::int1),
               gl::Unsupported);
}

TEST_F(RendererTest, LightThatIsDarkEverywhereHasNoPoint) {
  Scene scene = open_air(Cone{});
  scene.lights[0].carried = false;
  scene.lights[0].position = {0, 2, -10};
  Scene dark = scene;
  dark.lights[0].light.attenuation = {100, 0, 0};  // 1 % at the lamp: below the threshold
  Scene none = scene;
  none.lights.clear();
  const Picture without = draw(none, Fog{});
  EXPECT_GT(largest_difference(draw(scene, Fog{}), without), 0.1);
  EXPECT_EQ(largest_difference(draw(dark, Fog{}), without), 0);
}

TEST_F(RendererTest, LargestFiguresOfASceneGiveFinitePixels) {
  Scene scene = rows(3, 3, {1, 0, 0.01});
  for (PlacedLight& light : scene.lights) {
    light.light.color = glm::dvec3(1e4);
    light.light.density_scale = 1e6;
    light.light.cone = Cone::cosine(0.5, 1e300);
  }
  scene.lights[1].carried = true;
  scene.lights[2].position = scene.camera.position;
  for (const double visibility : {1e-300, 1e-3, 50.0, 1e300}) {
    for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
      const Picture picture = draw(scene, Fog::from_visibility(mode, visibility));
      EXPECT_TRUE(std::ranges::all_of(picture.rgb, [](float value) { return std::isfinite(value); })) << visibility;
    }
  }
}

TEST_F(RendererTest, LampAtTheEyeToTheLastBitGivesFinitePixelsByAirlight) {
  Scene scene = rows(3, 3, {1, 0, 0.01});
  PlacedLight& lamp = scene.lights[0];
  lamp.position = scene.camera.position;
  for (const Cone& cone : {Cone{}, Cone::cosine(0.5, 2), Cone::smoothstep(0.2, 0.4)}) {
    for (const Attenuation& attenuation : {Attenuation{1, 0, 0.01}, Attenuation{0, 0, 1}}) {
      lamp.light.cone = cone;
      lamp.light.attenuation = attenuation;
      for (const Shadows shadows : {Shadows::none, Shadows::shafts}) {
        Renderer renderer(scene, 16, 9, {.fog_lighting = FogLighting::airlight, .shadows = shadows});
        for (const double visibility : {1e-300, 1e-3, 50.0, 1e300}) {
          for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
            renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(mode, visibility)));
            renderer.draw(LightPoints::on);
            EXPECT_TRUE(std::ranges::all_of(renderer.read().rgb, [](float value) { return std::isfinite(value); }))
                << visibility;
          }
        }
      }
    }
  }
}

/// A floor of 40 m from 6 m above it, and a lamp 1 m above it, which ends after 3 m by its own threshold.
Scene lamp_over_floor() {
  Scene scene;
  scene.camera = {.position = {0, 6, 0.01f}, .target = {0, 0, -0.6f}, .field_of_view = 1.6f};
  scene.models.push_back(make_model("box", {{"width_m", 40}, {"depth_m", 40}, {"height_m", 0.2}}));
  add_materials(scene);
  scene.instances.push_back({0, glm::translate(glm::mat4(1), glm::vec3(0, -0.2f, 0))});
  PlacedLight lamp;
  lamp.light = {.name = "lamp", .attenuation = {1, 0, 19.0 / 9}, .cone = {}};  // extent 3 m
  lamp.position = {0, 1, -0.6};
  lamp.direction = {0, -1, 0};
  lamp.carried = true;
  scene.lights.push_back(lamp);
  return scene;
}

// By airlight a light ends where it is 1/255 at 0 EV: for this lamp after 6 m, which the corner is farther off.
TEST_F(RendererTest, LightsHaveNoEndOnSurfacesByAirlightButOfMapsOneThatMovesOutwardsWithTheExposure) {
  Scene scene = lamp_over_floor();
  scene.lights[0].light.attenuation.quadratic = 254.0 / 36;
  const auto corner_at = [](Renderer& renderer, double ev) {
    renderer.set_exposure({.ev = ev});
    renderer.draw();
    return std::exp2(ev) * pixel(renderer.read(), 1, 1).g;
  };
  Renderer by_airlight(scene, kWidth, kHeight, {.fog_lighting = FogLighting::airlight});
  const double beyond = corner_at(by_airlight, 0);
  EXPECT_GT(beyond, 0);
  EXPECT_NEAR(corner_at(by_airlight, 5.5), std::exp2(5.5) * beyond, 0.01 * std::exp2(5.5) * beyond);
  EXPECT_NEAR(corner_at(by_airlight, -3), std::exp2(-3) * beyond, 0.01 * std::exp2(-3) * beyond);
  Renderer by_maps(scene, kWidth, kHeight,
                   {.path = find_lighting_path("lookup-3d"), .fog_lighting = FogLighting::airlight});
  EXPECT_EQ(corner_at(by_maps, 0), 0);
  EXPECT_GT(corner_at(by_maps, 5.5), 1 / (255 * 12.92)) << "a step of a display, whose darkest slope is sRGB's";
  EXPECT_EQ(corner_at(by_maps, -3), 0);
  Renderer by_peak(scene, kWidth, kHeight, {});
  EXPECT_EQ(corner_at(by_peak, 5.5), 0) << "the papers' lights end at their own thresholds";
}

// Flat normals have a shader of their own; a bumpy map of scale 0 does not.
TEST_F(RendererTest, FlatNormalsGiveThePictureOfAMapWithoutScaleByEveryPath) {
  Scene scene = lamp_over_floor();
  Material& material = scene.materials[0];
  material = make_material("brick");
  material.name = scene.models[0][0].material;
  material.relief_m = 0;
  for (const LightingPath& path : lighting_paths()) {
    const auto picture_of = [&](std::shared_ptr<const Texels> normals, float scale) {
      material.normal = std::move(normals);
      material.normal_scale = scale;
      return draw(scene, Fog{}, {.path = &path});
    };
    const auto bumps = make_material("brick").normal;
    const Picture bumpy = picture_of(bumps, 4);
    const Picture without_scale = picture_of(bumps, 0);
    const Picture flat = picture_of(std::make_shared<const Texels>(Texels{1, 1, {128, 128, 255, 0}}), 1);
    double change = 0;
    double error = 0;
    for (std::size_t i = 0; i < flat.rgb.size(); ++i) {
      change = std::max(change, std::abs(double(bumpy.rgb[i]) - double(flat.rgb[i])));
      error = std::max(error, std::abs(double(without_scale.rgb[i]) - double(flat.rgb[i])));
    }
    EXPECT_LE(error, 5e-4) << path.name << ": half floats";
    EXPECT_EQ(change > 5e-3, path.has_normal_maps) << path.name << ", " << change;
  }
}

// A lamp over a box shines past it: the box alone bounds how far its shadow map reaches.
TEST_F(RendererTest, FogBeyondAllThatCastsShadowsIsLit) {
  Scene scene;
  scene.camera = {.position = {30, 3, 40}, .target = {30, 3, 0}, .field_of_view = 0.8f};
  scene.models = {make_model("box", {{"width_m", 1}, {"depth_m", 1}, {"height_m", 1}})};
  scene.instances = {{0, glm::translate(glm::mat4(1), glm::vec3(-3, 0, 0))}};
  add_materials(scene);
  PlacedLight lamp;
  lamp.light = {.name = "lamp", .color = {5, 5, 5}, .attenuation = {1, 0, 0.001}, .cone = Cone::smoothstep(0.2, 0.4)};
  lamp.position = {0, 3, 0};
  lamp.direction = {1, 0, 0};
  scene.lights.push_back(lamp);
  scene.atmosphere.phase = {};
  const Fog fog = Fog::from_visibility(FogMode::exp, 200);
  const Picture whole = draw(scene, fog, {.fog_lighting = FogLighting::airlight});
  ASSERT_GT(pixel(whole, kWidth / 2, kHeight / 2).g, 0.02);
  const Picture shadowed = draw(scene, fog, {.fog_lighting = FogLighting::airlight, .shadows = Shadows::shafts});
  EXPECT_LT(largest_difference(shadowed, whole), 0.0005);  // the framebuffer rounds to 11 bits
}

}  // namespace

}  // namespace litfog::test
