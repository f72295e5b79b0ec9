// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/result.h"

namespace litfog::bench {

/// Light that endless uniform fog of albedo 1 scatters from a point lamp to the eye twice and more often, by
/// measure::RadialScattering: M / (I d^2) in the unit of airlight(), for the law a(r) = I / r^2 in fog of density d. It
/// depends on the phase function, the depth tau from eye to lamp and the angle between the ray and the direction to the
/// lamp. A row has all angles of a phase function and a depth. Columns:
///
/// phase                hg or droplets
/// parameter            g, or micrometres
/// tau                  depth
/// 0.2 deg ... 180 deg  M / (I d^2) at an angle, five digits
/// max_error            largest relative error in the row: the change of a number when a third of the nodes is left out
///
/// quick  fewer phase functions and nodes
Result tabulate_scattering(bool quick);

}  // namespace litfog::bench
