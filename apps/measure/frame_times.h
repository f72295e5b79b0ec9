// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/renderer.h"

namespace litfog::measure {

/// Wall times of a renderer's frames, each drawn and waited for.
struct FrameTimes {
  std::vector<double> milliseconds = {};  ///< ascending, not empty
  render::FrameCounts counts = {};        ///< of each frame

  double median() const;
  double spread() const;  ///< from the 10th to the 90th percentile
};

/// "0.0987", "9.87", "41.2", "1234": milliseconds with three digits, or all before the point.
std::string milliseconds_text(double milliseconds);

/// How many frames to time: until so many seconds have gone, but not fewer and not more than so many, both >= 1.
struct FrameBudget {
  double seconds;
  int fewest;
  int most;

  static FrameBudget exactly(int frames) { return {.seconds = 0, .fewest = frames, .most = frames}; }
};

/// Draws and times frames, one of each renderer in turn, so that a slow spell of the machine hits none alone; before
/// them one of each that is not timed, for drivers compile shaders when they are first drawn with. The renderers show
/// their last frame.
///
/// renderers  of the current GL context
/// budget     for all renderers together; their numbers of frames are equal
/// what       is timed, for the progress shown
/// returns    the renderers' times, in their order
std::vector<FrameTimes> time_frames(const std::vector<render::Renderer*>& renderers, const FrameBudget& budget,
                                    std::string_view what);

}  // namespace litfog::measure
