// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "fit/light_fit.h"

namespace litfog::fit {

/// What the data state of a beam, whatever was fitted to it.
struct BeamData {
  std::optional<double> peak;  ///< candela
  std::optional<double> flux;  ///< lumens
  /// Full angles at 50 % and 10 % of the peak, radians: none where it is not known, one of a round beam, else two, in
  /// the light's horizontal and vertical planes.
  std::vector<double> beam_angle;
  std::vector<double> field_angle;
};

/// A luminaire's data, else the angles that a spec states or its samples have.
BeamData beam_data(const LightFit& fit);

/// The same of the light as it is written. A cookie has its beam's angles, a point light has none.
BeamData light_beam(const LightFit& fit);

}  // namespace litfog::fit
