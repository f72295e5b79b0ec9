// SPDX-License-Identifier: Apache-2.0
#include "frame_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <chrono>

#include "progress.h"
#include "quantile.h"

namespace litfog::demo {

double FrameTimes::median() const { return quantile(milliseconds, 0.5); }

double FrameTimes::spread() const { return quantile(milliseconds, 0.9) - quantile(milliseconds, 0.1); }

std::vector<FrameTimes> time_frames(const std::vector<Renderer*>& renderers, int frames) {
  assert(frames >= 1);
  std::vector<FrameTimes> times(renderers.size());
  Progress progress;
  for (int frame = 0; frame <= frames; ++frame) {
    progress.show(fmt::format("timing frame {} of {}", std::max(frame, 1), frames));
    for (std::size_t i = 0; i < renderers.size(); ++i) {
      const auto start = std::chrono::steady_clock::now();
      times[i].counts = renderers[i]->draw();
      const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
      if (frame > 0) times[i].milliseconds.push_back(taken.count());
    }
  }
  for (FrameTimes& each : times) std::ranges::sort(each.milliseconds);
  return times;
}

}  // namespace litfog::demo
