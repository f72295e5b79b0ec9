// SPDX-License-Identifier: Apache-2.0
#include "measure/frame_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <chrono>

#include "measure/quantile.h"

namespace litfog::measure {

double FrameTimes::median() const { return quantile(milliseconds, 0.5); }

double FrameTimes::spread() const { return quantile(milliseconds, 0.9) - quantile(milliseconds, 0.1); }

std::string milliseconds_text(double milliseconds) {
  int decimals = 0;
  for (double least = 99.95; milliseconds < least && decimals < 6; least /= 10) ++decimals;
  return fmt::format("{:.{}f}", milliseconds, decimals);
}

DrawFrame frames_of(render::Renderer& renderer) {
  return [&renderer] { return renderer.draw(); };
}

std::vector<FrameTimes> time_frames(const std::vector<DrawFrame>& renderers, const FrameBudget& budget,
                                    const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  assert(budget.fewest >= 1 && budget.fewest <= budget.most);
  std::vector<FrameTimes> times(renderers.size());
  Clock::time_point first_timed;
  const auto is_enough = [&](int timed) {
    if (timed < budget.fewest) return false;
    return timed == budget.most || Clock::now() - first_timed >= std::chrono::duration<double>(budget.seconds);
  };
  const int untimed = renderers.size() > 1 ? 2 : 1;
  for (int timed = -untimed; !is_enough(timed); ++timed) {
    if (timed == 0) first_timed = Clock::now();
    for (std::size_t i = 0; i < renderers.size(); ++i) {
      if (progress) {
        std::string step = timed < 0          ? std::string(kCompiling)
                           : budget.most == 1 ? "drawing"
                                              : fmt::format("timing frame {}", timed + 1);
        if (renderers.size() > 1) step += fmt::format(", {} of {}", i + 1, renderers.size());
        progress(step);
      }
      const auto start = Clock::now();
      times[i].counts = renderers[i]();
      const std::chrono::duration<double, std::milli> taken = Clock::now() - start;
      if (timed >= 0) times[i].milliseconds.push_back(taken.count());
    }
  }
  for (FrameTimes& each : times) std::ranges::sort(each.milliseconds);
  return times;
}

std::vector<FrameTimes> time_frames(const std::vector<std::unique_ptr<render::Renderer>>& renderers,
                                    const FrameBudget& budget, const Progress& progress) {
  std::vector<DrawFrame> draws;
  for (const auto& renderer : renderers) draws.push_back(frames_of(*renderer));
  return time_frames(draws, budget, progress);
}

}  // namespace litfog::measure
