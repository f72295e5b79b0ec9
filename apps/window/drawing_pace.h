// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace litfog::window {

/// How coarsely pictures are drawn while a view moves, so that a slow rasteriser keeps up: a picture's sides are
/// divided by a whole number. When nothing has changed for a while it is drawn once at its full size.
class DrawingPace {
 public:
  static constexpr int kCoarsest = 8;
  static constexpr double kTarget = 80;       ///< milliseconds a picture of a moving view
  static constexpr double kStillAfter = 250;  ///< milliseconds after which a view is still

  int divisor() const { return divisor_; }  ///< 1 to kCoarsest

  /// Learns from a picture: what it took at which divisor. A picture's time is taken to grow with its pixels.
  void learn(int divisor, double milliseconds);

 private:
  int divisor_ = 4;
};

}  // namespace litfog::window
