// SPDX-License-Identifier: Apache-2.0
#include "render/light/light_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "gl/gl_test.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace litfog::test {
using namespace scene;
using namespace render;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kCandela = 3000;

/// A lamp alone in the dark.
Scene lamp_at(const glm::dvec3& position, double source_radius) {
  Scene scene;
  scene.camera = {.position = {0, 2, 0}, .target = {0, 2, -10}, .field_of_view = 1.0f};
  PlacedLight lamp;
  lamp.light.color = {1, 0.5, 0.25};
  lamp.light.attenuation = {1, 0, kWhiteLux / kCandela};
  lamp.light.source_radius = source_radius;
  lamp.position = scene.camera.position + position;
  scene.lights.push_back(lamp);
  return scene;
}

/// The sum of the values that a lamp's point adds to a picture's pixels, each times the pixel's solid angle; green.
double sum_of_point(const Scene& scene, const Fog& fog, int width, int height, int samples = 4) {
  Renderer renderer(scene, width, height, {.fog_lighting = FogLighting::airlight, .samples = samples});
  renderer.set_atmosphere(scene.atmosphere.with(fog));
  renderer.set_exposure({.ev = 6});
  const auto drawn = [&](LightPoints points) {
    renderer.draw(points);
    Picture picture = renderer.read();
    return is_cut_off(picture) ? renderer.draw_in_floats() : picture;
  };
  const Picture with = drawn(LightPoints::on);
  const Picture without = drawn(LightPoints::off);
  const double pixel = 2 * std::tan(double(scene.camera.field_of_view) / 2) / height;
  double sum = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t green = 3 * (std::size_t(y) * std::size_t(width) + std::size_t(x)) + 1;
      const double square =
          std::pow(pixel, 2) * (std::pow(x + 0.5 - width / 2., 2) + std::pow(y + 0.5 - height / 2., 2));
      sum += double(with.rgb[green] - without.rgb[green]) * pixel * pixel * std::pow(1 + square, -1.5);
    }
  }
  return sum;
}

/// pi E of the lamp's green at a range, in the unit of colours.
double expected_sum(const Fog& fog, double range) {
  return std::numbers::pi * 0.5 * kCandela / kWhiteLux / (range * range) * fog_factor_at(fog, range);
}

class LampDisc : public GlTest {};

TEST_F(LampDisc, PixelsSumUpToAllardsLaw) {
  for (const double range : {8.0, 20.0, 80.0, 400.0, 1500.0}) {
    for (const double visibility : {kInfinity, 2000.0, 500.0, 150.0}) {
      const Fog fog = Fog::from_visibility(FogMode::exp, visibility);
      if (fog_factor_at(fog, range) < 1e-3) continue;
      for (const int height : {120, 300}) {
        const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -0.2, -1));
        const double sum = sum_of_point(lamp_at(range * direction, 0.05), fog, height * 3 / 2, height);
        EXPECT_NEAR(sum / expected_sum(fog, range), 1, 0.02) << range << " m, visibility " << visibility;
      }
    }
  }
}

TEST_F(LampDisc, DiscOf30PixelsHasTheSameSum) {
  const double range = 20;
  const int height = 300;
  const double radius = 30 * range * 2 * std::tan(0.5) / height;
  const double sum = sum_of_point(lamp_at({0, 0, -range}, radius), {}, 400, height);
  const double nearby = range * range / (range * range + radius * radius);
  EXPECT_NEAR(sum / (expected_sum({}, range) * nearby), 1, 0.02);
}

TEST_F(LampDisc, MovingByPartsOfAPixelKeepsTheSum) {
  double least = kInfinity, most = 0;
  for (int i = 0; i < 12; ++i) {
    const double along = 100 * 2 * std::tan(0.5) / 100 * i / 12;  // a pixel in all
    const double sum = sum_of_point(lamp_at({along, 0.7 * along, -100}, 0.05), {}, 150, 100, i % 2 == 0 ? 4 : 1);
    least = std::min(least, sum);
    most = std::max(most, sum);
  }
  EXPECT_LE(most / least, 1.01);
}

}  // namespace
}  // namespace litfog::test
