// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "measure/progress.h"
#include "render/renderer.h"

namespace litfog::measure {

/// Wall times of a renderer's frames, each waited for.
struct FrameTimes {
  std::vector<double> milliseconds = {};  ///< ascending, not empty
  render::FrameCounts counts = {};        ///< each frame's

  double median() const;
  double spread() const;  ///< from the 10th to the 90th percentile
};

/// "0.0987", "9.87", "41.2", "1234": milliseconds with three significant digits, or all integer digits.
std::string milliseconds_text(double milliseconds);

/// The number of frames to time: until `seconds` have passed, but at least `fewest` and at most `most`, both >= 1.
struct FrameBudget {
  double seconds;
  int fewest;
  int most;

  static FrameBudget exactly(int frames) { return {.seconds = 0, .fewest = frames, .most = frames}; }
};

/// Draws a frame and waits for it.
using DrawFrame = std::function<render::FrameCounts()>;
DrawFrame frames_of(render::Renderer& renderer);

/// Draws and times frames, the renderers' interleaved, so that a slow phase of the machine hits all of them. The first
/// frame of each is not timed, because drivers compile a shader at its first draw call. With several renderers the
/// second frame is not timed either, because drivers compile again where another renderer has changed GL state.
///
/// renderers  all in the current GL context; they hold their last frame afterwards
/// budget     for all renderers together; each draws the same number of frames
/// progress   called before each frame
/// returns    the renderers' times, in their order
std::vector<FrameTimes> time_frames(const std::vector<DrawFrame>& renderers, const FrameBudget& budget,
                                    const Progress& progress = {});
std::vector<FrameTimes> time_frames(const std::vector<std::unique_ptr<render::Renderer>>& renderers,
                                    const FrameBudget& budget, const Progress& progress = {});

}  // namespace litfog::measure
