// SPDX-License-Identifier: Apache-2.0
#include "bench/plain_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/light_count.h"
#include "gl/gl_test.h"
#include "render/renderer.h"
#include "scene/file/scene_file.h"

namespace litfog::test {
using namespace bench;
using namespace render;
using namespace scene;

namespace {

constexpr int kWidth = 240;
constexpr int kHeight = 135;
constexpr double kStep = 1.0 / 255;

class PlainRendererTest : public test::GlTest {};

/// A bundled scene, with as many of its lights as plain can draw.
Scene bundled(const std::string& name) {
  Scene scene = read_scene(bundled_scene_path(name));
  const std::size_t lights = std::min(scene.lights.size(), kMaxPlainLights);
  return with_light_count(std::move(scene), lights);
}

Picture draw_plain(const Scene& scene, const Fog& fog, int samples) {
  PlainRenderer renderer(scene, kWidth, kHeight, samples);
  renderer.set_fog(fog);
  renderer.draw();
  return renderer.read();
}

Picture draw_unified(const Scene& scene, const Fog& fog, int samples) {
  Renderer renderer(scene, kWidth, kHeight, {.skipping = Skipping::off, .samples = samples});
  renderer.set_fog(fog);
  renderer.draw();
  return renderer.read();
}

/// As a display shows them: what is brighter than white is white.
double difference(float a, float b) { return std::abs(std::min(double(a), 1.0) - std::min(double(b), 1.0)); }

TEST_F(PlainRendererTest, PlainDrawsThePictureOfUnified) {
  for (const std::string& name : bundled_scenes()) {
    const Scene scene = bundled(name);
    const double visibility = suggested_visibility(scene);
    for (const Fog& fog :
         {Fog::from_visibility(FogMode::exp, visibility), Fog::from_visibility(FogMode::exp2, visibility), Fog{}}) {
      const Picture plain = draw_plain(scene, fog, 1);
      const Picture unified = draw_unified(scene, fog, 1);
      std::size_t worst = 0;
      std::size_t count = 0;
      for (std::size_t i = 0; i < plain.rgb.size(); ++i) {
        if (difference(plain.rgb[i], unified.rgb[i]) > difference(plain.rgb[worst], unified.rgb[worst])) worst = i;
        count += difference(plain.rgb[i], unified.rgb[i]) > kStep;
      }
      EXPECT_LE(difference(plain.rgb[worst], unified.rgb[worst]), kStep)
          << name << ", " << count << " values, pixel " << worst / 3 % kWidth << ", " << worst / 3 / kWidth;
    }
  }
}

}  // namespace

}  // namespace litfog::test
