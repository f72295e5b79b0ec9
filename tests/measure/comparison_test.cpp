// SPDX-License-Identifier: Apache-2.0
#include "measure/comparison.h"

#include <algorithm>

#include "gl/gl_test.h"
#include "scene/file/scene_file.h"

namespace litfog::test {
using namespace render;
using namespace scene;
using namespace measure;

namespace {

class ComparisonTest : public test::GlTest {};

TEST_F(ComparisonTest, LampsPointsAreInTheFrameButNeitherInTheReferenceNorInTheError) {
  const Scene scene = read_scene(bundled_scene_path("approach"));
  Renderer renderer(scene, 64, 36, {});
  renderer.set_fog(Fog::from_visibility(FogMode::exp, 2000.0));
  renderer.draw();
  const Picture with_points = renderer.read();
  const Comparison comparison = compare_with_reference(renderer);
  EXPECT_EQ(comparison.drawn.rgb, with_points.rgb);
  EXPECT_LT(comparison.error.largest, 0.25);
  renderer.draw(LightPoints::off);
  const Picture without_points = renderer.read();
  double brightest_point = 0;
  for (std::size_t i = 0; i < with_points.rgb.size(); ++i) {
    brightest_point = std::max(brightest_point, double(with_points.rgb[i] - without_points.rgb[i]));
    // A step on the display is at most 2.4 / 1.055 / 255 of light, the slope of sRGB at white.
    ASSERT_NEAR(comparison.reference.rgb[i], without_points.rgb[i], 0.25 * 2.4 / 1.055 / 255) << i;
  }
  EXPECT_GT(brightest_point, 0.1);
}

// A frame for a dark picture leaves out much of what a step at 0 EV is.
TEST_F(ComparisonTest, ErrorDoesNotDependOnTheExposureOfTheFrame) {
  const Scene scene = read_scene(bundled_scene_path("approach"));
  Renderer renderer(scene, 64, 36, {});
  renderer.set_fog(Fog::from_visibility(FogMode::exp, 2000.0));
  renderer.draw();
  const Comparison expected = compare_with_reference(renderer);
  renderer.set_exposure({.ev = -10});
  renderer.draw();
  const Comparison comparison = compare_with_reference(renderer);
  EXPECT_NE(comparison.drawn.rgb, expected.drawn.rgb);
  EXPECT_EQ(comparison.error.pixels, expected.error.pixels);
}

}  // namespace

}  // namespace litfog::test
