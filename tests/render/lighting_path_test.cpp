// SPDX-License-Identifier: Apache-2.0
#include "render/plan/lighting_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gl/gl_test.h"
#include "litfog/photometry/cube_face.h"
#include "reference/ulp.h"
#include "render/pixel.h"
#include "render/renderer.h"
#include "render/wall.h"
#include "scene/file/scene_file.h"
#include "scene/light_frame.h"
#include "scene/model/primitive.h"
#include "scene/paint/material_catalogue.h"

namespace litfog::test {
using namespace scene;
using namespace render;

namespace {

using glm::dvec3;

TEST(LightingPath, TenPathsBeginWithTheDefault) {
  const std::vector<std::string_view> expected{"unified",    "lookup-3d", "lookup-2d", "radial",  "radial-plane",
                                               "accumulate", "vertex",    "mixed",     "tangent", "legacy"};
  std::vector<std::string_view> names;
  for (const LightingPath& path : lighting_paths()) names.push_back(path.name);
  EXPECT_EQ(names, expected);
  EXPECT_EQ(RenderSettings{}.path->name, "unified");
}

TEST(LightingPath, PathIsFoundByItsNameAlone) {
  EXPECT_EQ(find_lighting_path("radial-plane")->name, "radial-plane");
  EXPECT_EQ(find_lighting_path("radial-"), nullptr);
  EXPECT_EQ(find_lighting_path(""), nullptr);
}

// --- formula pixels: a wall of one colour that fills the picture ---

Scene wall(int cells) {
  Scene scene = make_wall(cells, "sign_white");
  for (Vertex& vertex : scene.models[0][0].mesh.vertices) {
    vertex.uv = glm::vec2(0.5f / 64);  // the first texel of 64 on a metre, everywhere
  }
  add_materials(scene);
  return scene;
}

PlacedLight lamp(const dvec3& position, const Attenuation& attenuation, const Cone& cone, bool carried) {
  return {.light = {.name = "lamp", .color = {0.5, 0.4, 0.3}, .attenuation = attenuation, .cone = cone},
          .position = position,
          .direction = glm::normalize(dvec3(0.1, -0.05, -1)),
          .carried = carried};
}

constexpr Attenuation kQuadratic{1, 0, 0.3};  // extent 8 m

/// Six of one kind, so that four at a time are not all, a point light, and a local one, which is not seen itself
/// because it shines away from the eye.
std::vector<PlacedLight> lamps() {
  std::vector<PlacedLight> lights;
  for (int i = 0; i < 6; ++i) {
    lights.push_back(
        lamp({1.1 * i - 2.6, 0.7 * (i % 3) - 0.8, -0.6 - 0.3 * i}, kQuadratic, Cone::smoothstep(0.1, 0.7), true));
  }
  lights.push_back(lamp({-1, 0.6, -2}, {1, 0.1, 0.2}, Cone{}, true));
  lights.push_back(lamp({1.2, -0.7, -1.5}, {1, 0, 0.5}, Cone::smoothstep(0.2, 1.3), false));
  return lights;
}

Picture draw(const Scene& scene, const Fog& fog, const RenderSettings& settings) {
  Renderer renderer(scene, kWidth, kHeight, settings);
  renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
  renderer.draw();
  return renderer.read();
}

/// What the wall is made of. The colour is as drawn under a white ambient light alone: a driver may take an sRGB texel
/// for a percent more or less than it is. Gloss is the material's texel; its normal map is flat.
struct Finish {
  explicit Finish(const Scene& scene) {
    Scene bare = scene;
    bare.lights.clear();
    bare.environment = {.ambient_light = glm::vec3(1)};
    const Picture picture = draw(bare, Fog{}, {});
    albedo = pixel(picture, 0, 0);
    const Material& material = scene.materials[0];
    gloss = material.albedo->rgba[3] / 255.0;
    specular = material.specular;
    shininess = double(material.shininess);
  }
  dvec3 albedo, specular;
  double gloss, shininess;
};

/// What a path says of a wall in a fog, in double from the papers' formulas.
class Expected {
 public:
  Expected(const Scene& scene, const Finish& finish, const RenderSettings& settings, const Fog& fog)
      : scene_(scene), finish_(finish), settings_(settings), fog_(fog) {
    for (const PlacedLight& placed : scene.lights) {
      reaches_.push_back(compute_extent(placed.light.attenuation, placed.light.threshold));
      intensities_.push_back(solve_fog_intensity(placed.light, fog).intensity);
    }
  }

  /// What a point of the wall looks like.
  dvec3 color_at(const dvec3& point) const {
    const LightingPath& path = *settings_.path;
    const Environment& environment = scene_.environment;
    const dvec3 normal(0, 0, 1);
    const dvec3 to_eye =
        settings_.papers.has_infinite_viewer ? dvec3(0, 0, 1) : glm::normalize(dvec3(scene_.camera.position) - point);
    const auto reflected = [&](const dvec3& to_light) {
      const double diffuse = std::max(glm::dot(normal, to_light), 0.0);
      if (path.surface != SurfaceModel::basic || diffuse <= 0) return finish_.albedo * diffuse;
      const double facing = std::max(glm::dot(normal, glm::normalize(to_light + to_eye)), 0.0);
      return finish_.albedo * diffuse + finish_.specular * (finish_.gloss * std::pow(facing, finish_.shininess));
    };
    dvec3 surface = finish_.albedo * dvec3(environment.ambient_light) +
                    reflected(dvec3(environment.moon_direction)) * dvec3(environment.moon_color);
    dvec3 fog_color = scene_.atmosphere.ambient_fog_color;
    for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
      const auto& [light, position, direction, carried] = scene_.lights[i];
      const double range = glm::distance(point, position);
      const dvec3 to_light = (position - point) / range;
      const auto cookie = scene_.cookie_uses.find(i);
      const double cone = cookie == scene_.cookie_uses.end()
                              ? cone_at(light.cone, glm::dot(direction, -to_light))
                              : cookie_at(scene_.cookies[cookie->second.cookie],
                                          cookie_from_world(direction, cookie->second.roll) * -to_light);
      if (carried && path.has_lit_fog) fog_color += light.color * (cone * intensities_[i]);
      if (range > reaches_[i]) continue;
      const double fall = path.range == RangeLaw::radial ? 1 - range * range / (reaches_[i] * reaches_[i])
                                                         : attenuation_at(light.attenuation, range);
      surface +=
          light.color * (cone * fall) * (path.surface == SurfaceModel::unshaded ? finish_.albedo : reflected(to_light));
    }
    const double through = fog_factor_at(fog_, glm::length(point));
    return through * surface + (1 - through) * fog_color;
  }

 private:
  const Scene& scene_;
  const Finish& finish_;
  const RenderSettings& settings_;
  Fog fog_;
  std::vector<double> reaches_;      // one a light
  std::vector<double> intensities_;  // one a light
};

/// Largest difference from the formula over all pixels, in each fog.
std::vector<double> worst_errors(const Scene& scene, const Finish& finish, const std::vector<Fog>& fogs,
                                 const RenderSettings& settings) {
  Renderer renderer(scene, kWidth, kHeight, settings);
  std::vector<double> errors;
  for (const Fog& fog : fogs) {
    renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
    renderer.draw();
    const Picture picture = renderer.read();
    const Expected expected(scene, finish, settings, fog);
    double& worst = errors.emplace_back(0);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const dvec3 error = glm::abs(pixel(picture, x, y) - expected.color_at(wall_point(scene, x, y)));
        worst = std::max({worst, error.x, error.y, error.z});
      }
    }
  }
  return errors;
}

double worst_error(const Scene& scene, const Fog& fog, const RenderSettings& settings) {
  return worst_errors(scene, Finish(scene), {fog}, settings).front();
}

class LightingPathPixels : public test::GlTest {
 protected:
  static RenderSettings settings(std::string_view path) { return {.path = find_lighting_path(path)}; }
  static std::vector<Fog> clear_and_foggy() {
    return {Fog{}, Fog::from_visibility(FogMode::exp, 20.0), Fog::from_visibility(FogMode::exp2, 12.0)};
  }
  /// A path's errors in clear air and in fogs.
  static void check(const std::string& range, double bound, const Scene& scene, const Finish& finish,
                    std::string_view path) {
    test::WorstError error(std::string(path), range, bound, "absolute");
    for (const double worst : worst_errors(scene, finish, clear_and_foggy(), settings(path))) {
      error.add(worst, [] { return ""; });
    }
    error.check();
  }
};

// Half a step of the framebuffer's half floats below 4, which no pixel here exceeds; passes add up in floats before.
constexpr double kHalfFloat = 0x1p-10;

/// Lamps of every profile, every other one carried.
std::vector<PlacedLight> crowd(int count) {
  std::vector<PlacedLight> lights;
  for (int i = 0; i < count; ++i) {
    const bool carried = i % 2 == 0;
    const Cone cone = i % 3 == 0 ? Cone::smoothstep(0.2, 0.9) : i % 3 == 1 || !carried ? Cone::cosine(0.8, 4) : Cone{};
    lights.push_back(
        lamp({0.37 * (i % 11) - 1.8, 0.31 * (i % 7) - 0.9, -0.5 - 0.11 * (i % 13)}, kQuadratic, cone, carried));
    lights.back().light.color *= 4.0 / count;
  }
  return lights;
}

// Up to 16 lights, those of the fog and of the surface, are passed as uniforms; more are in the light list.
TEST_F(LightingPathPixels, FewAndManyLightsAreTheBasicModel) {
  Scene scene = wall(1);
  const Finish finish(scene);
  for (const int count : {1, 2, 3, 4, 5, 8, 9, 15, 16, 17, 31, 32, 33, 34, 40}) {
    scene.lights = crowd(count);
    const std::string lights = "wall under " + std::to_string(count) + " lamps of every profile";
    // In one pass, in several.
    for (const char* path : {"unified", "tangent"}) check(lights, kHalfFloat, scene, finish, path);
  }
}

// Attenuation without linear and quadratic parts never ends a light: one as far as floats go, and one that ends 10,000
// km away, beside whose extent the way to a surface is nothing.
TEST_F(LightingPathPixels, LightsWithoutAnEndLightEveryPath) {
  for (const Attenuation& attenuation : {Attenuation{2, 0, 0}, Attenuation{1, 1.9e-6, 0}}) {
    Scene scene = wall(256);
    const Finish finish(scene);
    scene.lights = {lamp({0.4, -0.3, -2}, attenuation, Cone{}, true)};
    const double reach = compute_extent(attenuation, scene.lights[0].light.threshold);
    for (const LightingPath& path : lighting_paths()) {
      double bound = kHalfFloat;
      if (path.evaluation == Evaluation::lookup && std::isfinite(reach)) {
        // The wall lies between the texels around the light, half a texel off along each axis.
        const double off = std::sqrt(3.0) / 127;  // fraction of the extent
        const double fall = path.range == RangeLaw::radial ? off * off : 1 - attenuation_at(attenuation, off * reach);
        bound += finish.albedo.r * scene.lights[0].light.color.r * fall;
      }
      check("wall under an endless lamp", bound, scene, finish, path.name);
    }
  }
}

/// Six faces of a size, brighter to their own sides than to the others, without steps.
Cookie smooth_cookie(int size) {
  Cookie cookie{.size = size, .texels = {}};
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const auto middle = [size](int i) { return (2.0 * i + 1) / size - 1; };
        const dvec3 d = glm::normalize(cube_direction({face, middle(column), middle(row)}));
        cookie.texels.push_back(float(0.5 + 0.3 * std::sin(5 * d.x) + 0.2 * std::cos(4 * d.y + 1)));
      }
    }
  }
  return cookie;
}

// Two cookies of two sizes, turned, on lights that light the fog.
TEST_F(LightingPathPixels, CookiesAreTheirTexelsByEveryPath) {
  Scene scene = wall(64);
  scene.lights = {lamp({-1.2, 0.3, -1}, kQuadratic, Cone{}, true), lamp({1, -0.4, -1.8}, kQuadratic, Cone{}, true),
                  lamp({0.2, 0.9, -1.4}, kQuadratic, Cone::smoothstep(0.1, 0.7), true)};
  scene.cookies = {smooth_cookie(64), smooth_cookie(128)};
  scene.cookie_uses = {{0, {.cookie = 0, .roll = 0.4}}, {1, {.cookie = 1, .spin = -0.3}}};
  move_to_time(scene, 2);
  EXPECT_EQ(scene.cookie_uses[1].roll, -0.6);
  const Finish finish(scene);
  for (const LightingPath& path : lighting_paths()) {
    for (const double error : worst_errors(scene, finish, clear_and_foggy(), settings(path.name))) {
      EXPECT_LE(error, 1.0 / 255) << path.name;
    }
  }
}

/// A ball in moonlight alone, twelve faces around.
Scene moonlit_ball() {
  Scene scene;
  scene.camera = {.position = {0, 0, 3}, .target = {0, 0, 0}, .field_of_view = 0.6f};
  scene.environment.moon_direction = glm::normalize(glm::vec3(1, 0.2f, 0.5f));
  scene.environment.moon_color = glm::vec3(1);
  Mesh mesh = make_sphere(0.8f, 12);
  for (Vertex& vertex : mesh.vertices) vertex.uv = glm::vec2(0.5f / 64);
  scene.models.push_back({{"sign_white", std::move(mesh)}});
  scene.instances.push_back({0, glm::mat4(1)});
  add_materials(scene);
  return scene;
}

/// How many shades a picture has.
/// In steps of 1/4096, coarser than the rounding of a face's normal.
std::size_t count_shades(const Picture& picture) {
  std::vector<float> shades = picture.rgb;
  for (float& shade : shades) shade = std::round(shade * 4096);
  std::sort(shades.begin(), shades.end());
  return std::size_t(std::unique(shades.begin(), shades.end()) - shades.begin());
}

TEST_F(LightingPathPixels, FlatShadedFaceHasOneShade) {
  const RenderSettings smooth = settings("lookup-2d");
  RenderSettings flat = smooth;
  flat.papers.is_flat_shaded = true;
  // Three channels of the ball's faces in light and the few shades at their edges, where four samples are averaged.
  EXPECT_LT(3 * count_shades(draw(moonlit_ball(), Fog{}, flat)), count_shades(draw(moonlit_ball(), Fog{}, smooth)));
}

TEST_F(LightingPathPixels, ChangedMoonAndAmbientLightGiveThePictureOfANewRenderer) {
  const Fog fog = Fog::from_visibility(FogMode::exp, 40.0);
  for (const LightingPath& path : all_paths()) {
    Scene scene = moonlit_ball();
    scene.lights = lamps();
    scene.lights.resize(2);
    Renderer renderer(scene, kWidth, kHeight, settings(path.name));
    const auto picture = [&] {
      renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
      renderer.draw();
      return renderer.read();
    };
    Picture before = picture();
    for (const Environment& environment :
         {Environment{.ambient_light = {0.1f, 0.2f, 0.3f}},  // without a moon
          Environment{.moon_direction = glm::normalize(glm::vec3(-1, 0.3f, 0.7f)), .moon_color = {0.7f, 0.9f, 0.1f}},
          moonlit_ball().environment}) {
      scene.environment = environment;
      const Picture after = picture();
      EXPECT_EQ(largest_difference(after, draw(scene, fog, settings(path.name))), 0) << path.name;
      EXPECT_GT(largest_difference(after, before), 0.1) << path.name;
      before = after;
    }
  }
}

TEST_F(LightingPathPixels, ExposureThereAndBackGivesThePictureOfANewRenderer) {
  Scene scene = wall(8);
  scene.lights = lamps();
  for (const LightingPath& path : lighting_paths()) {
    if (!path.takes_airlight || path.maps == LightMapSet::none) continue;
    const RenderSettings by_airlight{.path = &path, .fog_lighting = FogLighting::airlight};
    const Fog fog = Fog::from_visibility(FogMode::exp, 40.0);
    Renderer renderer(scene, kWidth, kHeight, by_airlight);
    renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
    for (const double ev : {3.0, 0.0}) renderer.set_exposure({.ev = ev});
    renderer.draw();
    EXPECT_EQ(largest_difference(renderer.read(), draw(scene, fog, by_airlight)), 0) << path.name;
  }
}

// Two sheets of one surface at the same depth: all passes draw the later one, and no sample is lit twice.
TEST_F(LightingPathPixels, EveryPassDrawsTheLastOfCoincidentTriangles) {
  Scene last = wall(1);
  last.lights = lamps();
  last.lights.resize(5);  // more than the four of a pass
  last.materials.push_back(
      {.name = "halves",
       .size_m = 1,
       .albedo = std::make_shared<const Texels>(Texels{2, 1, {250, 30, 60, 255, 20, 200, 90, 255}}),
       .normal = std::make_shared<const Texels>(Texels{1, 1, {128, 128, 255, 0}}),
       .specular = glm::vec3(0.3f),
       .shininess = 20,
       .emissive = {}});
  Part& part = last.models[0][0];
  part.material = "halves";
  Scene both = last;
  Mesh& mesh = both.models[0][0].mesh;
  for (Vertex& vertex : mesh.vertices) vertex.uv = glm::vec2(0.25f, 0.5f);
  for (Vertex& vertex : part.mesh.vertices) vertex.uv = glm::vec2(0.75f, 0.5f);
  append(mesh, part.mesh, glm::mat4(1));
  for (const LightingPath& path : lighting_paths()) {
    if (!path.has_several_passes()) continue;
    EXPECT_EQ(largest_difference(draw(both, Fog{}, {.path = &path}), draw(last, Fog{}, {.path = &path})), 0)
        << path.name;
  }
}

// At full size more triangles that share a plane are seen.
TEST_F(LightingPathPixels, AccumulateAgreesWithRadialAtFullSize) {
  const Scene scene = read_scene(bundled_scene_path("headlights"));
  const auto draw_large = [&](const char* path) {
    Renderer renderer(scene, 1280, 720, settings(path));
    renderer.draw();
    return renderer.read();
  };
  EXPECT_LE(largest_difference(draw_large("radial"), draw_large("accumulate")), 8 * kHalfFloat);
}

TEST_F(LightingPathPixels, ThreeRadialPathsAgree) {
  for (const char* name : {"headlights", "tessellation", "room"}) {
    const Scene scene = read_scene(bundled_scene_path(name));
    const Fog fog = Fog::from_visibility(FogMode::exp, scene.visibilities[0]);
    const Picture radial = draw(scene, fog, settings("radial"));
    EXPECT_LE(largest_difference(radial, draw(scene, fog, settings("accumulate"))), 8 * kHalfFloat) << name;
  }
  // Elsewhere surfaces in one plane hide each other by the rounding of their depths, which is another after a geometry
  // shader.
  const Scene scene = read_scene(bundled_scene_path("tessellation"));
  EXPECT_LE(largest_difference(draw(scene, Fog{}, settings("radial")), draw(scene, Fog{}, settings("radial-plane"))),
            8 * kHalfFloat);
}

TEST_F(LightingPathPixels, InfiniteViewerIsInOneDirectionFromEveryPoint) {
  Scene scene = wall(1);
  scene.lights = lamps();
  RenderSettings infinite = settings("unified");
  infinite.papers.has_infinite_viewer = true;
  EXPECT_LE(worst_error(scene, Fog{}, infinite), kHalfFloat);
  EXPECT_GT(largest_difference(draw(scene, Fog{}, infinite), draw(scene, Fog{}, settings("unified"))), 0.01);
}

}  // namespace

}  // namespace litfog::test
