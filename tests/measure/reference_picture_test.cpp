// SPDX-License-Identifier: Apache-2.0
#include "measure/reference_picture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <numeric>
#include <optional>

#include "command/no_more_threads.h"
#include "gl/gl_test.h"
#include "measure/path_model.h"
#include "measure/picture_error.h"
#include "reference/degree.h"
#include "reference/srgb.h"
#include "render/pixel.h"
#include "scene/file/scene_file.h"
#include "scene/model/model_catalogue.h"
#include "scene/paint/material_catalogue.h"

namespace litfog::test {
using namespace render;
using namespace scene;
using namespace measure;

namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 90;

class ReferencePictureTest : public test::GlTest {};

ReferencePicture shade(const Scene& scene, const Fog& fog) {
  Renderer renderer(scene, kWidth, kHeight, {});
  renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
  return shade_reference(renderer);
}

/// A floor at height 0, 40 m square, seen from above, whose material is known to the last bit.
Scene flat_floor() {
  Scene scene;
  scene.camera = {.position = {0.5f, 5, 8}, .target = {0, 0, 1}, .field_of_view = 0.9f};
  scene.environment.ambient_light = {0.02f, 0.03f, 0.04f};
  scene.atmosphere.ambient_fog_color = {0.1f, 0.11f, 0.12f};
  scene.materials.push_back({.name = "plain",
                             .size_m = 1,
                             .albedo = std::make_shared<const Texels>(Texels{1, 1, {255, 0, 255, 51}}),
                             .normal = std::make_shared<const Texels>(Texels{1, 1, {0, 255, 255, 255}}),
                             .specular = glm::vec3(0.5f),
                             .shininess = 20,
                             .emissive = {0, 0.01f, 0}});
  Mesh mesh;
  for (const glm::vec2 corner : {glm::vec2(-20, 20), glm::vec2(20, 20), glm::vec2(20, -20), glm::vec2(-20, -20)}) {
    mesh.vertices.push_back({{corner.x, 0, corner.y}, {0, 1, 0}, {1, 0, 0, 1}, corner});
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  scene.models.push_back({Part{"plain", mesh}});
  scene.instances.push_back({0, glm::mat4(1)});
  return scene;
}

// The floor where the pixel's ray meets y = 0: the Basic model under one lamp, and Hales's fog before it, written out.
TEST_F(ReferencePictureTest, FloorUnderALampIsTheModelInClosedForm) {
  Scene scene = flat_floor();
  PlacedLight lamp;
  lamp.light = {.name = "lamp", .color = {0.9, 0.6, 0.3}, .attenuation = {1, 0.1, 0.05}, .cone = Cone::cosine(1.2, 3)};
  lamp.position = {-1, 3, 0};
  lamp.direction = glm::normalize(glm::dvec3(0.1, -1, 0.2));
  lamp.carried = true;
  scene.lights.push_back(lamp);
  const Fog fog = Fog::from_visibility(FogMode::exp2, 30.0);
  const double intensity = solve_fog_intensity(lamp.light, fog).intensity;
  const double reach = compute_extent(lamp.light.attenuation, lamp.light.threshold);
  // From the normal map's one texel, (-1, 1, 1) in the floor's tangent space: u grows to +x, v to -z.
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-1, 1, -1));
  const glm::dvec3 diffuse(1, 0, 1);
  const glm::dvec3 eye = scene.camera.position;
  const ReferencePicture reference = shade(scene, fog);
  int lit = 0;
  for (int y = kHeight / 3; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const glm::dvec3 view = view_direction(scene.camera, kWidth, kHeight, x + 0.5, y + 0.5);
      const glm::dvec3 position = eye - view * (eye.y / view.y);
      if (std::abs(position.x) > 19 || std::abs(position.z) > 19) continue;
      const glm::dvec3 to_light = glm::normalize(lamp.position - position);
      const double range = glm::distance(lamp.position, position);
      const double angle = std::acos(-glm::dot(to_light, lamp.direction));
      if (std::abs(angle - 1.2) < 1e-4 || std::abs(range - reach) < 1e-4) continue;
      const double cone = angle < 1.2 ? std::pow(std::cos(angle), 3) : 0;
      const double facing = glm::dot(normal, to_light);
      if (std::abs(facing) < 1e-5) continue;
      glm::dvec3 expected = glm::dvec3(scene.environment.ambient_light) * diffuse + glm::dvec3(0, 0.01f, 0);
      if (range < reach && facing > 0 && cone > 0) {
        const double highlight = std::max(0.0, glm::dot(normal, glm::normalize(to_light - view)));
        expected += lamp.light.color * cone / (1 + 0.1 * range + 0.05 * range * range) *
                    (diffuse * facing + 0.5 * 0.2 * std::pow(highlight, 20));
        ++lit;
      }
      const glm::dvec3 fog_color =
          glm::dvec3(scene.atmosphere.ambient_fog_color) + lamp.light.color * (cone * intensity);
      expected = glm::mix(fog_color, expected, fog_factor_at(fog, glm::distance(position, eye)));
      // The GPU interpolates the position in floats, and at its own places: some thousandths of a pixel.
      ASSERT_LT(glm::distance(pixel(reference.picture, x, y), expected), 3e-4) << x << ", " << y;
    }
  }
  EXPECT_GT(lit, 1000);
}

// The floor behind a layer, with the eye above, within, on the edge of and below its ramp; and the sky above the floor.
TEST_F(ReferencePictureTest, FloorAndSkyBehindLayersAreDimmedByTheirDepth) {
  Scene scene = flat_floor();
  scene.environment.sky_zenith = scene.environment.sky_horizon = {0.7f, 0.6f, 0.5f};
  const auto layers = [](double base, double top) {
    const FogLayer layer{.base = base, .top = top, .transition = 1.5, .visibility = 12};
    return make_density_profile(std::span(&layer, 1));
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const DensityProfile& profile : {layers(-kInfinity, 2), layers(-kInfinity, 4.5), layers(-kInfinity, 5),
                                        layers(-kInfinity, 30), layers(6.5, 9), layers(20, 40)}) {
    const Atmosphere air{.ambient_fog_color = scene.atmosphere.ambient_fog_color, .profile = profile};
    for (const glm::dvec3 target : {glm::dvec3{0, 0, 1}, glm::dvec3{0, 5, 1}, glm::dvec3{0, 9, 1}}) {
      scene.camera.target = target;
      Renderer renderer(scene, kWidth, kHeight, {.fog_lighting = FogLighting::peak, .samples = 1});
      renderer.set_atmosphere(air);
      renderer.draw();
      const Picture drawn = renderer.read();
      const ReferencePicture reference = shade_reference(renderer);
      const glm::dvec3 eye = scene.camera.position;
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          const glm::dvec3 view = view_direction(scene.camera, kWidth, kHeight, x + 0.5, y + 0.5);
          const glm::dvec3 position = eye - view * (eye.y / view.y);
          const bool is_sky = view.y > 0.01;
          if (!is_sky && !(view.y < 0 && std::abs(position.x) < 19 && std::abs(position.z) < 19)) continue;
          const double depth = is_sky ? optical_depth_to_sky(profile, eye.y, view.y)
                                      : air.fog_between(position.y, eye.y).density * glm::distance(position, eye);
          const glm::dvec3 surface =
              is_sky ? glm::dvec3(scene.environment.sky_zenith)
                     : glm::dvec3(scene.environment.ambient_light) * glm::dvec3(1, 0, 1) + glm::dvec3(0, 0.01f, 0);
          const glm::dvec3 expected = glm::mix(air.ambient_fog_color, surface, std::exp(-depth));
          ASSERT_LT(glm::distance(pixel(reference.picture, x, y), expected), 3e-4) << x << ", " << y;
          ASSERT_LT(glm::distance(pixel(drawn, x, y), expected), 1e-3) << x << ", " << y;  // half floats
        }
      }
    }
  }
}

TEST_F(ReferencePictureTest, ReferenceIsTheSameWhereNoThreadCanStart) {
  const Scene scene = flat_floor();
  Renderer renderer(scene, kWidth, kHeight, {});
  const ReferencePicture usual = shade_reference(renderer);
  const NoMoreThreads limit;
  EXPECT_EQ(shade_reference(renderer).picture.rgb, usual.picture.rgb);
}

TEST_F(ReferencePictureTest, PixelOnAnEdgeOfTheModelIsExcluded) {
  Scene scene;
  scene.camera = {.position = {0, 2, 0}, .target = {0, 2.2f, -10}, .field_of_view = 1.0f};
  PlacedLight light;
  light.light.attenuation = {1, 0, 0.01};
  light.position = scene.camera.position;
  light.carried = true;
  const int x = 90;
  const int y = 40;
  const glm::dvec3 edge = view_direction(scene.camera, kWidth, kHeight, x + 0.5, y + 0.5);
  light.direction = glm::normalize(edge + glm::dvec3(0.1, 0.05, 0));
  light.light.cone = Cone::cosine(std::acos(glm::dot(light.direction, edge)), 0);
  scene.lights.push_back(light);
  const ReferencePicture reference = shade(scene, Fog::from_visibility(FogMode::exp, 50.0));
  EXPECT_EQ(reference.is_at_jump[std::size_t(y * kWidth + x)], 1);
  EXPECT_LT(std::accumulate(reference.is_at_jump.begin(), reference.is_at_jump.end(), 0), 10);
}

/// Nothing but a bright sky above and below the horizon, and grey fog up to a height.
Scene sky_over_fog(double fog_top, float pitch) {
  Scene scene;
  scene.camera = {.position = {3, 20, -7}, .target = {4, 20 + pitch, -17}, .field_of_view = 0.9f};
  scene.environment.sky_zenith = {0.9f, 0.8f, 0.7f};
  scene.environment.sky_horizon = {0.2f, 0.3f, 0.4f};
  scene.atmosphere.ambient_fog_color = glm::vec3(0.05f);
  scene.environment.star_brightness = 0.7f;
  scene.environment.moon_direction = glm::normalize(glm::vec3(0.3f, 0.5f, -1));
  scene.environment.moon_color = glm::vec3(0.1f);
  scene.atmosphere.top = fog_top;
  return scene;
}

// Fog of an even density up to a height: a ray of slope y leaves it after (top - eye) / y metres.
TEST_F(ReferencePictureTest, SkyIsSeenThroughTheFogUpToItsTop) {
  const Scene scene = sky_over_fog(60, 1.5f);
  Scene clear = scene;
  clear.atmosphere.top = -1e300;
  const Fog fog = Fog::from_visibility(FogMode::exp, 400.0);
  const ReferencePicture behind = shade(clear, Fog{});
  const ReferencePicture reference = shade(scene, fog);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double rise = view_direction(scene.camera, kWidth, kHeight, x + 0.5, y + 0.5).y;
      const double through = rise > 0 ? fog_factor_at(fog, (60 - 20) / rise) : 0;
      const glm::dvec3 expected = glm::mix(glm::dvec3(0.05f), pixel(behind.picture, x, y), through);
      ASSERT_LT(glm::distance(pixel(reference.picture, x, y), expected), 1e-6) << x << ", " << y;
    }
  }
}

TEST_F(ReferencePictureTest, FogBelowTheEyeHidesTheSkyBelowTheHorizonOnly) {
  const Scene scene = sky_over_fog(19, -1.0f);
  Scene clear = scene;
  clear.atmosphere.top = -1e300;
  const ReferencePicture behind = shade(clear, Fog{});
  const ReferencePicture reference = shade(scene, Fog::from_visibility(FogMode::exp, 400.0));
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool is_hidden = view_direction(scene.camera, kWidth, kHeight, x + 0.5, y + 0.5).y < 0;
      const glm::dvec3 expected = is_hidden ? glm::dvec3(0.05f) : pixel(behind.picture, x, y);
      ASSERT_LT(glm::distance(pixel(reference.picture, x, y), expected), 1e-6) << x << ", " << y;
    }
  }
}

// An odd height: one row of pixels looks along the level, where fog seen from above ends.
TEST_F(ReferencePictureTest, SkyThroughFogIsDrawnAsTheReferenceHasIt) {
  for (const double fog_top : {-1e300, -300.0, 19.999, 20.0, 20.001, 25.0, 120.0, 3000.0, 1e5, 1e300,
                               std::numeric_limits<double>::infinity()}) {
    for (const float pitch : {-4.0f, 0.0f, 3.0f}) {
      const Scene scene = sky_over_fog(fog_top, pitch);
      Renderer renderer(scene, kWidth, kHeight + 1, {});
      for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
        for (const double visibility : {0.0, 30.0, 1500.0, 20'000.0}) {
          renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(mode, visibility)));
          renderer.draw();
          const PictureError error = picture_error(renderer.read(), shade_reference(renderer));
          EXPECT_LE(error.largest, 0.25) << fog_top << ", " << pitch << ", " << visibility;
          EXPECT_LE(error.excluded, std::size_t{kWidth}) << fog_top << ", " << pitch << ", " << visibility;
        }
      }
    }
  }
}

TEST_F(ReferencePictureTest, MoonlitFogIsDrawnAsTheReferenceHasIt) {
  const FogLayer ground{.top = 3, .transition = 4, .visibility = 40};
  const FogLayer cloud{.base = 12, .top = 30, .transition = 2, .visibility = 60};
  const Fog fog = Fog::from_visibility(FogMode::exp, 60.0);
  Scene scene = flat_floor();
  scene.environment.sky_zenith = scene.environment.sky_horizon = {0.02f, 0.02f, 0.03f};
  scene.environment.moon_direction = glm::normalize(glm::vec3(0.2f, 0.5f, -1));
  scene.environment.moon_color = {0.3f, 0.3f, 0.4f};
  std::vector<Atmosphere> airs(7, Atmosphere{.phase = Phase::droplets(10), .ambient_fog_color = glm::dvec3(0.01)});
  airs[0].profile = make_density_profile(std::span(&ground, 1));
  airs[1].profile = make_density_profile(std::span(&cloud, 1));
  airs[2].fog = airs[3].fog = fog;
  airs[2].top = 30;
  airs[3].top = 2;
  for (std::size_t i = 4; i < 7; ++i) {  // haze and layers; the top of one is below its layer's
    airs[i].fog = Fog::from_visibility(FogMode::exp, 3000.0);
    airs[i].profile = airs[i % 2].profile;
    if (i > 4) airs[i].top = 18;
  }
  for (const LightingPath& path : lighting_paths()) {
    if (!path.takes_airlight || !path.has_reference) continue;
    for (const Atmosphere& air : airs) {
      for (const glm::dvec3 target : {glm::dvec3{0, 0, 1}, glm::dvec3{1, 7, 0}}) {
        scene.camera.target = target;
        Renderer renderer(scene, kWidth, kHeight, {.path = &path, .fog_lighting = FogLighting::airlight});
        renderer.set_atmosphere(air);
        renderer.draw();
        const ReferencePicture reference = shade_reference(renderer);
        const PictureError error = picture_error(renderer.read(), reference);
        EXPECT_LE(error.largest, 0.5) << path.name << ", top " << air.top << ", looking up to " << target.y;
        EXPECT_LE(error.mean, 0.05) << path.name << ", top " << air.top << ", looking up to " << target.y;
      }
    }
  }
}

TEST_F(ReferencePictureTest, ReferenceHasTheRenderersSamples) {
  const Scene scene = read_scene(bundled_scene_path("room"));
  for (const FogLighting fog_lighting : {FogLighting::peak, FogLighting::airlight}) {
    for (const int samples : {1, 2, 4}) {
      for (const std::string_view path : {"unified", "accumulate"}) {  // one pass and several passes
        Renderer renderer(scene, 64, 36,
                          {.path = find_lighting_path(path), .fog_lighting = fog_lighting, .samples = samples});
        renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp, 20.0)));
        renderer.draw(LightPoints::off);
        const PictureError error = picture_error(renderer.read(), shade_reference(renderer));
        EXPECT_LE(error.mean, 0.05) << path << ", " << samples << " samples";
        EXPECT_LE(error.largest, 1) << path << ", " << samples << " samples";
      }
    }
  }
}

/// What a path is held to at 160x90, clear and in both kinds of fog, in 1/255. Every pixel is compared, those on the
/// edges of surfaces too, for the samples are the same.
struct PathBound {
  double beyond_maps;  ///< bound of the largest error beyond what light maps leave open
  double mean;
};

/// A formula at each fragment errs by the framebuffer's half floats alone. Where they are coarsest on the display, at
/// 0.5, their last place is 2^-11, which is 0.082 steps there; samples and their mean are rounded, by some drivers
/// towards zero: 0.164.
constexpr PathBound kFragmentBound{0.25, 0.05};
/// A look-up lies between the light's values at the texels around it (LookupBounds), 128 a side. Beyond that, the
/// rounding of floats.
constexpr PathBound kLookupBound{0.25, 0.05};

/// What falls within a triangle is missed by light from its vertices, however bright: these errors are those of the
/// bundled scenes' tessellation, measured, and 5 % of margin. PathsThatLightVerticesConvergeInTheSecondOrder has the
/// law.
///
/// Light maps blur the edge of a cosine cone over a texel. In `street` and `city`, whose lamps end at 80 degrees with a
/// sixth of their light, that is most of a look-up's mean error. It is the less the denser the texels at the edge:
/// scaled, as in the papers (ConeMaps::scaled), a third to a fifth of what even texels err by.
struct SceneBound {
  std::string_view path;
  std::string_view scene;
  PathBound bound;
};
constexpr SceneBound kSceneBounds[] = {
    {"radial", "street", {kLookupBound.beyond_maps, 0.093}},
    {"radial-plane", "street", {kLookupBound.beyond_maps, 0.093}},
    {"accumulate", "street", {kLookupBound.beyond_maps, 0.093}},
    {"lookup-3d", "city", {kLookupBound.beyond_maps, 0.083}},
    {"lookup-2d", "city", {kLookupBound.beyond_maps, 0.078}},
    {"radial", "city", {kLookupBound.beyond_maps, 0.35}},
    {"radial-plane", "city", {kLookupBound.beyond_maps, 0.35}},
    {"accumulate", "city", {kLookupBound.beyond_maps, 0.35}},
    {"vertex", "approach", {266, 1.29}},
    {"vertex", "city", {128, 23.9}},
    {"vertex", "cookies", {270, 45.8}},
    {"vertex", "flare", {37.7, 4.08}},
    {"vertex", "headlights", {134, 2.24}},
    {"vertex", "lighthouse", {63.1, 2.81}},
    {"vertex", "road", {128, 0.836}},
    {"vertex", "room", {36, 1.48}},
    {"vertex", "street", {102, 4.78}},
    {"vertex", "tessellation", {131, 3.23}},
    {"mixed", "approach", {266, 0.724}},
    {"mixed", "city", {119, 24}},
    {"mixed", "cookies", {270, 45.8}},
    {"mixed", "flare", {76, 15.4}},
    {"mixed", "headlights", {143, 2.25}},
    {"mixed", "lighthouse", {63.1, 2.89}},
    {"mixed", "road", {128, 0.483}},
    {"mixed", "room", {35.2, 1.3}},
    {"mixed", "street", {101, 3.12}},
    {"mixed", "tessellation", {131, 3.14}},
    {"tangent", "approach", {154, 0.157}},
    {"tangent", "city", {50.3, 0.108}},
    {"tangent", "cookies", {66.6, 0.278}},
    {"tangent", "flare", {28.2, 0.0308}},
    {"tangent", "headlights", {66.1, 0.137}},
    {"tangent", "lighthouse", {6.88, 0.00651}},
    {"tangent", "road", {55.7, 0.22}},
    {"tangent", "room", {7.09, 0.00893}},
    {"tangent", "street", {79.2, 0.249}},
    {"tangent", "tessellation", {36, 0.311}},
    {"legacy", "approach", {266, 0.623}},
    {"legacy", "city", {117, 23.4}},
    {"legacy", "cookies", {271, 45.3}},
    {"legacy", "flare", {13.5, 1.04}},
    {"legacy", "headlights", {135, 2.29}},
    {"legacy", "lighthouse", {11.8, 0.0206}},
    {"legacy", "road", {128, 0.382}},
    {"legacy", "room", {35, 1.3}},
    {"legacy", "street", {101, 2.06}},
    {"legacy", "tessellation", {118, 3.05}},
};

std::optional<PathBound> bound_of(const LightingPath& path, std::string_view scene) {
  for (const SceneBound& bound : kSceneBounds) {
    if (bound.path == path.name && bound.scene == scene) return bound.bound;
  }
  if (path.evaluation == Evaluation::fragment) return kFragmentBound;
  if (path.evaluation == Evaluation::lookup) return kLookupBound;
  return std::nullopt;
}

class ReferenceOfScene : public test::GlTest, public testing::WithParamInterface<std::string> {};

TEST_P(ReferenceOfScene, EveryPathIsWithinItsBoundInClearAirAndInFog) {
  const std::string& name = GetParam();
  const Scene scene = read_scene(bundled_scene_path(name));
  if (scene.atmosphere.profile.count > 0) GTEST_SKIP() << "layers are drawn by airlight";
  const double visibility = scene.visibilities.at(1);
  for (const LightingPath& path : lighting_paths()) {
    const std::optional<PathBound> bound = bound_of(path, name);
    ASSERT_TRUE(bound) << path.name << " has no bound in " << name;
    Renderer renderer(scene, kWidth, kHeight, {.path = &path});
    for (const auto& [fog_name, fog] : {std::pair{"clear", Fog{}},
                                        {"exp", Fog::from_visibility(FogMode::exp, visibility)},
                                        {"exp2", Fog::from_visibility(FogMode::exp2, visibility)}}) {
      renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
      renderer.draw(LightPoints::off);
      const PictureError error = picture_error(renderer.read(), shade_reference(renderer));
      const std::string measured =
          fmt::format("{:<12} {:<12} {:<5} largest {:7.3f}, beyond maps {:7.3f}, mean {:.4f} of 1/255, {} excluded",
                      path.name, name, fog_name, error.largest, error.beyond_maps, error.mean, error.excluded);
      fmt::print("{}\n", measured);
      EXPECT_LE(error.beyond_maps, bound->beyond_maps) << measured;
      EXPECT_LE(error.mean, bound->mean) << measured;
      EXPECT_LE(error.excluded, std::size_t{kWidth * kHeight / 400}) << measured;
    }
    // With the lamps' points, which the reference leaves out.
    renderer.set_atmosphere(
        renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp, scene.visibilities[0])));
    renderer.draw();
    const Picture picture = renderer.read();
    EXPECT_TRUE(std::ranges::all_of(picture.rgb, [](float value) { return std::isfinite(value) && value >= 0; }))
        << path.name << ", " << name;
    EXPECT_GT(std::ranges::max(picture.rgb), 0.1f) << path.name << ", " << name;
  }
}

/// In airlight a pixel may err by a step of the display: what of faint lights, and between nodes of the integral and
/// pixels of the grid, may be left out.
constexpr double kAirlightBound = 1;

RenderSettings by_airlight(const LightingPath& path = lighting_paths().front()) {
  return {.path = &path, .fog_lighting = FogLighting::airlight};
}

/// Draws a scene in a fog and compares it with its reference.
PictureError error_in(Renderer& renderer, const Fog& fog) {
  renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
  renderer.draw(LightPoints::off);
  return picture_error(renderer.read(), shade_reference(renderer));
}

TEST_P(ReferenceOfScene, AirlightIsWithinAStepFromClearAirToAMetreOfVisibility) {
  const std::string& name = GetParam();
  const Scene scene = read_scene(bundled_scene_path(name));
  // Each of more than a thousand lamps takes an integral a pixel, and a cookie takes one a texel.
  const bool has_layers = scene.atmosphere.profile.count > 0;
  const int height = scene.lights.size() > 60 || !scene.cookies.empty() ? 12 : 45;
  constexpr double kClear = std::numeric_limits<double>::infinity();
  Renderer renderer(scene, height * 16 / 9, height, by_airlight());
  for (const double visibility : {kClear, 20'000.0, suggested_visibility(scene), 1.0}) {
    for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
      if (mode == FogMode::exp2 && has_layers) continue;
      const PictureError error = error_in(renderer, Fog::from_visibility(mode, visibility));
      const std::string measured =
          fmt::format("{:<12} {:>5} m {:<4} largest {:6.3f}, mean {:.4f} of 1/255, {} excluded", name, visibility,
                      name_of(mode), error.largest, error.mean, error.excluded);
      fmt::print("{}\n", measured);
      // A cookie has detail between nodes: within a metre of a beam in candela they leave one pixel of `road` 4 steps
      // off, and near the projectors of `cookies` one pixel 1.15 steps.
      const bool is_dense_cookie = name == "road" && visibility == 1;
      // Where no fog but the layers bounds what is seen, lamps are summed in slabs longer than the layers.
      const bool has_long_slabs = has_layers && visibility == kClear;
      const double bound = is_dense_cookie ? 4.3 : has_long_slabs ? 3.5 : name == "cookies" ? 1.2 : kAirlightBound;
      EXPECT_LE(error.largest, bound) << measured;
      EXPECT_LE(error.excluded, std::size_t(height * height / 50)) << measured;
    }
  }
}

TEST_F(ReferencePictureTest, MoonlitPictureInHazeThatVanishesIsThatWithoutHaze) {
  for (const char* name : {"village", "street"}) {
    Scene scene = read_scene(bundled_scene_path(name));
    scene.lights.clear();
    scene.atmosphere.profile = make_density_profile(scene.layers);
    for (const double top : {scene.atmosphere.top, std::numeric_limits<double>::infinity(), 100.0}) {
      scene.atmosphere.top = top;
      for (const Scattering scattering : {Scattering::single, Scattering::all}) {
        RenderSettings settings = by_airlight();
        settings.scattering = scattering;
        Renderer renderer(scene, 48, 27, settings);
        renderer.set_exposure({.ev = 5});
        const auto draw = [&](double visibility) {
          renderer.set_atmosphere(scene.atmosphere.with(Fog::from_visibility(FogMode::exp, visibility)));
          renderer.draw();
          return renderer.read();
        };
        const Picture clear = draw(std::numeric_limits<double>::infinity()), haze = draw(1e9);
        const auto shown = [](float value) { return std::min(32 * value, 1.0f); };  // at 5 EV
        float most = 0;
        for (std::size_t i = 0; i < clear.rgb.size(); ++i) {
          most = std::max(most, std::abs(shown(clear.rgb[i]) - shown(haze.rgb[i])));
        }
        EXPECT_LT(most * 255, 1) << name << ", top " << top;
      }
    }
  }
}

// Fog on the ground with the eye in it and above, and a cloud's base over the lamps.
TEST_F(ReferencePictureTest, AirlightInLayersIsThatOfTheReference) {
  const FogLayer ground{.top = 2, .transition = 1.5, .visibility = 40};
  const FogLayer cloud{.base = 4, .transition = 3, .visibility = 60};
  for (const char* name : {"headlights", "street"}) {
    for (const FogLayer& layer : {ground, cloud}) {
      for (const float height : {0.0f, 6.0f}) {
        Scene scene = read_scene(bundled_scene_path(name));
        scene.camera.position.y += height;
        scene.atmosphere.profile = make_density_profile(std::span(&layer, 1));
        Renderer renderer(scene, 48, 27, by_airlight());
        const PictureError error = error_in(renderer, {});
        const std::string measured = fmt::format("{}, layer up to {} m, eye {} m higher: largest {:6.3f}, {} excluded",
                                                 name, layer.top, height, error.largest, error.excluded);
        fmt::print("{}\n", measured);
        EXPECT_LE(error.largest, kAirlightBound) << measured;
        EXPECT_LE(error.excluded, 27u) << measured;
      }
    }
  }
}

TEST_F(ReferencePictureTest, AllOrdersOfScatteringAreThoseOfTheReference) {
  for (const auto& [name, visibility] : {std::pair{"street", 60}, {"street", 300}, {"room", 20}, {"headlights", 50}}) {
    Scene scene = read_scene(bundled_scene_path(name));
    for (const Phase& phase : {Phase{}, Phase::droplets(10)}) {
      scene.atmosphere.phase = phase;
      RenderSettings settings = by_airlight();
      settings.scattering = Scattering::all;
      Renderer renderer(scene, 64, 36, settings);
      const PictureError error = error_in(renderer, Fog::from_visibility(FogMode::exp, visibility));
      const std::string measured =
          fmt::format("{} at {} m, {}: largest {:6.3f}, mean {:6.3f}, {} excluded", name, visibility,
                      is_isotropic(phase) ? "isotropic" : "droplets", error.largest, error.mean, error.excluded);
      fmt::print("{}\n", measured);
      // What fog scatters on a lamp's own housing changes within a texel of the grid of that light.
      EXPECT_LE(error.largest, is_isotropic(phase) ? 9 : 4) << measured;
      EXPECT_LE(error.mean, 0.2) << measured;
      EXPECT_LE(error.excluded, 24u) << measured;
    }
  }
}

// Lamps in ground fog seen from above it, and under a cloud.
// The third is in the cloud, in which rays end or which they leave below.
TEST_F(ReferencePictureTest, AllOrdersInLayersAreThoseOfTheReference) {
  struct View {
    Scene scene;
    double mean;
  };
  const auto scene_of = [](const char* name) { return read_scene(bundled_scene_path(name)); };
  Scene in_cloud = scene_of("breakout");
  in_cloud.camera.position = {0, 95, 1513};
  in_cloud.camera.target = {0, 86, 1113};
  for (const auto& [scene, mean] : {View{scene_of("village"), 0.3}, {scene_of("breakout"), 0.3}, {in_cloud, 0.5}}) {
    RenderSettings settings = by_airlight();
    settings.scattering = Scattering::all;
    Renderer renderer(scene, 48, 27, settings);
    const PictureError error = error_in(renderer, Fog::from_visibility(FogMode::exp, suggested_visibility(scene)));
    const std::string measured = fmt::format("{}: largest {:6.3f}, mean {:6.3f}, {} excluded", scene.name,
                                             error.largest, error.mean, error.excluded);
    fmt::print("{}\n", measured);
    EXPECT_LE(error.largest, 12) << measured;
    EXPECT_LE(error.mean, mean) << measured;
    EXPECT_LE(error.excluded, 27u) << measured;
  }
}

// A small angle to each pixel, as in large pictures: airlight is then drawn at few of them first.
TEST_F(ReferencePictureTest, AirlightOfADistantViewIsThatOfTheReference) {
  for (const char* name : {"headlights", "lighthouse", "room", "street"}) {
    Scene scene = read_scene(bundled_scene_path(name));
    scene.camera.field_of_view = glm::radians(8.0f);
    Renderer renderer(scene, 80, 45, by_airlight());
    for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
      const PictureError error = error_in(renderer, Fog::from_visibility(mode, scene.visibilities.at(1)));
      fmt::print("{:<12} {:<4} largest {:6.3f}, {} excluded\n", name, name_of(mode), error.largest, error.excluded);
      EXPECT_LE(error.largest, kAirlightBound) << name << ", " << name_of(mode);
      EXPECT_LE(error.excluded, 45u) << name << ", " << name_of(mode);
    }
  }
}

/// Draws a scene by airlight, which may err by a bound, with no pixel excluded.
void expect_airlight_within(double bound, const Scene& scene, glm::ivec2 size, const Fog& fog) {
  Renderer renderer(scene, size.x, size.y, by_airlight());
  const PictureError error = error_in(renderer, fog);
  fmt::print("largest {:6.3f}, {} excluded\n", error.largest, error.excluded);
  EXPECT_LE(error.largest, bound);
  EXPECT_EQ(error.excluded, 0u);
}

// A beam's edge beside the second texel of the coarse grids: of the texels within the picture, three lie on a straight
// line by chance.
TEST_F(ReferencePictureTest, AirlightAtThePicturesEdgeIsThatOfTheReference) {
  const Scene scene = read_scene(bundled_scene_path("tessellation"));
  expect_airlight_within(0.5, scene, {48, 27}, Fog::from_visibility(FogMode::exp, 100));  // 1.001 by one bend alone
}

// Across the apex of a wide beam its airlight jumps from full to none.
TEST_F(ReferencePictureTest, AirlightAroundABeamsApexIsThatOfTheReference) {
  const Scene scene = read_scene(bundled_scene_path("tessellation"));
  // 1.15 and 1.09 where coarse grids keep some at the apex.
  expect_airlight_within(kAirlightBound, scene, {96, 54}, Fog::from_visibility(FogMode::exp, 100));
  expect_airlight_within(kAirlightBound, scene, {96, 54}, Fog::from_visibility(FogMode::exp2, 20));
}

// In a long lens a surface's edge lies nearer than all that the coarse grids see around it, with a beam in between.
TEST_F(ReferencePictureTest, AirlightBeforeAnEdgeInDenseFogIsThatOfTheReference) {
  Scene scene = read_scene(bundled_scene_path("tessellation"));
  scene.camera.target = {3.158, 5.719, 0};
  scene.camera.field_of_view *= 0.1f;
  // 1.82 where their gain of airlight is taken to hold there.
  expect_airlight_within(0.5, scene, {48, 27}, Fog::from_visibility(FogMode::exp2, 20));
}

// Hundreds of lamps that are seen from afar: what they add beyond their extents changes within few pixels.
TEST_F(ReferencePictureTest, AirlightOfADistantAirportIsThatOfTheReference) {
  Scene scene = read_scene(bundled_scene_path("approach"));
  scene.camera.field_of_view *= 0.5f;
  expect_airlight_within(kAirlightBound, scene, {24, 14}, Fog::from_visibility(FogMode::exp, 5000.0));
}

/// The bounds by airlight of paths that do not light each fragment by the formula. Those by light maps have their bound
/// by `peak`: the airlight errs by as little. Those of `tangent`, which interpolates vectors between vertices, are
/// measured, with 5 % of margin.
struct AirlightSceneBound {
  std::string_view scene;
  PathBound tangent;
};
constexpr AirlightSceneBound kAirlightSceneBounds[] = {{"room", {3.26, 0.0192}}, {"headlights", {72.5, 0.498}}};

TEST_F(ReferencePictureTest, PathsByLightMapsAndInTangentSpaceAreWithinTheirBoundsByAirlight) {
  for (const auto& [name, tangent] : kAirlightSceneBounds) {
    const Scene scene = read_scene(bundled_scene_path(std::string(name)));
    int compared = 0;
    for (const LightingPath& path : lighting_paths()) {
      if (!path.takes_airlight || path.evaluation == Evaluation::fragment) continue;
      ++compared;
      const double bound = path.name == "tangent" ? tangent.beyond_maps : kLookupBound.beyond_maps;
      Renderer renderer(scene, 80, 45, by_airlight(path));
      for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
        const PictureError error = error_in(renderer, Fog::from_visibility(mode, scene.visibilities.at(1)));
        const std::string measured =
            fmt::format("{:<12} {:<12} {:<4} largest {:6.3f}, beyond maps {:6.3f}, mean {:.4f} of 1/255, {} excluded",
                        name, path.name, name_of(mode), error.largest, error.beyond_maps, error.mean, error.excluded);
        fmt::print("{}\n", measured);
        EXPECT_LE(error.beyond_maps, bound) << measured;
        if (path.name == "tangent") {
          EXPECT_LE(error.mean, tangent.mean) << measured;
        }
        EXPECT_LE(error.excluded, std::size_t{80 * 45 / 200}) << measured;
      }
    }
    EXPECT_EQ(compared, 6);
  }
}

// Lamps that never end, that end at the lamp, that are as bright as the clamp allows, and beams of half a degree to
// more than half a sphere.
TEST_F(ReferencePictureTest, OddLampsAreWithinTheBoundsOfTheirPaths) {
  Scene scene = flat_floor();
  const std::pair<Attenuation, Cone> lamps[] = {{{3, 0, 0}, Cone::smoothstep(0.2 * kDegree, 0.5 * kDegree)},
                                                {{25, 0.1, 0.01}, Cone{}},
                                                {{0, 0, 0.3}, Cone::cosine(89 * kDegree, 3)},
                                                {{0, 1, 0}, Cone::cosine(0.5 * kDegree, 0)},
                                                {{0.02, 0, 0.02}, Cone::smoothstep(100 * kDegree, 120 * kDegree)}};
  for (const auto& [attenuation, cone] : lamps) {
    const auto count = double(scene.lights.size());
    scene.lights.push_back(
        {.light = {.name = "lamp", .color = {0.3, 0.2, 0.1}, .attenuation = attenuation, .cone = cone},
         .position = {1.5 * count - 3, 2, 1},
         .direction = glm::normalize(glm::dvec3(0.1, -1, 0.2)),
         .carried = true});
  }
  for (const LightingPath& path : lighting_paths()) {
    if (path.evaluation == Evaluation::vertex) continue;
    Renderer renderer(scene, kWidth, kHeight, {.skipping = Skipping::off, .path = &path});
    const PictureError error = error_in(renderer, Fog::from_visibility(FogMode::exp, 60.0));
    EXPECT_LE(error.beyond_maps, kLookupBound.beyond_maps) << path.name;
    EXPECT_LE(error.excluded, std::size_t{kWidth * kHeight / 400}) << path.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ReferenceOfScene, testing::ValuesIn(bundled_scenes()),
                         [](const auto& tested) { return tested.param; });

// A cylinder in more and more triangles, each twice as fine: linear interpolation errs by the square of their size. Of
// order 2 it falls short by the half floats' own error, some 0.03, and in `vertex` by the highlight, which is narrower
// than the coarsest triangles.
TEST_F(ReferencePictureTest, PathsThatLightVerticesConvergeInTheSecondOrder) {
  for (const LightingPath& path : lighting_paths()) {
    if (path.evaluation != Evaluation::vertex) continue;
    std::vector<double> means;
    for (const double cells : {8.0, 16.0, 32.0}) {
      Scene scene;
      scene.camera = {.position = {0, 1, 2}, .target = {0, 1, 0}, .field_of_view = 0.6f};
      scene.environment.ambient_light = glm::vec3(0.05f);
      scene.models.push_back(make_model("drum", {{"segments", 2 * cells}, {"rings", cells}}));
      add_materials(scene);
      scene.instances.push_back({0, glm::mat4(1)});
      PlacedLight lamp;
      lamp.light.attenuation = {1, 0.2, 0.5};
      lamp.light.color = glm::dvec3(1.5);
      lamp.position = {0.4, 1.3, 2};
      scene.lights.push_back(lamp);
      Renderer renderer(scene, kWidth, kHeight, {.path = &path});
      renderer.draw(LightPoints::off);
      means.push_back(picture_error(renderer.read(), shade_reference(renderer)).mean);
    }
    const double order = std::log2(means[0] / means[2]) / 2;
    fmt::print("{:<8} mean error at 8, 16 and 32 cells: {:.4f} {:.4f} {:.4f} of 1/255, order {:.2f}\n", path.name,
               means[0], means[1], means[2], order);
    EXPECT_GT(order, 1.6) << path.name;
  }
}

/// A floor in fog under one lamp, which does not light it but for the fog.
Scene floor_and_lamp(const PlacedLight& lamp) {
  Scene scene = flat_floor();
  scene.lights.push_back(lamp);
  return scene;
}

PlacedLight bright_lamp() {
  PlacedLight lamp;
  lamp.light.color = {2, 1.5, 1};
  lamp.light.attenuation = {1, 0.1, 0.05};
  lamp.position = {-1, 3, 0};
  lamp.direction = glm::normalize(glm::dvec3(0.1, -1, 0.2));
  return lamp;
}

/// In fogs from clear air to a visibility in metres, 0 being total fog.
void expect_airlight_of_reference(const Scene& scene, const std::string& words, double densest = 0) {
  Renderer renderer(scene, 64, 36, by_airlight());
  for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
    for (const double visibility : {densest, 0.01, 1.0, 30.0, 20'000.0}) {
      const PictureError error = error_in(renderer, Fog::from_visibility(mode, visibility));
      EXPECT_LE(error.largest, kAirlightBound) << words << ", " << name_of(mode) << ", " << visibility << " m";
      EXPECT_LE(error.excluded, 64u) << words << ", " << name_of(mode) << ", " << visibility << " m";
    }
  }
}

TEST_F(ReferencePictureTest, AirlightOfALampAtTheEyeToTheLastBitIsThatOfTheReference) {
  PlacedLight lamp = bright_lamp();
  const glm::vec3 eye = flat_floor().camera.position;
  for (const Cone& cone : {Cone{}, Cone::smoothstep(0.2, 0.4)}) {
    lamp.light.cone = cone;
    lamp.direction = glm::normalize(glm::dvec3(-0.05, -0.6, -0.8));
    lamp.position = eye;
    expect_airlight_of_reference(floor_and_lamp(lamp), "at the eye");
    // Total fog hides a lamp at any distance from the eye, and a float's fog ends at a visibility of micrometres.
    lamp.position = glm::vec3(std::nextafter(eye.x, 1.0f), eye.y, std::nextafter(eye.z, 0.0f));
    expect_airlight_of_reference(floor_and_lamp(lamp), "beside the eye", 0.001);
  }
}

TEST_F(ReferencePictureTest, AirlightOfForwardAndBackwardScatteringFogIsThatOfTheReference) {
  for (const double asymmetry : {-0.8, 0.8}) {
    Scene scene = floor_and_lamp(bright_lamp());
    scene.atmosphere.phase = Phase::henyey_greenstein(asymmetry);
    expect_airlight_of_reference(scene, fmt::format("g = {}", asymmetry));
  }
}

// The samples of a pixel share an airlight only where they see almost the same of it. Headlights of cars that come
// towards the eye are brighter by the phase function where g > 0, those of others where g < 0.
TEST_F(ReferencePictureTest, AirlightOfDirectionalFogAtEdgesIsThatOfTheReference) {
  for (const double g : {0.8, -0.8}) {
    Scene scene = read_scene(bundled_scene_path("street"));
    scene.atmosphere.phase = Phase::henyey_greenstein(g);
    SCOPED_TRACE(g);
    expect_airlight_within(kAirlightBound, scene, {48, 27}, Fog::from_visibility(FogMode::exp2, 1500));
  }
}

TEST_F(ReferencePictureTest, AirlightOfALampWithoutAnEndIsThatOfTheReference) {
  PlacedLight lamp = bright_lamp();
  lamp.light.attenuation = {2, 0, 0};
  ASSERT_TRUE(std::isinf(compute_extent(lamp.light.attenuation, lamp.light.threshold)));
  for (const Cone& cone : {Cone{}, Cone::smoothstep(0.1, 0.2)}) {
    lamp.light.cone = cone;
    expect_airlight_of_reference(floor_and_lamp(lamp), "constant attenuation");
  }
}

// Beyond its extent each lamp adds less than a step, all together add many.
TEST_F(ReferencePictureTest, AirlightOfManyLampsBeyondTheirExtentsIsThatOfTheReference) {
  Scene scene = flat_floor();
  scene.camera = {.position = {0, 12, 700}, .target = {0, 10, 0}, .field_of_view = 0.6f};
  scene.instances.clear();
  for (int i = 0; i < 40; ++i) {
    PlacedLight lamp;
    lamp.light.attenuation = {1, 0, 0.002};
    lamp.light.cone = i % 2 == 0 ? Cone::smoothstep(0.14, 0.2) : Cone{};
    lamp.position = {(i % 4) * 20 - 30, 2, -30 * (i / 4)};
    lamp.direction = glm::normalize(glm::dvec3(0, 0.1, 1));
    scene.lights.push_back(lamp);
  }
  for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
    const Fog fog = Fog::from_visibility(mode, 1500);
    Renderer renderer(scene, 24, 14, {.fog_lighting = FogLighting::airlight, .samples = 1});
    const PictureError error = error_in(renderer, fog);
    double cut_off = 0;  // along a ray over the lamps
    double whole = 0;
    const EyeRay ray{.origin = scene.camera.position, .direction = glm::normalize(glm::dvec3(0, 0.15, -1))};
    const measure::PathModel model(renderer);
    for (const ReferenceLight& light : model.lights()) {
      whole += light.airlight({fog}, ray);
      cut_off += reference_airlight(light.placed, {fog}, ray);
    }
    const double steps = 255 * (srgb_from_linear(whole) - srgb_from_linear(cut_off));
    fmt::print("{}: largest error {:.3f} steps; extents would cut off {:.1f}\n", name_of(mode), error.largest, steps);
    EXPECT_LE(error.largest, kAirlightBound) << name_of(mode);
    EXPECT_GT(steps, 4) << name_of(mode);
  }
}

// What is faint takes few nodes of the integral, but not where the exposure shows it bright.
TEST_F(ReferencePictureTest, AirlightOfFaintLampsIsThatOfTheReferenceAtAHighExposure) {
  constexpr double kExposure = 8;
  const Scene scene = read_scene(bundled_scene_path("headlights"));
  Renderer renderer(scene, 32, 18, {.fog_lighting = FogLighting::airlight, .samples = 1});
  renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp, 2000)));
  renderer.set_exposure({.ev = kExposure});
  renderer.draw(LightPoints::off);
  const PictureError error = picture_error(renderer.read(), shade_reference(renderer), kExposure);
  EXPECT_LE(error.largest, kAirlightBound);
  EXPECT_LE(error.mean, 0.15);
}

// From the side, at a small size: coarse grids of the airlight see next to nothing of the beam.
TEST_F(ReferencePictureTest, AirlightOfABeamThinnerThanAPixelIsThatOfTheReference) {
  Scene scene = flat_floor();
  scene.instances.clear();
  scene.camera = {.position = {0, 1.5f, 0}, .target = {0, 1.3f, -10}, .field_of_view = 1.1f};
  PlacedLight lamp;
  lamp.light.color = glm::dvec3(1300);
  lamp.light.attenuation = {0, 0, 1};
  lamp.light.cone = Cone::smoothstep(0.02, 0.05);
  lamp.position = {-12, 9, -25};
  for (const double down : {0.6, 0.7, 0.8, 0.9}) {
    lamp.direction = glm::normalize(glm::dvec3(0.8, -down, 0.1));
    scene.lights.assign(1, lamp);
    Renderer renderer(scene, 96, 54, by_airlight());
    for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
      const PictureError error = error_in(renderer, Fog::from_visibility(mode, 50));
      fmt::print("{}: largest error {:.3f} steps\n", name_of(mode), error.largest);
      EXPECT_LE(error.largest, kAirlightBound) << name_of(mode) << ", " << down;
    }
  }
}

TEST_F(ReferencePictureTest, AirlightOfACookieIsThatOfTheReference) {
  Scene scene = floor_and_lamp(bright_lamp());
  scene.cookies.push_back(make_cookie(16, [](const glm::dvec3& direction) {
    const double cosine = std::max(-direction.z / glm::length(direction), 0.0);
    return cosine * cosine;
  }));
  scene.cookie_uses[0] = {.cookie = 0, .roll = 0.3};
  expect_airlight_of_reference(scene, "cookie");
}

}  // namespace

}  // namespace litfog::test
