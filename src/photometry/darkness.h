// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <numbers>

#include "litfog/photometry/intensity_distribution.h"
#include "photometry/pole_coordinates.h"

namespace litfog {

/// Whether any intensity at a vertical angle, given by its index, is above 0.
bool is_row_lit(const IntensityDistribution& distribution, std::size_t vertical);

/// The directions outside a distribution's lit angles: most directions, for a narrow beam.
class Darkness {
 public:
  explicit Darkness(const IntensityDistribution& distribution);

  /// True only where intensity_at() is 0. Needs neither inverse trigonometric functions nor branches.
  bool holds(const PoleCoordinates& unit) const {
    constexpr double kMargin = 1e-6;  // above the tolerance of measured angles
    const auto [pole, ahead, aside] = unit;
    const bool is_below = low_ahead_ * ahead - low_aside_ * aside > kMargin;  // within half a turn
    const bool is_above = high_ahead_ * ahead - high_aside_ * aside > kMargin;
    const bool is_turned_off = is_wide_ ? is_below & is_above : is_below | is_above;
    return is_turned_off | (pole < least_pole_ - kMargin) | (pole > most_pole_ + kMargin);
  }

 private:
  double least_pole_, most_pole_;
  double low_ahead_ = 0, low_aside_ = 0;  // 0 for type C: no turn is below
  double high_ahead_ = 0, high_aside_ = 0;
  bool is_wide_ = false;  // the lit turn is more than a half
};

/// Step from a beam's last lit angle to the dark beyond it in a table or profile, radians: 0.01 degrees.
inline constexpr double kDarkEdge = std::numbers::pi / 18000;

}  // namespace litfog
