// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "litfog/batch.h"
#include "litfog/solve.h"

namespace litfog::bench {

/// The fog colour intensity by a general minimiser of one variable, a plain use of Boost.Math's brent_find_minima over
/// [0, extent]: to 26 bits, the most that its documentation recommends for double; also tries the extent itself.
/// Arguments as for solve_fog_intensity, unchecked.
double brent_intensity(const Attenuation& attenuation, const Fog& fog, double threshold);

/// Sampling (Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs", section "Lighting in Fog") as fast
/// as possible, for a fair comparison: a vector of lights at a time on the widest SIMD target, and no exponential per
/// sample. Opacities at equidistant ranges follow from each other: with p = 1 - e^(-d h), opacity(r + h) = opacity(r) +
/// (1 - opacity(r)) p, which only adds and so cancels nothing; in exp2 fog p follows in the same way.
///
/// lights     finite extents > 0; full columns, at least 64 lights
/// intensity  sample_fog_intensity of each light, except for rounding
void sample_fog_intensities(FogMode mode, const BatchLightsF& lights, int samples, std::span<float> intensity);

}  // namespace litfog::bench
