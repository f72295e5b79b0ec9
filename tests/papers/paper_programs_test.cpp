// SPDX-License-Identifier: Apache-2.0
#include "papers/paper_programs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <vector>

#include "gl/gl_test.h"
#include "papers/opengl_pictures.h"
#include "render/pixel.h"
#include "render/renderer.h"
#include "render/wall.h"

namespace litfog::test {
using namespace papers;
using namespace render;

namespace {

using glm::dvec3;

constexpr double kHalfFloat = 0x1p-10;
constexpr dvec3 kKd(0.5, 0.4, 0.3);

class PaperPrograms : public GlTest {};

PlacedLight spot(const dvec3& position, double inner, double outer) {
  return {.light = {.name = "spot",
                    .color = {0.9, 0.7, 0.5},
                    .attenuation = {0.4, 0.1, 0.05},
                    .cone = Cone::smoothstep(inner, outer)},
          .position = position};
}

/// A wall in the light of two spots that overlap.
scene::Scene lit_wall(int cells, const dvec3& ks = dvec3(0.3)) {
  scene::Scene scene = make_wall(cells, "plain");
  scene.materials.push_back({.name = "plain",
                             .size_m = 1,
                             .albedo = nullptr,
                             .normal = std::make_shared<const scene::Texels>(scene::Texels{1, 1, {128, 128, 255, 0}}),
                             .specular = ks,
                             .shininess = 10,
                             .emissive = {},
                             .plain_albedo = kKd});
  scene.lights = {spot({-0.6, 0.3, -1}, 0.15, 0.5), spot({0.9, 0, -0.5}, 0.1, 0.4)};
  return scene;
}

Picture draw(const scene::Scene& scene, RenderSettings settings) {
  Renderer renderer(scene, kWidth, kHeight, settings);
  renderer.draw(LightPoints::off);
  return renderer.read();
}

Picture draw(const scene::Scene& scene, const LightingPath& path) {
  return draw(scene, {.skipping = Skipping::off, .path = &path, .samples = 1});
}

Picture draw(const scene::Scene& scene, std::string_view path) { return draw(scene, *find_lighting_path(path)); }

TEST_F(PaperPrograms, VerticesAreLitAlikeInEverySpace) {
  scene::Scene scene = lit_wall(20);
  scene.instances[0].world_from_model =
      glm::scale(glm::rotate(scene.instances[0].world_from_model, 0.3, dvec3(1, -2, 0.5)), dvec3(2));
  const Picture world = draw(scene, cg_at_vertices(Space::world));
  EXPECT_LE(largest_difference(draw(scene, cg_at_vertices(Space::object)), world), 2 * kHalfFloat);
  EXPECT_LE(largest_difference(draw(scene, cg_at_vertices(Space::eye)), world), 2 * kHalfFloat);
}

TEST_F(PaperPrograms, VerticesApproachTheFragmentsFormulas) {
  const auto error = [](int cells) {
    const scene::Scene scene = lit_wall(cells);
    return largest_difference(draw(scene, cg_at_vertices(Space::object)), draw(scene, "cg"));
  };
  const double coarse = error(10);
  const double fine = error(80);
  EXPECT_LT(fine, coarse / 10);
  EXPECT_LT(fine, 0.01);
}

TEST_F(PaperPrograms, SpecularColorOfALightTintsHighlightsAlone) {
  const scene::Scene matt = lit_wall(1, dvec3(0));
  EXPECT_EQ(draw(matt, cg_with_two_colors()).rgb, draw(matt, "cg").rgb);
  const Picture matt_picture = draw(matt, "cg");
  const Picture glossy = draw(lit_wall(1), "cg");
  const Picture tinted = draw(lit_wall(1), cg_with_two_colors());
  for (int y = 2; y < kHeight; y += 7) {
    for (int x = 2; x < kWidth; x += 7) {
      const dvec3 highlight = pixel(glossy, x, y) - pixel(matt_picture, x, y);
      const dvec3 expected = pixel(matt_picture, x, y) + highlight * dvec3(0.1, 0.3, 1);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel(tinted, x, y)[c], expected[c], 4 * kHalfFloat) << x << ' ' << y;
    }
  }
}

TEST_F(PaperPrograms, TwoPassesALightFilterEachOthersLight) {
  scene::Scene scene = lit_wall(1);
  scene.lights[1] = spot({-0.2, 0.3, -0.5}, 0.05, 0.1);
  const Picture accumulated = draw(scene, "accumulate");
  const Picture filtered = draw(scene, frazier_in_two_passes());
  int in_both = 0, in_one = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const dvec3 point = wall_point(scene, x, y);
      const auto angle = [&](const PlacedLight& light) {
        const dvec3 ray = glm::normalize(point - light.position);
        return std::acos(glm::dot(ray, light.direction));
      };
      const double first = angle(scene.lights[0]), second = angle(scene.lights[1]);
      if (first < 0.13 && second < 0.04) {
        ++in_both;
        EXPECT_NEAR(pixel(filtered, x, y).r, pixel(accumulated, x, y).r, 0.01) << x << ' ' << y;
      } else if (first < 0.13 && second > 0.13) {
        ++in_one;
        EXPECT_GT(pixel(accumulated, x, y).r, 0.1) << x << ' ' << y;
        EXPECT_NEAR(pixel(filtered, x, y).r, 0, 1e-3) << x << ' ' << y;
      }
    }
  }
  EXPECT_GT(in_both, 10);
  EXPECT_GT(in_one, 10);
}

TEST_F(PaperPrograms, BumpsTakeTheRadialLightByItsAngle) {
  scene::Scene scene = lit_wall(1, dvec3(0));
  scene.environment.ambient_light = scene.environment.moon_color = {};
  scene.lights.pop_back();
  const Picture plain = draw(scene, "radial");
  const Picture bumps = draw(scene, frazier_with_bumps());
  for (int y = 1; y < kHeight; y += 5) {
    for (int x = 1; x < kWidth; x += 5) {
      const dvec3 to_light = glm::normalize(scene.lights[0].position - wall_point(scene, x, y));
      EXPECT_NEAR(pixel(bumps, x, y).r, pixel(plain, x, y).r * to_light.z, 2 * kHalfFloat) << x << ' ' << y;
    }
  }
}

// A square of 1 m at half the height of the lamp above a floor: a shadow of 2 m.
TEST_F(PaperPrograms, StencilShadowIsThatOfTheRays) {
  constexpr double kHeightOfSquare = 1.5;
  const dvec3 lamp(0.2, 3, 0.1);
  const auto level = [](double half_side, double height) {
    const auto s = float(half_side), y = float(height);
    const std::vector<glm::vec3> corners{{-s, y, s}, {s, y, s}, {-s, y, -s}, {s, y, -s}};
    return scene::make_surface(corners, 2);
  };
  scene::Scene scene;
  scene.camera = {.position = {0, 4, 5}, .target = {0, 0.4f, 0}, .field_of_view = 0.9f};
  scene.models.push_back({{"plain", level(6, 0)}});
  scene.models.push_back({{"plain", level(0.5, kHeightOfSquare)}});
  scene.instances = {{0, glm::dmat4(1)}, {1, glm::dmat4(1)}};
  const Picture lit = draw_stencil_shadow(scene, lamp, kWidth, kHeight);
  int dark = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const dvec3 view = view_direction(scene.camera, kWidth, kHeight, x + 0.5, y + 0.5);
      const dvec3 eye = scene.camera.position;
      const auto at_height = [](const dvec3& from, const dvec3& ray, double height) {
        return from + ray * ((height - from.y) / ray.y);
      };
      const auto outside = [](const dvec3& p, double half) { return std::max(std::abs(p.x), std::abs(p.z)) - half; };
      const double square = outside(at_height(eye, view, kHeightOfSquare), 0.5);
      const dvec3 floor = at_height(eye, view, 0);
      const double shadow = outside(at_height(floor, lamp - floor, kHeightOfSquare), 0.5);
      const double border = outside(floor, 6);
      if (std::min({std::abs(square), std::abs(shadow), std::abs(border)}) < 0.05) continue;
      const bool is_lit = square < 0 || (border < 0 && shadow > 0);
      EXPECT_EQ(pixel(lit, x, y).r, is_lit ? 1 : 0) << x << ' ' << y;
      dark += !is_lit && border < 0;
    }
  }
  EXPECT_GT(dark, 50);
}

TEST_F(PaperPrograms, FixedPipelineIsWhatLegacyMimics) {
  scene::Scene scene = lit_wall(12);
  for (PlacedLight& light : scene.lights) {
    light.light.cone = {};
    light.light.attenuation = {1, 0.05, 0};
    light.light.color *= 0.5;
  }
  const Fog fog{FogMode::exp2, 0};
  const auto fixed = draw_by_fixed_pipeline(scene, fog, kWidth, kHeight, 1);
  if (!fixed) GTEST_SKIP() << "no compatibility profile";
  const Picture legacy = draw(scene, {.path = find_lighting_path("legacy")});
  EXPECT_LE(largest_difference(fixed->picture, legacy), 4 * kHalfFloat);
  EXPECT_GT(fixed->mimic_ratio, 0);
}

}  // namespace
}  // namespace litfog::test
