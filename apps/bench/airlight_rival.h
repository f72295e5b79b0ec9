// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reference/random_airlight.h"

namespace litfog::bench {

/// The airlight along a ray as others compute it, in double. Arguments as for airlight(), unchecked.

/// Equal steps from the eye to the ray's end, or to where the transmittance is 1e-4. A step adds the light at its
/// middle times the exact extinction over the step (Sébastien Hillaire 2015, "Physically Based and Unified Volumetric
/// Rendering in Frostbite").
double march_airlight(const test::AirlightCase& c, int steps);

/// Marches only the part of the ray inside the lamp's sphere and, for a beam narrower than a half space, its cone:
/// PlayCanvas 2.22's volumetric fog of local lights (github.com/playcanvas/engine/pull/9137), by default in 12 steps.
double march_lit_airlight(const test::AirlightCase& c, int steps);

/// Miles Macklin 2010, "In-Scattering Demo", as engines copy it: no extinction, neither to the eye nor from the lamp.
/// For an inverse-square point lamp in isotropic exp fog, outside of its knee.
double arctangent_airlight(const test::AirlightCase& c);

/// Vincent Pegoraro and Steven Parker 2009, "An Analytical Solution to Single Scattering in Homogeneous Participating
/// Media": the integral in closed form, by the exponential integral of a complex number, in double. For the same lamps;
/// with extinction on the lamp's leg.
double pegoraro_airlight(const test::AirlightCase& c);

/// Bo Sun, Ravi Ramamoorthi, Srinivasa Narasimhan and Shree Nayar 2005, "A Practical Analytic Single Scattering Model
/// for Real Time Rendering": F(u, v), the integral of e^(-u tan x) for x from 0 to v, from a table with linear
/// interpolation, u to 10. For the same lamps; with extinction on the lamp's leg.
class SunTable {
 public:
  SunTable();

  double airlight(const test::AirlightCase& c) const;

 private:
  double at(double u, double v) const;

  std::vector<double> values_;  ///< by u, then v
};

}  // namespace litfog::bench
