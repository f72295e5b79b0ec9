// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/result.h"

namespace litfog::bench {

/// The glow around a point lamp in endless uniform fog, isotropic and of droplets of 10 micrometres: light scattered
/// once and all of it by litfog, and all of it by the random walk, over the angle between ray and lamp. Columns:
///
/// phase            hg or droplets
/// parameter        g, or micrometres
/// tau              depth between lamp and eye
/// angle_deg        angle between the ray and the direction to the lamp
/// single           airlight() over I d^2, for the law a(r) = I / r^2 in fog of density d
/// all              the same plus multiple_scattering()
/// walk             the same by walk_scattering()
/// walk_error       standard error of walk
/// relative_error   of all against walk, which has its chance in it
///
/// quick  fewer angles and shorter walks
Result draw_glow(bool quick);

}  // namespace litfog::bench
