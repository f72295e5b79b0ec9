// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "litfog/fog.h"
#include "litfog/light.h"
#include "litfog/solve.h"

namespace litfog::window {

/// (1 - f) a and its two factors over a light's range, for a plot.
struct RangeCurve {
  struct Sample {
    double opacity;      ///< 1 - f
    double attenuation;  ///< a
    double product;
  };

  FogIntensity solved;          ///< the peak's height and range, and the extent
  double knee;                  ///< metres; 0: none
  double end;                   ///< end of the plot, metres: > 0, finite
  std::vector<Sample> samples;  ///< at ranges end * i / (size - 1)
};

/// The curve from range 0 to a little beyond the extent; for a light without an end, to four times the peak's range.
///
/// fog      the scene's; the light's density scale applies
/// samples  >= 2
/// throws   std::invalid_argument naming field, value and rule
RangeCurve make_range_curve(const Light& light, const Fog& fog, int samples);

}  // namespace litfog::window
