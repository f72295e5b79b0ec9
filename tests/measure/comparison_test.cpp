// SPDX-License-Identifier: Apache-2.0
#include "measure/picture_error.h"

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
  renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp, 2000.0)));
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

// A picture that is exposed shows more of the error, one for a dark display less.
TEST_F(ComparisonTest, ErrorIsInStepsOfThePictureAsShown) {
  const Scene scene = read_scene(bundled_scene_path("room"));
  Renderer renderer(scene, 16, 9, {});
  renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp, 20.0)));
  for (const double ev : {4.0, -6.0}) {
    SCOPED_TRACE(ev);
    renderer.set_exposure({.ev = ev});
    renderer.draw(LightPoints::off);
    const Picture frame = renderer.read();
    const Comparison comparison = compare_with_reference(renderer);
    EXPECT_EQ(renderer.exposure(), ev);
    EXPECT_LE(comparison.error.largest, 1);
    const std::vector<std::uint8_t> no_jumps(comparison.error.pixels.size());
    const ReferencePicture reference{comparison.reference, comparison.reference, comparison.reference, no_jumps};
    EXPECT_EQ(picture_error(frame, reference, ev).largest, comparison.error.largest);
    EXPECT_NE(picture_error(frame, reference).largest, comparison.error.largest);
  }
}

}  // namespace

}  // namespace litfog::test
