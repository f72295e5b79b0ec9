// SPDX-License-Identifier: Apache-2.0
#include "window/drawing_pace.h"

#include <algorithm>
#include <cmath>

namespace litfog::window {

void DrawingPace::learn(int divisor, double milliseconds) {
  const double wanted = divisor * std::sqrt(std::max(milliseconds, 0.0) / kTarget);
  // One step finer only with time to spare: times vary, and a picture that changes its sharpness flickers.
  const bool has_room = wanted < 0.8 * (divisor_ - 1);
  const int coarser = std::clamp(int(std::ceil(wanted)), 1, kCoarsest);
  if (coarser > divisor_)
    divisor_ = coarser;
  else if (has_room)
    --divisor_;
}

}  // namespace litfog::window
