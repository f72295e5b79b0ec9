// SPDX-License-Identifier: Apache-2.0
#include "measure/traced_picture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "gl/gl_test.h"
#include "litfog/attenuation.h"
#include "scene/file/scene_file.h"

namespace litfog::test {
namespace {

class TracedPicture : public GlTest {};

constexpr double kWall = 20;  // metres ahead

/// A square of 2 km across the view, and a lamp before it.
scene::Scene wall_ahead(float reflectance, double distance = kWall) {
  scene::Scene scene;
  scene.camera = {.position = {0, 0, 0}, .target = {0, 0, -1}, .field_of_view = 0.8f};
  scene.atmosphere.phase = {};
  scene.materials.push_back({.name = "wall",
                             .size_m = 1,
                             .albedo = std::make_shared<const scene::Texels>(scene::Texels{1, 1, {255, 255, 255, 255}}),
                             .normal = std::make_shared<const scene::Texels>(scene::Texels{1, 1, {128, 128, 255, 0}}),
                             .specular = glm::vec3(0),
                             .shininess = 1,
                             .emissive = glm::vec3(0),
                             .plain_albedo = glm::vec3(reflectance)});
  scene::Mesh mesh;
  for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
    mesh.vertices.push_back({{1000 * corner.x, 1000 * corner.y, -distance}, {0, 0, 1}, {1, 0, 0, 1}, corner});
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  scene.models.push_back({scene::Part{"wall", mesh}});
  scene.instances.push_back({0, glm::mat4(1)});
  PlacedLight lamp;
  lamp.light = {.name = "lamp", .color = {3, 2, 1}, .attenuation = {1, 0, 1}, .threshold = 1e-6, .cone = {}};
  lamp.position = {2, 1, -6};
  scene.lights.push_back(lamp);
  return scene;
}

double mean_light(const render::Picture& picture) {
  double sum = 0;
  for (const float value : picture.rgb) sum += double(value) / double(picture.rgb.size());
  return sum;
}

struct Light {
  double traced, formulas;
};
Light higher_orders_of(const scene::Scene& scene, double visibility, int paths) {
  double drawn[2];
  Light light{};
  for (const render::Scattering scattering : {render::Scattering::single, render::Scattering::all}) {
    render::Renderer renderer(scene, 8, 6,
                              {.fog_lighting = render::FogLighting::airlight, .scattering = scattering, .samples = 1});
    renderer.set_atmosphere(scene.atmosphere.with(Fog::from_visibility(FogMode::exp, visibility)));
    renderer.set_exposure({.ev = render::kMaxExposure});  // nothing is too dim to be drawn
    renderer.draw(render::LightPoints::off);
    drawn[int(scattering)] = mean_light(renderer.draw_in_floats());
    if (scattering == render::Scattering::all) {
      light.traced = mean_light(measure::trace_higher_orders(renderer, {.paths = paths}));
    }
  }
  light.formulas = drawn[1] - drawn[0];
  return light;
}

TEST_F(TracedPicture, InOpenFogIsThatOfTheFormulas) {
  const auto [traced, formulas] = higher_orders_of(wall_ahead(0, 500), 8, 2048);
  fmt::print("traced {:.4g}, by formulas {:.4g}\n", traced, formulas);
  EXPECT_NEAR(traced / formulas, 1, 0.05);
}

// With fewer paths than kinds of them, each seed misses most kinds; their mean misses none.
TEST_F(TracedPicture, FewPathsToManyLampsHaveTheMeanOfMany) {
  scene::Scene scene = wall_ahead(0.5f);
  const PlacedLight lamp = scene.lights[0];
  for (int i = 1; i < 40; ++i) {
    PlacedLight other = lamp;
    other.position += glm::dvec3(0.3 * i, 0.1 * (i % 7), -0.2 * i);
    other.light.color *= 0.1 + 0.02 * (i % 10);
    scene.lights.push_back(other);
  }
  render::Renderer renderer(
      scene, 4, 3,
      {.fog_lighting = render::FogLighting::airlight, .scattering = render::Scattering::all, .samples = 1});
  renderer.set_atmosphere(scene.atmosphere.with(Fog::from_visibility(FogMode::exp, 20)));
  constexpr int kSeeds = 200;
  double few = 0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    few += mean_light(measure::trace_higher_orders(renderer, {.paths = 8, .seed = seed})) / kSeeds;
  }
  const double many = mean_light(measure::trace_higher_orders(renderer, {.paths = 8 * kSeeds}));
  fmt::print("few paths {:.4g}, many {:.4g}\n", few, many);
  EXPECT_NEAR(few / many, 1, 0.03);
}

/// Light that a white wall sends into thin fog of a density and that is scattered to the eye along a ray, by quadrature
/// over the ray and, by distance and turn about the foot of each of its points, over the wall.
double wall_in_fog(const PlacedLight& lamp, double density, const glm::dvec3& direction) {
  constexpr int kSteps = 40, kRings = 60, kTurns = 24;
  const double length = kWall / -direction.z;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const glm::dvec3 point = direction * (length * (i + 0.5) / kSteps);
    const double before = kWall + point.z;
    for (int j = 0; j < kRings; ++j) {  // rings of equal shares of cosine squared: of the wall's flux to the point
      const double cosine = 1 - (j + 0.5) / kRings, radius = before * std::sqrt(1 - cosine * cosine) / cosine;
      for (int k = 0; k < kTurns; ++k) {
        const double turn = 2 * std::numbers::pi * (k + 0.5) / kTurns;
        const glm::dvec3 place(point.x + radius * std::cos(turn), point.y + radius * std::sin(turn), -kWall);
        const glm::dvec3 from_lamp = place - lamp.position;
        const double range = glm::length(from_lamp);
        sum += attenuation_at(lamp.light.attenuation, range) * -from_lamp.z / range / (kRings * kTurns);
      }
    }
  }
  return density * sum * length / kSteps / 2;  // half of all directions are the wall's
}

/// Light that thin fog scatters onto a place on the wall: the airlight of all directions before it, by quadrature in
/// polar coordinates about the direction to the lamp.
double fog_on_wall(const PlacedLight& lamp, const Atmosphere& air, const glm::dvec3& place) {
  constexpr int kAngles = 100, kTurns = 48;
  const glm::dvec3 ahead = glm::normalize(lamp.position - place);
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0, 1, 0))), up = glm::cross(right, ahead);
  double sum = 0;
  for (int i = 0; i < kAngles; ++i) {
    const auto edge = [](int k) { return 1e-4 * std::pow(std::numbers::pi / 1e-4, double(k) / kAngles); };
    const double from = edge(i), to = edge(i + 1), angle = (from + to) / 2;
    for (int k = 0; k < kTurns; ++k) {
      const double turn = 2 * std::numbers::pi * (k + 0.5) / kTurns;
      const glm::dvec3 direction =
          std::cos(angle) * ahead + std::sin(angle) * (std::cos(turn) * right + std::sin(turn) * up);
      if (direction.z <= 0) continue;
      sum += airlight(lamp, air, {.origin = place, .direction = glm::normalize(direction)}) * direction.z *
             std::sin(angle) * (to - from) / 2 / kTurns;
    }
  }
  return sum;
}

// What is scattered or reflected twice in thin fog before a grey wall: fog that lights the wall, and fog that the wall
// lights. What such fog sends back to the wall is some 2 % more.
TEST_F(TracedPicture, WallLightsThinFogBeforeIt) {
  constexpr float kGrey = 0.1f;
  const scene::Scene scene = wall_ahead(kGrey);
  const PlacedLight& lamp = scene.lights[0];
  const double visibility = 40'000;
  const double traced = higher_orders_of(scene, visibility, 512).traced;
  const Atmosphere air = scene.atmosphere.with(Fog::from_visibility(FogMode::exp, visibility));
  const double pixel = 2 * std::tan(scene.camera.field_of_view / 2) / 6;
  double fog = 0, wall = 0;
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) {
      const glm::dvec3 towards(pixel * (x - 3.5), pixel * (2.5 - y), -1);
      fog += wall_in_fog(lamp, air.fog.density, glm::normalize(towards)) / 48;
      wall += fog_on_wall(lamp, air, kWall * towards) / 48;
    }
  }
  const double truth = 2 * double(kGrey) * (fog + wall);  // 2 is the mean of the lamp's colour
  fmt::print("traced {:.4g}, by quadrature {:.4g}, of which the wall lights {:.4g}\n", traced, truth,
             2 * double(kGrey) * fog);
  EXPECT_NEAR(traced / truth, 1, 0.05);
  EXPECT_LT(higher_orders_of(wall_ahead(0), visibility, 512).traced, 0.1 * traced);
}

TEST_F(TracedPicture, RefusesWhatItDoesNotFollow) {
  const auto message_of = [](const scene::Scene& scene, const measure::Tracing& tracing,
                             render::Scattering scattering = render::Scattering::all) {
    render::Renderer renderer(scene, 4, 4, {.fog_lighting = render::FogLighting::airlight, .scattering = scattering});
    try {
      measure::trace_higher_orders(renderer, tracing);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message_of(wall_ahead(0), {.paths = 0}), "paths = 0: must be at least 1");
  EXPECT_EQ(message_of(wall_ahead(0), {}, render::Scattering::single),
            "settings: must light fog by airlight, in all orders of scattering");
  EXPECT_EQ(message_of(scene::read_scene(scene::bundled_scene_path("cookies")), {}),
            "scene: must have no lamps with cookies");
}

}  // namespace
}  // namespace litfog::test
