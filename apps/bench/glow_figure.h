// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/result.h"

namespace litfog::bench {

/// The glow around a point lamp in endless uniform fog, isotropic and of droplets of 10 micrometres, over the angle
/// between ray and lamp: by litfog, its rivals (glow_rival.h), the random walk and, as the reference,
/// measure::RadialScattering. Columns:
///
/// phase            hg or droplets
/// parameter        g, or micrometres
/// tau              depth between lamp and eye
/// angle_deg        angle between the ray and the direction to the lamp
/// method           reference; single: airlight(); all: the same plus multiple_scattering(); apsf-2003 (tau above 1);
///                  gaussian-2004; octaves-2013, in 16 steps; walk: walk_scattering()
/// glow             light over I d^2, for the law a(r) = I / r^2 in fog of density d
/// glow_error       standard error of walk; else empty
/// relative_error   against the reference; that of walk has its chance in it
/// ns_per_ray       processor time of one thread, the median over repetitions, for the mean of the angles; not of walk
///
/// quick  fewer angles, a coarser reference and shorter walks
Result draw_glow(bool quick);

}  // namespace litfog::bench
