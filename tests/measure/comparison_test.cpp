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

// The error is that of the shading: with the points of a thousand lamps in both pictures it stays as small.
TEST_F(ComparisonTest, BothPicturesShowTheLampsPointsAndTheErrorDoesNot) {
  const Scene scene = read_scene(bundled_scene_path("approach"));
  const Fog fog = Fog::from_visibility(FogMode::exp, 2000.0);
  Renderer renderer(scene, 64, 36, {});
  renderer.set_fog(fog);
  renderer.draw();
  const Picture with_points = renderer.read();
  const Comparison comparison = compare_with_reference(renderer);
  EXPECT_EQ(comparison.drawn.rgb, with_points.rgb);
  EXPECT_LT(comparison.error.largest, 1);
  renderer.draw(LightPoints::off);
  const Picture without_points = renderer.read();
  double brightest_point = 0;
  for (std::size_t i = 0; i < with_points.rgb.size(); ++i) {
    brightest_point = std::max(brightest_point, double(with_points.rgb[i] - without_points.rgb[i]));
    // A step on the display is at most 2.4 / 1.055 / 255 of light, the slope of sRGB at white.
    EXPECT_NEAR(comparison.reference.rgb[i], with_points.rgb[i], comparison.error.largest * 2.4 / 1.055 / 255) << i;
  }
  EXPECT_GT(brightest_point, 0.1);
}

}  // namespace

}  // namespace litfog::test
