// SPDX-License-Identifier: Apache-2.0
#include "bench/plain_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

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

template <typename AnyRenderer>
Picture draw(AnyRenderer& renderer, const Atmosphere& atmosphere) {
  renderer.set_atmosphere(atmosphere);
  renderer.draw();
  return renderer.read();
}

/// As a display shows them: what is brighter than white is white.
double difference(float a, float b) { return std::abs(std::min(double(a), 1.0) - std::min(double(b), 1.0)); }

/// Indices of the values that differ by more than a step.
std::vector<std::size_t> differing(const Picture& a, const Picture& b) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    if (difference(a.rgb[i], b.rgb[i]) > kStep) indices.push_back(i);
  }
  return indices;
}

TEST_F(PlainRendererTest, PlainDrawsThePictureOfUnified) {
  for (const std::string& name : bundled_scenes()) {
    Scene scene = bundled(name);
    scene.atmosphere.profile = {};  // plain has no layers
    const double visibility = suggested_visibility(scene);
    // A partly covered pixel is shaded at its centre, which may lie beyond its triangle: unified, but not plain, then
    // takes the nearest position within the surface's bounds. plain_renderer.h states the fraction. Fog only lowers the
    // contrast of edges.
    const std::vector<Fog> every_fog{Fog{}, Fog::from_visibility(FogMode::exp, visibility),
                                     Fog::from_visibility(FogMode::exp2, visibility)};
    for (const auto& [samples, most, fogs] :
         {std::tuple(1, std::size_t{0}, every_fog), {4, std::size_t{3 * kWidth * kHeight} / 300, {Fog{}}}}) {
      PlainRenderer plain(scene, kWidth, kHeight, samples);
      Renderer unified(scene, kWidth, kHeight, {.skipping = Skipping::off, .samples = samples});
      for (const Fog& fog : fogs) {
        const auto beyond =
            differing(draw(plain, scene.atmosphere.with(fog)), draw(unified, scene.atmosphere.with(fog)));
        EXPECT_LE(beyond.size(), most) << name << ", " << samples << " samples, the first value in pixel "
                                       << beyond.front() / 3 % kWidth << ", " << beyond.front() / 3 / kWidth;
      }
    }
  }
}

}  // namespace

}  // namespace litfog::test
