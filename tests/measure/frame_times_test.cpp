// SPDX-License-Identifier: Apache-2.0
#include "measure/frame_times.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "gl/gl_test.h"
#include "scene/file/scene_file.h"

namespace litfog::test {
using namespace render;
using namespace scene;
using namespace measure;

namespace {

TEST(FrameTimes, SpreadIsFromTheTenthToTheNinetiethPercentile) {
  const FrameTimes times{.milliseconds = {10, 20, 30, 40, 50}};
  EXPECT_EQ(times.median(), 30);
  EXPECT_DOUBLE_EQ(times.spread(), 46 - 14);
}

TEST(FrameTimes, FrameTimesAreWrittenWithThreeDigits) {
  EXPECT_EQ(milliseconds_text(0.01234), "0.0123");
  EXPECT_EQ(milliseconds_text(9.994), "9.99");
  EXPECT_EQ(milliseconds_text(9.996), "10.0");
  EXPECT_EQ(milliseconds_text(99.96), "100");
  EXPECT_EQ(milliseconds_text(1234.5), "1234");
}

class FrameTimesTest : public test::GlTest {};

TEST_F(FrameTimesTest, EachRendererHasItsTimesInAscendingOrderAndItsCounts) {
  const Scene scene = read_scene(bundled_scene_path("headlights"));
  Renderer skipping(scene, 32, 18, {});
  Renderer drawing_all(scene, 32, 18, {.skipping = Skipping::off});
  const std::vector<FrameTimes> times =
      time_frames({frames_of(skipping), frames_of(drawing_all)}, FrameBudget::exactly(3));
  ASSERT_EQ(times.size(), 2u);
  for (const FrameTimes& each : times) {
    EXPECT_EQ(each.milliseconds.size(), 3u);
    EXPECT_TRUE(std::ranges::is_sorted(each.milliseconds));
    EXPECT_GT(each.milliseconds.front(), 0);
  }
  EXPECT_GT(times[0].counts.chunks_outside_view, 0u);
  EXPECT_EQ(times[1].counts.chunks_outside_view, 0u);
}

TEST_F(FrameTimesTest, BudgetOfNoTimeTakesTheFewestFramesAndAnEndlessOneTheMost) {
  const Scene scene = read_scene(bundled_scene_path("room"));
  Renderer renderer(scene, 32, 18, {});
  const auto frames = [&](const FrameBudget& budget) {
    return time_frames({frames_of(renderer)}, budget).front().milliseconds.size();
  };
  EXPECT_EQ(frames({.seconds = 0, .fewest = 2, .most = 9}), 2u);
  EXPECT_EQ(frames({.seconds = 1e9, .fewest = 2, .most = 5}), 5u);
  std::vector<std::string> steps;
  time_frames({frames_of(renderer)}, FrameBudget::exactly(1), [&](std::string_view step) { steps.emplace_back(step); });
  EXPECT_EQ(steps, (std::vector<std::string>{"compiling shaders", "drawing"}));
}

}  // namespace

}  // namespace litfog::test
