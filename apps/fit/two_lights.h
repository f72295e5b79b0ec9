// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fit/light_fit.h"

namespace litfog::fit {

/// Two lights at one place whose cones together follow a beam that has a hot spot and a spill.
struct TwoLights {
  LightFit hot_spot;
  LightFit spill;
  double beam_error;  ///< LightFit::beam_error() of both together
  double flux_error;  ///< both lights' flux over the luminaire's, minus 1
  double peak_error;  ///< both lights' intensity over the luminaire's, minus 1, where the luminaire's is largest
  std::optional<IlluminanceError> illuminance_error;  ///< of both together, where it is stated
  BeamData beam;                                      ///< light_beam() of both together
};

/// The two lights that follow a luminaire's beam best about the fit's axis, by the least squares of intensity over the
/// sphere: the spill is fitted to what lies outside a level of the peak, and the hot spot to what the spill leaves. The
/// level is searched, from 0.3 % to 60 % of the peak. Both end where they give what the one light does at its end.
///
/// returns  nothing of a beam that has no spill, or without a luminaire, or where the range states an extent or a
///          falloff table
std::optional<TwoLights> fit_two_lights(const LightFit& fit);

}  // namespace litfog::fit
