// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "gl/gl_test.h"
#include "reference/srgb.h"
#include "render/display.h"
#include "render/renderer.h"
#include "scene/file/scene_file.h"

namespace litfog::test {
using namespace scene;
using namespace render;

namespace {

class AirlightPyramidTest : public test::GlTest {};

/// Largest difference between two pictures on a display, in steps.
double largest_difference(const Picture& a, const Picture& b, double exposure) {
  double largest = 0;
  for (const ToneCurve tone : {ToneCurve::neutral, ToneCurve::clip}) {
    const Picture shown_a = displayed(a, {.exposure = {.ev = exposure}, .tone = tone});
    const Picture shown_b = displayed(b, {.exposure = {.ev = exposure}, .tone = tone});
    for (std::size_t i = 0; i < shown_a.rgb.size(); ++i) {
      largest = std::max(
          largest, 255 * std::abs(srgb_from_linear(double(shown_a.rgb[i])) - srgb_from_linear(double(shown_b.rgb[i]))));
    }
  }
  return largest;
}

// Airlight as for the largest exposure has every lamp at every pixel. All that other exposures leave out of all lamps
// together and what their grids err make less than a step of the display.
TEST_F(AirlightPyramidTest, ErrorsOfAllLampsTogetherStayBelowAStepAtEveryExposure) {
  struct Case {
    std::string scene;
    double visibility;
    int width, height;
  };
  for (const auto& [name, visibility, width, height] :
       {Case{"headlights", 50, 96, 54}, Case{"street", 400, 96, 54}, Case{"approach", 400, 48, 27}}) {
    const Scene scene = read_scene(bundled_scene_path(name));
    Renderer renderer(scene, width, height,
                      {.skipping = Skipping::off, .fog_lighting = FogLighting::airlight, .samples = 1});
    renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp, visibility)));
    std::size_t drawn_before = scene.lights.size();
    for (const double exposure : {6.0, 0.0, -6.0}) {
      renderer.set_exposure({.ev = exposure});
      const std::size_t drawn = renderer.draw(LightPoints::off).airlights_drawn;
      const Picture picture = renderer.read();
      const FrameExposures every_lamp{.surfaces = exposure, .airlight = kMaxExposure};
      EXPECT_GE(renderer.draw_for(every_lamp, LightPoints::off).airlights_drawn, drawn)
          << name << " at " << exposure << " EV";
      const double difference = largest_difference(picture, renderer.read(), exposure);
      std::printf("%s at %g EV: %zu lamps, largest error %.2f steps\n", name.c_str(), exposure, drawn, difference);
      EXPECT_LE(difference, 1) << name << " at " << exposure << " EV";
      EXPECT_LE(drawn, drawn_before) << name << " at " << exposure << " EV";
      drawn_before = drawn;
    }
  }
}

}  // namespace
}  // namespace litfog::test
