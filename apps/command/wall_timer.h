// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace litfog::command {

/// Wall time since construction.
class WallTimer {
 public:
  double milliseconds() const { return std::chrono::duration<double, std::milli>(Clock::now() - begin_).count(); }
  double seconds() const { return 1e-3 * milliseconds(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace litfog::command
