// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace litfog::window {

/// The resolution of pictures while a view moves, so that a slow rasteriser keeps up: a picture's sides are divided by
/// a whole number. When nothing has changed for a while, one picture is drawn at full size.
class DrawingPace {
 public:
  static constexpr int kCoarsest = 8;
  static constexpr double kTarget = 80;       ///< milliseconds per picture of a moving view
  static constexpr double kStillAfter = 250;  ///< milliseconds after which a view is still

  int divisor() const { return divisor_; }  ///< 1 to kCoarsest

  /// Learns from a picture's time at a divisor. Assumes that time is proportional to the number of pixels.
  void learn(int divisor, double milliseconds);

 private:
  int divisor_ = 4;
};

}  // namespace litfog::window
