// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "renderer.h"

namespace litfog::demo {

/// Wall times of a renderer's frames, each drawn and waited for.
struct FrameTimes {
  std::vector<double> milliseconds = {};  ///< ascending, not empty
  FrameCounts counts = {};                ///< of each frame

  double median() const;
  double spread() const;  ///< from the 10th to the 90th percentile
};

/// Draws and times frames, one of each renderer in turn, so that a slow spell of the machine hits none alone; before
/// them one of each that is not timed, for drivers compile shaders when they are first drawn with. The renderers show
/// their last frame.
///
/// renderers  of the current GL context
/// frames     of each, >= 1
/// returns    the renderers' times, in their order
std::vector<FrameTimes> time_frames(const std::vector<Renderer*>& renderers, int frames);

}  // namespace litfog::demo
