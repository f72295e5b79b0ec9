// SPDX-License-Identifier: Apache-2.0
// Materials with masks, opacity, emission maps, vertex colours and pictures of coordinates of their own, and unlit
// ones: drawn as their texels say, and by every path as the reference has them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <optional>

#include "gl/gl_test.h"
#include "measure/picture_error.h"
#include "measure/reference_picture.h"
#include "measure/reference_shadow.h"
#include "reference/random_light.h"
#include "render/pixel.h"

namespace litfog::test {
using namespace render;
using namespace scene;
using namespace measure;

namespace {

class ReferenceMaterial : public test::GlTest {};

constexpr int kSide = 8;  // texels
constexpr glm::vec3 kFogColor{0.2f, 0.25f, 0.3f};

/// Random texels, of which half are covered.
std::shared_ptr<const Texels> random_texels(std::uint32_t seed, const Sampling& sampling) {
  Random random(seed);
  Texels texels{kSide, kSide, {}, sampling};
  for (int i = 0; i < kSide * kSide; ++i) {
    for (int channel = 0; channel < 3; ++channel) texels.rgba.push_back(std::uint8_t(random.below(256)));
    texels.rgba.push_back(random.chance(0.5) ? 255 : 40);
  }
  return std::make_shared<const Texels>(std::move(texels));
}

double linear(std::uint8_t level) {  // IEC 61966-2-1
  const double x = level / 255.0;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

constexpr Sampling kNearest{.wrap_u = Sampling::Wrap::mirror,
                            .wrap_v = Sampling::Wrap::clamp,
                            .magnified = Sampling::Filter::nearest,
                            .minified = Sampling::Filter::nearest,
                            .mipmaps = Sampling::Mipmaps::none};

Material material(const Sampling& sampling) {
  return {.name = "panel",
          .size_m = 2,
          .albedo = random_texels(1, sampling),
          .normal = std::make_shared<const Texels>(Texels{1, 1, {128, 128, 255, 0}}),
          .specular = glm::vec3(0),
          .shininess = 1,
          .emissive = glm::vec3(0)};
}

/// A panel at z = 0 that is 4 m wide and high, its texture coordinates its metres, 6 m before the eye.
Scene panel(Material of) {
  Scene scene;
  scene.camera = {.position = {0.1f, 0.2f, 6}, .target = {0.1f, 0.2f, 0}, .field_of_view = 0.8f};
  scene.environment.ambient_light = glm::vec3(0.8f, 0.7f, 0.9f);
  scene.atmosphere.ambient_fog_color = kFogColor;
  Mesh mesh;
  for (const glm::vec2 corner : {glm::vec2(-2, -2), glm::vec2(2, -2), glm::vec2(2, 2), glm::vec2(-2, 2)}) {
    mesh.vertices.push_back({glm::vec3(corner, 0), {0, 0, 1}, {1, 0, 0, 1}, corner});
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  scene.models.push_back({Part{"panel", mesh}});
  scene.instances.push_back({0, glm::mat4(1)});
  scene.materials.push_back(std::move(of));
  return scene;
}

/// Colours from one side of the panel to the other, and pictures moved and turned on it.
void add_details(Scene& scene) {
  Mesh& mesh = scene.models[0][0].mesh;
  for (const Vertex& vertex : mesh.vertices) {
    const glm::vec2 uv = vertex.uv;
    mesh.details.push_back({.color = glm::vec4(0.5f + uv.x / 4, 0.5f - uv.y / 4, 0.7f, 0.75f + uv.y / 8),
                            .normal_uv = {uv.y, uv.x},
                            .emission_uv = {-uv.y + 0.3f, uv.x + 0.1f}});
  }
}

int wrapped(int i, Sampling::Wrap wrap) {
  if (wrap == Sampling::Wrap::clamp) return std::clamp(i, 0, kSide - 1);
  const int turned = (i % (2 * kSide) + 2 * kSide) % (2 * kSide);
  return turned < kSide ? turned : 2 * kSide - 1 - turned;
}

/// The nearest texel, or nothing where another is as near.
const std::uint8_t* texel_at(const Texels& texels, const glm::dvec2& metres) {
  const glm::dvec2 place = metres / 2.0 * double(kSide);
  const glm::dvec2 within = glm::fract(place);
  constexpr double kBorder = 0.02;
  if (glm::any(glm::lessThan(glm::min(within, 1.0 - within), glm::dvec2(kBorder)))) return nullptr;
  const int x = wrapped(int(std::floor(place.x)), texels.sampling.wrap_u);
  const int y = wrapped(int(std::floor(place.y)), texels.sampling.wrap_v);
  return &texels.rgba[std::size_t(4 * (y * kSide + x))];
}
glm::dvec3 color_of(const std::uint8_t* texel) { return {linear(texel[0]), linear(texel[1]), linear(texel[2])}; }

/// Whether each pixel of the panel has the colour that expected(metres) states, through the fog; nothing is a hole.
template <typename Expected>
void expect_colors(const Scene& scene, std::string_view path, const Expected& expected) {
  constexpr int kWidth = 64;
  constexpr int kHeight = 64;
  Renderer renderer(scene, kWidth, kHeight, {.path = find_lighting_path(path), .samples = 1});
  for (const double visibility : {std::numeric_limits<double>::infinity(), 15.0}) {
    const Fog fog = Fog::from_visibility(FogMode::exp, visibility);
    renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
    renderer.draw(LightPoints::off);
    const Picture picture = renderer.read();
    int compared = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const glm::dvec3 eye = scene.camera.position;
        const glm::dvec3 view = view_direction(scene.camera, kWidth, kHeight, x + 0.5, y + 0.5);
        const glm::dvec3 place = eye - view * (eye.z / view.z);
        if (glm::any(glm::greaterThan(glm::abs(glm::dvec2(place)), glm::dvec2(1.99)))) continue;
        bool is_known = true;
        const std::optional<glm::dvec3> color = expected(glm::dvec2(place), is_known);
        if (!is_known) continue;
        const double through = fog_factor_at(fog, glm::distance(place, eye));
        const glm::dvec3 sky = std::isinf(visibility) ? glm::dvec3(0) : glm::dvec3(kFogColor);
        const glm::dvec3 seen = color ? glm::mix(glm::dvec3(kFogColor), *color, through) : sky;
        // Relative rounding of half floats and of the driver's sRGB.
        ASSERT_LT(glm::distance(pixel(picture, x, y), seen), 3e-3 * (1 + glm::length(seen)))
            << path << " " << visibility << " " << x << " " << y;
        ++compared;
      }
    }
    EXPECT_GT(compared, 1000);
  }
}

constexpr const char* kPaths[] = {"unified", "lookup-3d", "radial-plane", "accumulate",
                                  "vertex",  "mixed",     "tangent",      "legacy"};

TEST_F(ReferenceMaterial, MaskLeavesTheCoveredTexels) {
  Scene scene = panel(material(kNearest));
  scene.materials[0].least_coverage = 0.5f;
  const Texels& texels = *scene.materials[0].albedo;
  for (const char* path : kPaths) {
    expect_colors(scene, path, [&](const glm::dvec2& place, bool& is_known) -> std::optional<glm::dvec3> {
      const std::uint8_t* const texel = texel_at(texels, place);
      is_known = texel != nullptr;
      if (!texel || texel[3] < 128) return std::nullopt;
      return color_of(texel) * glm::dvec3(scene.environment.ambient_light);
    });
  }
}

TEST_F(ReferenceMaterial, EmissionIsThatOfItsTexels) {
  Scene scene = panel(material(kNearest));
  scene.materials[0].emission = random_texels(2, kNearest);
  scene.materials[0].emissive = {1, 0.5f, 2};
  const Material& of = scene.materials[0];
  for (const char* path : kPaths) {
    expect_colors(scene, path, [&](const glm::dvec2& place, bool& is_known) -> std::optional<glm::dvec3> {
      const std::uint8_t* const albedo = texel_at(*of.albedo, place);
      is_known = albedo != nullptr;
      if (!albedo) return std::nullopt;
      return color_of(albedo) * glm::dvec3(scene.environment.ambient_light) +
             color_of(texel_at(*of.emission, place)) * glm::dvec3(of.emissive);
    });
  }
}

TEST_F(ReferenceMaterial, UnlitSurfaceHasTheColorOfItsTexels) {
  Scene scene = panel(material(kNearest));
  scene.materials[0].is_unlit = true;
  scene.materials[0].emissive = {1, 0.5f, 2};
  scene.materials[0].least_coverage = 0.5f;
  scene.environment.moon_color = glm::vec3(3);
  scene.environment.moon_direction = {0, 0, 1};
  const Material& of = scene.materials[0];
  for (const char* path : kPaths) {
    expect_colors(scene, path, [&](const glm::dvec2& place, bool& is_known) -> std::optional<glm::dvec3> {
      const std::uint8_t* const texel = texel_at(*of.albedo, place);
      is_known = texel != nullptr;
      if (!texel || texel[3] < 128) return std::nullopt;
      return color_of(texel) * glm::dvec3(of.emissive);
    });
  }
}

TEST_F(ReferenceMaterial, VerticesColorTheSurfaceAndMoveItsPictures) {
  Scene scene = panel(material(kNearest));
  scene.materials[0].least_coverage = 0.7f;
  scene.materials[0].emission = random_texels(3, kNearest);
  scene.materials[0].emissive = glm::vec3(1);
  add_details(scene);
  const Material& of = scene.materials[0];
  for (const char* path : kPaths) {
    expect_colors(scene, path, [&](const glm::dvec2& place, bool& is_known) -> std::optional<glm::dvec3> {
      const std::uint8_t* const albedo = texel_at(*of.albedo, place);
      const std::uint8_t* const emission = texel_at(*of.emission, {-place.y + 0.3, place.x + 0.1});
      const double coverage = 0.75 + place.y / 8;
      is_known = albedo && emission && std::abs(coverage - 0.7) > 1e-3;
      if (!is_known || albedo[3] / 255.0 * coverage < 0.7) return std::nullopt;
      const glm::dvec3 tint(0.5 + place.x / 4, 0.5 - place.y / 4, 0.7);
      return color_of(albedo) * tint * glm::dvec3(scene.environment.ambient_light) + color_of(emission);
    });
  }
}

// Light from behind goes through the pane and then on through the fog before it, which adds its own.
TEST_F(ReferenceMaterial, PaneLetsThroughWhatItsOpacityLeaves) {
  struct Panel {
    double z;
    glm::dvec3 color;
    double opacity;
  };
  // In the order of the file, which is not that of the eye.
  const Panel panels[] = {{1, {0.9, 0.2, 0.1}, 0.3}, {-3, {0.4, 0.7, 0.9}, 1}, {0, {0.1, 0.8, 0.3}, 0.75}};
  Scene scene = panel(material(kNearest));
  const Mesh mesh = scene.models[0][0].mesh;
  scene.models.clear();
  scene.instances.clear();
  scene.materials.clear();
  for (const Panel& each : panels) {
    Material& of = scene.materials.emplace_back(material(kNearest));
    of.name = fmt::format("panel at {}", each.z);
    of.plain_albedo = each.color;
    of.least_coverage = 0.5f;
    if (each.opacity < 1) of.opacity = float(each.opacity);
    scene.models.push_back({Part{of.name, mesh}});
    scene.instances.push_back({scene.models.size() - 1, glm::translate(glm::mat4(1), {0, 0, float(each.z)})});
  }
  for (const char* path : {"unified", "vertex", "legacy", "interpolated"}) {
    Renderer renderer(scene, 16, 16, {.path = find_lighting_path(path)});
    const Fog fog = Fog::from_visibility(FogMode::exp, 15.0);
    renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
    renderer.draw(LightPoints::off);
    const glm::dvec3 eye = scene.camera.position;
    const glm::dvec3 view = view_direction(scene.camera, 16, 16, 8.5, 8.5);
    glm::dvec3 seen(kFogColor);  // far behind
    for (const std::size_t i : {1u, 2u, 0u}) {
      const double range = (panels[i].z - eye.z) / view.z * glm::length(view);
      const glm::dvec3 lit = panels[i].color * glm::dvec3(scene.environment.ambient_light);
      // What is behind, as it is seen just before the panel, on through the fog.
      const double through = fog_factor_at(fog, range);
      const glm::dvec3 arriving = (seen - glm::dvec3(kFogColor) * (1 - through)) / through;
      seen = glm::mix(glm::dvec3(kFogColor), glm::mix(arriving, lit, panels[i].opacity), through);
    }
    EXPECT_LT(glm::distance(pixel(renderer.read(), 8, 8), seen), 2e-3) << path;
    EXPECT_LT(glm::distance(pixel(shade_reference(renderer).picture, 8, 8), seen), 1e-5) << path;
  }
}

// A picture draws them in the order of their middles, which is wrong on one side: an error that the reference shows.
TEST_F(ReferenceMaterial, PanesThatCrossAreSortedByTheReference) {
  Material of = material(kNearest);
  of.plain_albedo = glm::vec3(0.9f, 0.1f, 0.1f);
  of.least_coverage = 0.5f;
  of.opacity = 0.5f;
  Scene scene = panel(of);
  scene.environment.ambient_light = glm::vec3(1);
  Material& other = scene.materials.emplace_back(of);
  other.name = "other";
  other.plain_albedo = glm::vec3(0.1f, 0.9f, 0.1f);
  scene.models.push_back({Part{"other", scene.models[0][0].mesh}});
  scene.instances.push_back({1, glm::rotate(glm::mat4(1), 0.5f, glm::vec3(0, 1, 0))});
  Renderer renderer(scene, 32, 32, {});
  const Picture picture = shade_reference(renderer).picture;
  // The left side of the other is nearer than the panel.
  EXPECT_LT(glm::distance(pixel(picture, 8, 16), {0.5 * 0.1 + 0.25 * 0.9, 0.5 * 0.9 + 0.25 * 0.1, 0.075}), 1e-4);
  EXPECT_LT(glm::distance(pixel(picture, 23, 16), {0.5 * 0.9 + 0.25 * 0.1, 0.5 * 0.1 + 0.25 * 0.9, 0.075}), 1e-4);
}

/// Five panels of all these materials around lamps, with pictures that are filtered.
Scene panels_by_lamps() {
  Material of = material({});
  of.specular = glm::vec3(0.3f);
  of.shininess = 12;
  of.normal = random_texels(4, {});
  Scene scene = panel(of);
  add_details(scene);
  const Mesh mesh = scene.models[0][0].mesh;
  scene.models[0][0].mesh.details.clear();
  const auto add = [&](const char* name, const glm::mat4& place, auto change) {
    Material& added = scene.materials.emplace_back(of);
    added.name = name;
    change(added);
    scene.models.push_back({Part{name, mesh}});
    scene.instances.push_back({scene.models.size() - 1, place});
  };
  const auto at = [](const glm::vec3& place, float yaw) {
    return glm::rotate(glm::translate(glm::mat4(1), place), yaw, glm::vec3(0, 1, 0));
  };
  add("mask", at({-2, 0.5f, 1.5f}, 0.6f), [](Material& added) { added.least_coverage = 0.45f; });
  add("emission", at({2.2f, -0.5f, 0.7f}, -0.5f), [](Material& added) {
    added.emission = random_texels(5, {});
    added.emissive = {0.3f, 0.2f, 0.1f};
  });
  add("unlit", at({0.5f, 2, -1}, 0), [](Material& added) {
    added.is_unlit = true;
    added.specular = glm::vec3(0);
    added.emissive = {0.3f, 0.4f, 0.5f};
    added.least_coverage = 0.6f;
  });
  add("pane", at({0.3f, -0.4f, 1.8f}, 0.3f), [](Material& added) {
    added.least_coverage = 0.5f / 0.7f;
    added.opacity = 0.7f;
  });
  for (int i = 0; i < 3; ++i) {
    PlacedLight lamp;
    lamp.light = {.name = "lamp", .color = {0.9, 0.8, 0.7}, .attenuation = {1, 0.1, 0.05}, .cone = {}};
    lamp.position = {2.0 * i - 2, 0.5 * i, 2.5};
    lamp.direction = {0, 0, -1};
    lamp.carried = i == 0;
    scene.lights.push_back(lamp);
  }
  return scene;
}

TEST_F(ReferenceMaterial, PathsDrawFilteredPicturesByLampsAsTheReferenceHasThem) {
  const Scene scene = panels_by_lamps();
  for (const LightingPath& path : lighting_paths()) {
    if (path.evaluation == Evaluation::vertex) continue;  // lamps within a triangle
    Renderer renderer(scene, 64, 48, {.path = &path, .samples = path.has_several_passes() ? 1 : 4});
    for (const double visibility : {std::numeric_limits<double>::infinity(), 8.0}) {
      renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp, visibility)));
      renderer.draw(LightPoints::off);
      const PictureError error = picture_error(renderer.read(), shade_reference(renderer));
      EXPECT_LE(error.beyond_maps, 0.25) << path.name << " " << visibility;
    }
  }
}

// Lamps glow to the depth of what is seen: a hole of a mask must not end their rays. In all orders of scattering, but
// where these light surfaces, too, coarsely.
TEST_F(ReferenceMaterial, AirlightEndsAtWhatAMaskLeavesByEveryPathThatTakesIt) {
  const Scene scene = panels_by_lamps();
  for (const LightingPath& path : lighting_paths()) {
    if (!path.takes_airlight) continue;
    Renderer renderer(scene, 64, 48,
                      {.path = &path,
                       .fog_lighting = FogLighting::airlight,
                       .scattering = path.takes_scattered_light ? Scattering::single : Scattering::all,
                       .samples = path.has_several_passes() ? 1 : 4});
    renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp, 20.0)));
    renderer.draw(LightPoints::off);
    const Picture picture = renderer.read();
    EXPECT_TRUE(std::ranges::all_of(picture.rgb, [](float value) { return std::isfinite(value); })) << path.name;
    if (path.has_reference) {
      EXPECT_LE(picture_error(picture, shade_reference(renderer)).beyond_maps, 1) << path.name;
    }
  }
}

TEST_F(ReferenceMaterial, SkippingChangesAMaskedSceneByLessThanAStep) {
  const Scene scene = panels_by_lamps();
  Renderer all(scene, 64, 48, {.skipping = Skipping::off});
  Renderer skipping(scene, 64, 48, {.skipping = Skipping::on});
  std::size_t as_fog = 0;
  for (const double visibility : {8.0, 2.0, 1.0}) {
    for (Renderer* renderer : {&all, &skipping})
      renderer->set_atmosphere(renderer->scene().atmosphere.with(Fog::from_visibility(FogMode::exp, visibility)));
    all.draw(LightPoints::off);
    as_fog += skipping.draw(LightPoints::off).chunks_as_fog;
    const Picture pictures[] = {all.read(), skipping.read()};
    for (std::size_t i = 0; i < pictures[0].rgb.size(); ++i) {
      const auto level = [](float x) { return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f; };
      ASSERT_NEAR(level(pictures[0].rgb[i]), level(pictures[1].rgb[i]), 1 / 255.0) << visibility;
    }
  }
  EXPECT_GT(as_fog, 0u);
}

/// A mask of 4 x 4 fields of half a metre between a lamp and a wall, with every other of them a hole.
Scene mask_before_wall() {
  Material of = material(kNearest);
  Texels texels = *of.albedo;
  for (std::size_t i = 0; i < texels.rgba.size() / 4; ++i) {
    const std::size_t field = i % kSide / 2 + i / kSide / 2;
    texels.rgba[4 * i + 3] = field % 2 == 0 ? 255 : 0;
  }
  texels.sampling.wrap_v = Sampling::Wrap::mirror;
  of.albedo = std::make_shared<const Texels>(texels);
  of.least_coverage = 0.5f;
  Scene scene = panel(of);
  Material wall = material({});
  wall.name = "wall";
  wall.plain_albedo = glm::vec3(0.7f);
  scene.materials.push_back(wall);
  scene.models.push_back({Part{"wall", scene.models[0][0].mesh}});
  for (Vertex& vertex : scene.models[1][0].mesh.vertices) vertex.position = 3.0f * vertex.position - glm::vec3(0, 0, 3);
  scene.instances.push_back({1, glm::mat4(1)});
  PlacedLight lamp;
  lamp.light = {.name = "lamp", .color = {2.0, 1.8, 1.5}, .attenuation = {1, 0, 0.01}, .cone = {}};
  lamp.position = {0, 0, 3};
  lamp.direction = {0, 0, -1};
  scene.lights.push_back(lamp);
  return scene;
}

TEST_F(ReferenceMaterial, LampShinesThroughTheHolesOfAMask) {
  const Scene scene = mask_before_wall();
  Renderer renderer(scene, 96, 72, {.shadows = Shadows::surfaces, .shadow_map_size = 2048});
  const ReferenceShadows shadows(renderer);
  const ReferenceLight light = reference_lights(scene, {}, RenderSettings{}).at(0);
  for (int x = -3; x < 3; ++x) {
    for (int y = -3; y < 3; ++y) {
      const glm::dvec2 middle(x * 0.5 + 0.25,
                              y * 0.5 + 0.25);  // a field's middle; on the wall twice as far from the axis
      const std::uint8_t* const texel = texel_at(*scene.materials[0].albedo, middle + 0.01);
      EXPECT_EQ(shadows.is_dark(light, glm::dvec3(2.0 * middle, -3)), texel[3] == 255) << x << ", " << y;
    }
  }
  renderer.draw(LightPoints::off);
  const PictureError error = picture_error(renderer.read(), shade_reference(renderer));
  EXPECT_LE(error.largest, 0.25);
  EXPECT_LT(error.excluded, 96 * 72 / 3u);
}

}  // namespace

}  // namespace litfog::test
