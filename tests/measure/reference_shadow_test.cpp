// SPDX-License-Identifier: Apache-2.0
#include "measure/reference_shadow.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "core/value_errors.h"
#include "gl/gl_test.h"
#include "litfog/gl/unsupported.h"
#include "measure/picture_error.h"
#include "measure/reference_picture.h"
#include "render/pixel.h"
#include "scene/file/scene_file.h"
#include "scene/model/primitive.h"

namespace litfog::test {
using namespace render;
using namespace scene;
using namespace measure;

namespace {

class ReferenceShadow : public test::GlTest {};

Material plain(const std::string& name, float reflectance) {
  return {.name = name,
          .size_m = 1,
          .albedo = std::make_shared<const Texels>(Texels{1, 1, {255, 255, 255, 255}}),
          .normal = std::make_shared<const Texels>(Texels{1, 1, {128, 128, 255, 0}}),
          .specular = glm::vec3(0),
          .shininess = 1,
          .emissive = glm::vec3(0),
          .plain_albedo = glm::vec3(reflectance)};
}

/// A floor at height 0, some 80 m square.
Model floor_of(const std::string& material) {
  Mesh mesh;
  for (const glm::vec2 corner : {glm::vec2(-40, 40), glm::vec2(40, 40), glm::vec2(40, -40), glm::vec2(-40, -40)}) {
    mesh.vertices.push_back({{corner.x, 0, corner.y}, {0, 1, 0}, {1, 0, 0, 1}, corner});
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return {Part{material, mesh}};
}

PlacedLight lamp_at(const glm::dvec3& position, const glm::dvec3& target, const Cone& cone) {
  PlacedLight lamp;
  lamp.light = {.name = "lamp", .color = {2.0, 1.8, 1.5}, .attenuation = {1, 0, 0.01}, .cone = cone};
  lamp.position = position;
  lamp.direction = glm::normalize(target - position);
  return lamp;
}

/// A floor, and a box of 1 m that hangs over its middle between heights 2 and 3.
Scene box_over_floor(const PlacedLight& lamp) {
  Scene scene;
  scene.camera = {.position = {3, 6, 9}, .target = {0, 0, 0}, .field_of_view = 0.8f};
  scene.materials = {plain("plain", 0.7f)};
  scene.models = {floor_of("plain"), {Part{"plain", make_box({1, 1, 1})}}};
  scene.instances = {{0, glm::mat4(1)}, {1, glm::translate(glm::mat4(1), glm::vec3(0, 2, 0))}};
  scene.lights = {lamp};
  return scene;
}

// From a lamp at height 6 the top of the box, at 3, throws an edge twice as far from the lamp's foot.
TEST_F(ReferenceShadow, ShadowOfABoxEndsWhereItDoesInClosedForm) {
  const Scene scene = box_over_floor(lamp_at({0.2, 6, -0.1}, {0, 0, 0}, {}));
  ASSERT_NEAR(bounds(scene.models[1]).high.y, 1, 1e-6);  // on its origin
  Renderer renderer(scene, 32, 18, {.shadows = Shadows::surfaces});
  const ReferenceShadows shadows(renderer);
  const ReferenceLight light = reference_lights(scene, {}, RenderSettings{}).at(0);
  const auto edge = [](double box, double lamp) { return lamp + 2 * (box - lamp); };
  for (const double gap : {-1e-5, 1e-5}) {
    for (const double across : {-0.3, 0.0, 0.4}) {
      EXPECT_EQ(shadows.is_dark(light, {edge(0.5, 0.2) + gap, 0, across}), gap < 0);
      EXPECT_EQ(shadows.is_dark(light, {edge(-0.5, 0.2) - gap, 0, across}), gap < 0);
      EXPECT_EQ(shadows.is_dark(light, {across, 0, edge(0.5, -0.1) + gap}), gap < 0);
      EXPECT_EQ(shadows.is_dark(light, {across, 0, edge(-0.5, -0.1) - gap}), gap < 0);
    }
  }
  EXPECT_FALSE(shadows.is_dark(light, {0.2, 3, -0.1}));
  EXPECT_TRUE(shadows.is_dark(light, {0.2, 1.9, -0.1}));
  // A texel is 2/1024 of the distance.
  EXPECT_TRUE(shadows.is_at_edge(light, {edge(0.5, 0.2) + 0.02, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(shadows.is_at_edge(light, {edge(0.5, 0.2) + 0.05, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(shadows.is_at_edge(light, {edge(0.5, 0.2) - 0.05, 0, 0}, {0, 1, 0}));
}

TEST_F(ReferenceShadow, LitStretchesOfARayEndAtTheShadowInClosedForm) {
  const Scene scene = box_over_floor(lamp_at({0, 6, 0}, {0, 0, 0}, {}));
  Renderer renderer(scene, 32, 18, {.shadows = Shadows::shafts});
  const ReferenceShadows shadows(renderer);
  const RenderSettings by_airlight{.fog_lighting = FogLighting::airlight};
  const ReferenceLight light = reference_lights(scene, {}, by_airlight).at(0);
  // At height 1 the shadow is 5/3 m wide.
  const auto stretches = shadows.lit_stretches(light, {.origin = {-4, 1, 0}, .direction = {1, 0, 0}, .length = 9});
  ASSERT_EQ(stretches.size(), 2u);
  EXPECT_EQ(stretches[0].first, 0);
  EXPECT_NEAR(stretches[0].second, 4 - 5 / 6., 1e-4);
  EXPECT_NEAR(stretches[1].first, 4 + 5 / 6., 1e-4);
  EXPECT_NEAR(stretches[1].second, 9, 1e-9);
  EXPECT_TRUE(shadows.lit_stretches(light, {.origin = {0, 1.9, 0}, .direction = {0, -1, 0}, .length = 1.9}).empty());
}

/// The same floor and box under a moon that stands at 45 degrees to the east, without lamps.
Scene moonlit_box_over_floor() {
  Scene scene = box_over_floor({});
  scene.lights.clear();
  scene.environment.moon_direction = glm::normalize(glm::vec3(1, 1, 0));
  scene.environment.moon_color = {1.0f, 0.9f, 0.8f};
  return scene;
}

// At 45 degrees a shadow is as far to the west as what casts it is high.
TEST_F(ReferenceShadow, MoonShadowOfABoxEndsWhereItDoesInClosedForm) {
  const Scene scene = moonlit_box_over_floor();
  Renderer renderer(scene, 32, 18, {.shadows = Shadows::surfaces});
  const ReferenceShadows shadows(renderer);
  for (const double gap : {-1e-4, 1e-4}) {
    for (const double across : {-0.49, 0.0, 0.3}) {
      EXPECT_EQ(shadows.is_dark_to_moon({-1.5 + gap, 0, across}), gap < 0);
      EXPECT_EQ(shadows.is_dark_to_moon({-3.5 - gap, 0, across}), gap < 0);
    }
    EXPECT_EQ(shadows.is_dark_to_moon({-2.5, 0, 0.5 + gap}), gap < 0);
  }
  EXPECT_TRUE(shadows.is_dark_to_moon({0, 2, 0}));
  EXPECT_FALSE(shadows.is_dark_to_moon({0, 3, 0}));
  const double texel = 2 * renderer.shadows()->moon_maps()[2].half_size / 1024;  // the finest that shows it
  EXPECT_TRUE(shadows.is_at_moon_edge({-1.5 + texel, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(shadows.is_at_moon_edge({-1.5 + 5 * texel, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(shadows.is_at_moon_edge({-1.5 - 5 * texel, 0, 0}, {0, 1, 0}));
}

Picture draw(const Scene& scene, const RenderSettings& settings) {
  Renderer renderer(scene, 160, 90, settings);
  renderer.draw(LightPoints::off);
  return renderer.read();
}

// Nothing is between a lamp and a bare floor: a bias too small for any of its texels would show as dots.
TEST_F(ReferenceShadow, FlatSurfaceDoesNotShadeItself) {
  for (const double height : {8.0, 1.0, 0.2}) {
    for (const Cone& cone : {Cone{}, Cone::smoothstep(0.2, 0.4), Cone::cosine(1.0, 1)}) {
      for (const glm::vec3 origin : {glm::vec3(0), glm::vec3(2000, 300, -5000)}) {
        Scene scene = box_over_floor(lamp_at({0.3, height, 7}, {0, 0, -3}, cone));
        scene.instances.pop_back();
        scene.instances[0].world_from_model = glm::rotate(glm::translate(glm::mat4(1), origin), 0.3f, {1, 0.5f, 0.2f});
        const glm::mat4& world = scene.instances[0].world_from_model;
        scene.lights[0].position = glm::dvec3(world * glm::vec4(scene.lights[0].position, 1));
        scene.lights[0].direction = glm::normalize(glm::dmat3(world) * scene.lights[0].direction);
        scene.camera.position = world * glm::vec4(scene.camera.position, 1);
        scene.camera.target = world * glm::vec4(scene.camera.target, 1);
        const Picture without = draw(scene, {});
        for (const int size : {64, 257, 1024}) {
          const Picture with = draw(scene, {.shadows = Shadows::surfaces, .shadow_map_size = size});
          EXPECT_EQ(largest_difference(with, without), 0) << height << ", " << origin.x << ", " << size;
        }
      }
    }
  }
}

TEST_F(ReferenceShadow, FlatSurfaceDoesNotShadeItselfInMoonlight) {
  for (const glm::vec3 moon : {glm::vec3(0, 1, 0), glm::vec3(1, 0.5f, 0.3f), glm::vec3(-0.4f, 0.02f, 1)}) {
    for (const glm::vec3 origin : {glm::vec3(0), glm::vec3(2000, 300, -5000)}) {
      // So far from the origin floats do not tell a pixel's slope to the hundredth of a radian.
      if (origin.x > 0 && moon.y < 0.1f) continue;
      Scene scene = moonlit_box_over_floor();
      scene.camera.field_of_view = 0.5f;  // without the floor's end, where positions are clamped to the floor's box
      scene.instances.pop_back();
      scene.instances[0].world_from_model = glm::rotate(glm::translate(glm::mat4(1), origin), 0.3f, {1, 0.5f, 0.2f});
      const glm::mat4& world = scene.instances[0].world_from_model;
      scene.environment.moon_direction = glm::normalize(glm::mat3(world) * moon);
      scene.camera.position = world * glm::vec4(scene.camera.position, 1);
      scene.camera.target = world * glm::vec4(scene.camera.target, 1);
      const Picture without = draw(scene, {});
      for (const int size : {64, 257, 1024}) {
        const Picture with = draw(scene, {.shadows = Shadows::surfaces, .shadow_map_size = size});
        EXPECT_EQ(largest_difference(with, without), 0) << moon.y << ", " << origin.x << ", " << size;
      }
    }
  }
}

TEST_F(ReferenceShadow, MoonMapsFollowTheCameraAndLampsMapsStay) {
  Scene scene = moonlit_box_over_floor();
  scene.lights = {lamp_at({0.2, 6, -0.1}, {0, 0, 0}, {})};
  Renderer renderer(scene, 160, 90, {.shadows = Shadows::surfaces});
  EXPECT_EQ(renderer.draw().shadow_maps_drawn, std::size_t(6 + kMoonMaps));
  EXPECT_EQ(renderer.draw().shadow_maps_drawn, 0u);
  scene.camera.position = {-3, 5, 8};
  EXPECT_EQ(renderer.draw().shadow_maps_drawn, std::size_t(kMoonMaps));
  EXPECT_EQ(largest_difference(renderer.read(), draw(scene, {.shadows = Shadows::surfaces})), 0);
}

/// How far pictures with shadows may be from rays, beside the pixels at edges. A surface narrower than the rays around
/// a place are apart, or than a texel, is missed by one of the two: a few pixels.
struct ShadowBound {
  const char* scene;
  const char* path;
  double excluded;  ///< fraction of all pixels
  double missed;    ///< fraction of all pixels with an error above a step
};

void expect_shadows_of_rays(const Scene& scene, const RenderSettings& settings, const ShadowBound& bound, int width,
                            int height) {
  Renderer renderer(scene, width, height, settings);
  renderer.draw(LightPoints::off);
  const PictureError error = picture_error(renderer.read(), shade_reference(renderer));
  const auto missed = std::ranges::count_if(error.pixels, [](float steps) { return steps > 1; });
  const std::string measured =
      fmt::format("{} {}: {:.3f} excluded, {} missed, largest {:.1f}, mean {:.4f}", bound.scene, bound.path,
                  double(error.excluded) / (width * height), missed, error.largest, error.mean);
  fmt::print("{}\n", measured);
  EXPECT_LE(double(error.excluded), bound.excluded * width * height) << measured;
  EXPECT_LE(double(missed), bound.missed * width * height) << measured;
  EXPECT_LE(error.mean, 0.05) << measured;
}

/// A bundled scene in moonlight as bright as day, without lamps.
Scene moonlit(const char* name) {
  Scene scene = read_scene(bundled_scene_path(name));
  scene.lights.clear();
  scene.environment.moon_direction = glm::normalize(glm::vec3(-0.5f, 0.45f, -0.3f));
  scene.environment.moon_color = {1.2f, 1.1f, 1.0f};
  return scene;
}

TEST_F(ReferenceShadow, MoonShadowsAreThoseOfRays) {
  constexpr int kWidth = 96;
  constexpr int kHeight = 54;
  constexpr ShadowBound kBounds[] = {{"headlights", "unified", 0.21, 0.003}, {"headlights", "lookup-3d", 0.21, 0.003}};
  for (const ShadowBound& bound : kBounds) {
    const Scene scene = moonlit(bound.scene);
    const RenderSettings settings{
        .path = find_lighting_path(bound.path), .shadows = Shadows::surfaces, .shadow_map_size = 2048};
    expect_shadows_of_rays(scene, settings, bound, kWidth, kHeight);
  }
}

TEST_F(ReferenceShadow, ShadowsOfScenesAreThoseOfRays) {
  constexpr int kWidth = 96;
  constexpr int kHeight = 54;
  constexpr ShadowBound kBounds[] = {{"room", "unified", 0.2, 0.0016},      {"room", "lookup-2d", 0.19, 0.0016},
                                     {"room", "tangent", 0.2, 0.002},       {"room", "radial", 0.23, 0.003},
                                     {"room", "radial-plane", 0.23, 0.003}, {"headlights", "unified", 0.09, 0.0004},
                                     {"street", "unified", 0.19, 0.0016}};
  for (const ShadowBound& bound : kBounds) {
    Scene scene = read_scene(bundled_scene_path(bound.scene));
    scene.environment.moon_color = glm::vec3(0);  // its shadows have their own test
    const RenderSettings settings{
        .path = find_lighting_path(bound.path), .shadows = Shadows::surfaces, .shadow_map_size = 2048};
    expect_shadows_of_rays(scene, settings, bound, kWidth, kHeight);
  }
}

/// Black posts and a board between the eye and a lamp in fog: all that is seen is airlight.
Scene posts_in_fog() {
  Scene scene;
  scene.camera = {.position = {-2, 1.6f, 12}, .target = {0.5f, 1.8f, 0}, .field_of_view = 0.9f};
  scene.materials = {plain("black", 0)};
  scene.models = {
      floor_of("black"), {Part{"black", make_box({0.4f, 3, 0.4f})}}, {Part{"black", make_box({2, 0.1f, 1})}}};
  scene.instances = {{0, glm::mat4(1)}, {2, glm::translate(glm::mat4(1), glm::vec3(0.5f, 3, -1))}};
  for (int i = -2; i <= 2; ++i)
    scene.instances.push_back({1, glm::translate(glm::mat4(1), glm::vec3(1.5f * float(i), 0, 1))});
  scene.lights = {lamp_at({0.3, 2.2, -2}, {0.3, 2, 5}, Cone::smoothstep(0.3, 0.9)),
                  lamp_at({0.5, 4.5, -1}, {0, 0, 0}, {})};
  scene.atmosphere.top = 30;
  return scene;
}

// The error falls with the steps to what the texels of the maps leave.
TEST_F(ReferenceShadow, ShaftsComeNearToRaysAsStepsGrow) {
  Scene scene = posts_in_fog();
  scene.atmosphere.phase = {};
  const Fog fog = Fog::from_visibility(FogMode::exp, 40.0);
  struct StepBound {
    int steps;
    double largest;  // 1/255
    double mean;
  };
  constexpr StepBound kBounds[] = {{8, 13, 1.3}, {16, 10, 0.65}, {32, 6, 0.2}, {64, 2.2, 0.12}, {128, 1.2, 0.1}};
  constexpr int kWidth = 64;
  constexpr int kHeight = 36;
  std::optional<ReferencePicture> reference;
  for (const StepBound& bound : kBounds) {
    Renderer renderer(
        scene, kWidth, kHeight,
        {.fog_lighting = FogLighting::airlight, .samples = 1, .shadows = Shadows::shafts, .shaft_steps = bound.steps});
    renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
    renderer.draw(LightPoints::off);
    if (!reference) reference = shade_reference(renderer);
    const PictureError error = picture_error(renderer.read(), *reference);
    const std::string measured = fmt::format("{} steps: largest {:.2f}, mean {:.3f} of 1/255, {} excluded", bound.steps,
                                             error.largest, error.mean, error.excluded);
    fmt::print("{}\n", measured);
    EXPECT_LE(error.largest, bound.largest) << measured;
    EXPECT_LE(error.mean, bound.mean) << measured;
    EXPECT_EQ(error.excluded, 0u) << measured;
  }
  Renderer renderer(scene, kWidth, kHeight, {.fog_lighting = FogLighting::airlight, .samples = 1});
  renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
  renderer.draw(LightPoints::off);
  const PictureError without = picture_error(renderer.read(), *reference);
  fmt::print("without shafts: largest {:.2f}, mean {:.3f}\n", without.largest, without.mean);
  EXPECT_GT(without.mean, 5);
}

// What stands beside the road cuts finer shafts than the steps and the texels of the maps tell.
TEST_F(ReferenceShadow, ShaftsOfHeadlightsAreWithinTwoAndAHalfStepsOfRays) {
  Scene scene = read_scene(bundled_scene_path("headlights"));
  const CameraAxes axes = axes_of(scene.camera);
  scene.camera.target =
      glm::vec3(glm::dvec3(scene.camera.position) + axes.forward - 0.244 * axes.right + 0.134 * axes.up);
  scene.camera.field_of_view = 0.2195f;
  Renderer renderer(scene, 24, 14, {.fog_lighting = FogLighting::airlight, .shadows = Shadows::shafts});
  renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp, 400.0)));
  renderer.draw(LightPoints::off);
  const PictureError error = picture_error(renderer.read(), shade_reference(renderer));
  fmt::print("largest {:.2f}, mean {:.4f}, {} excluded\n", error.largest, error.mean, error.excluded);
  EXPECT_LE(error.largest, 2.5);
  EXPECT_LE(error.mean, 0.1);
  EXPECT_LE(error.excluded, std::size_t{24 * 14 / 2});
}

TEST_F(ReferenceShadow, MapsAreDrawnOnceForAllFrames) {
  const Scene scene = box_over_floor(lamp_at({0, 6, 0}, {0, 0, 0}, {}));
  Renderer renderer(scene, 32, 18, {.shadows = Shadows::surfaces});
  EXPECT_EQ(renderer.draw().shadow_maps_drawn, 6u);
  const Picture first = renderer.read();
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_EQ(renderer.draw().shadow_maps_drawn, 0u);
    EXPECT_EQ(largest_difference(renderer.read(), first), 0);
  }
}

TEST_F(ReferenceShadow, MoreMapsThanMemoryAreUnsupported) {
  Scene scene = box_over_floor(lamp_at({0, 6, 0}, {0, 0, 0}, {}));
  while (scene.lights.size() < 3) scene.lights.push_back(scene.lights.front());
  EXPECT_EQ(sentence_of<gl::Unsupported>(
                [&] { Renderer renderer(scene, 32, 18, {.shadows = Shadows::surfaces, .shadow_map_size = 4096}); }),
            "the shadows of 3 lamps need 18 maps of 4096 texels a side, 1.1 GiB; at most 1 GiB is taken for them, so "
            "fewer lamps have to cast shadows, or by smaller maps");
}

TEST_F(ReferenceShadow, SceneWithoutLampsOrSurfacesIsDrawnAsBefore) {
  Scene scene;
  scene.environment.sky_zenith = scene.environment.sky_horizon = {0.3f, 0.2f, 0.1f};
  const Picture without = draw(scene, {});
  EXPECT_EQ(largest_difference(draw(scene, {.shadows = Shadows::surfaces}), without), 0);
  scene.lights = {lamp_at({0, 6, 0}, {0, 0, 0}, {})};
  EXPECT_EQ(largest_difference(draw(scene, {.shadows = Shadows::surfaces}), draw(scene, {})), 0);
}

}  // namespace

}  // namespace litfog::test
