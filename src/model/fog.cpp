// SPDX-License-Identifier: Apache-2.0
#include "litfog/fog.h"

#include <cmath>

#include "litfog/formulas.h"
#include "require.h"
#include "unchecked.h"

namespace litfog {
namespace {

/// Optical depth d r or (d r)^2; 0 at range 0 in total fog and at any range in clear air, where the product is no
/// value.
double optical_depth(const Fog& fog, double range) {
  if (fog.density == 0 || range == 0) return 0;
  return fog.mode == FogMode::exp ? formulas::depth_exp(range, fog.density) : formulas::depth_exp2(range, fog.density);
}

/// Density times visibility.
double depth_of_visibility(FogMode mode, double contrast) {
  if (!(contrast > 0 && contrast < 1)) require(ValueError{"contrast", contrast, "must be in (0, 1)"});
  const double depth = -std::log(contrast);
  return mode == FogMode::exp ? depth : std::sqrt(depth);
}

}  // namespace

const char* name_of(FogMode mode) { return mode == FogMode::exp ? "exp" : "exp2"; }

template <typename Real>
BasicFog<Real> BasicFog<Real>::from_visibility(FogMode mode, Real metres, Real contrast) {
  if (!(metres >= 0)) require(ValueError{"visibility", metres, "must be >= 0"});
  return {mode, Real(depth_of_visibility(mode, contrast) / std::abs(double(metres)))};  // -0 is 0
}

template struct BasicFog<double>;
template struct BasicFog<float>;

std::optional<ValueError> find_error(const Fog& fog) {
  if (!(fog.density >= 0)) return ValueError{"fog.density", fog.density, "must be >= 0"};
  return std::nullopt;
}

double visibility(const Fog& fog, double contrast) {
  require(find_error(fog));
  return depth_of_visibility(fog.mode, contrast) / std::abs(fog.density);  // -0 is clear air
}

Fog unchecked::scaled(const Fog& fog, double density_scale) {
  return {fog.mode, density_scale == 0 ? 0 : fog.density * density_scale};  // infinity * 0 is no value
}

Fog scaled(const Fog& fog, double density_scale) {
  require(find_error(fog));
  if (!is_finite_and_not_negative(density_scale)) {
    require(ValueError{"density_scale", density_scale, "must be finite and >= 0"});
  }
  return unchecked::scaled(fog, density_scale);
}

double fog_factor_at(const Fog& fog, double range) { return std::exp(-optical_depth(fog, range)); }

double opacity_at(const Fog& fog, double range) { return formulas::opacity(optical_depth(fog, range)); }

}  // namespace litfog
