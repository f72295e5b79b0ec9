// SPDX-License-Identifier: Apache-2.0
// What skipping leaves out changes no pixel of the display by more than a step.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gl/gl_test.h"
#include "reference/srgb.h"
#include "render/display.h"
#include "render/hidden_range.h"
#include "render/renderer.h"
#include "scene/file/scene_file.h"

namespace litfog::test {
using namespace scene;
using namespace render;

namespace {

constexpr int kWidth = 48;
constexpr int kHeight = 27;
constexpr double kClear = std::numeric_limits<double>::infinity();

/// A scene drawn with and without skipping.
class Pair {
 public:
  Pair(const Scene& scene, FogLighting fog_lighting, int width = kWidth, int height = kHeight)
      : skipping_(scene, width, height, {.fog_lighting = fog_lighting}),
        whole_(scene, width, height, {.skipping = Skipping::off, .fog_lighting = fog_lighting}) {}

  void set_fog(const Fog& fog) {
    skipping_.set_fog(fog);
    whole_.set_fog(fog);
  }
  void set_exposure(double ev) {
    skipping_.set_exposure(ev);
    exposure_ = ev;
  }

  /// What skipping changes, in steps of the display: a value a channel.
  std::vector<double> changes() {
    counts = skipping_.draw();
    whole_.draw();
    const Picture skipped = skipping_.read();
    const Picture whole = whole_.read();
    std::vector<double> changes;
    for (const ToneCurve tone : {ToneCurve::neutral, ToneCurve::clip}) {
      const Display display{.exposure = {.ev = exposure_}, .tone = tone};
      const Picture a = displayed(skipped, display);
      const Picture b = displayed(whole, display);
      for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        changes.push_back(255 * (srgb_from_linear(double(a.rgb[i])) - srgb_from_linear(double(b.rgb[i]))));
      }
    }
    return changes;
  }

  FrameCounts counts;

 private:
  Renderer skipping_;
  Renderer whole_;
  double exposure_ = 0;
};

double largest(const std::vector<double>& changes) {
  double largest = 0;
  for (const double change : changes) largest = std::max(largest, std::abs(change));
  return largest;
}

class SkippingTest : public test::GlTest {};

TEST_F(SkippingTest, NoPixelOfAnySceneChangesByAStepInAnyFog) {
  struct Weather {
    FogMode mode;
    double visibility;
  };
  double worst = 0;
  for (const std::string& name : bundled_scenes()) {
    const Scene scene = read_scene(bundled_scene_path(name));
    for (const FogLighting lighting : {FogLighting::airlight, FogLighting::peak}) {
      Pair pair(scene, lighting);
      for (const auto& [mode, visibility] : {Weather{FogMode::exp, kClear},
                                             {FogMode::exp2, 400},
                                             {FogMode::exp, 120},
                                             {FogMode::exp2, 50},
                                             {FogMode::exp, 25},
                                             {FogMode::exp2, 10}}) {
        pair.set_fog(Fog::from_visibility(mode, visibility));
        const double change = largest(pair.changes());
        EXPECT_LE(change, 1) << name << " at " << visibility << " m by " << (lighting == FogLighting::peak);
        worst = std::max(worst, change);
      }
    }
  }
  std::printf("largest change by skipping: %.2f steps\n", worst);
  EXPECT_GT(worst, 0);  // something is left out
}

}  // namespace
}  // namespace litfog::test
