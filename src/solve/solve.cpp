// SPDX-License-Identifier: Apache-2.0
#include "litfog/solve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/level_range.h"
#include "model/require.h"
#include "model/unchecked.h"
#include "series_solve.h"

namespace litfog {
namespace {

/// Cases that solve_by_series leaves are solved in long double, whose exponent has four bits more.
using Wide = long double;

/// The stationary point is sought in x = d r, where the denominator is C + A x + B x^2.
struct ScaledDenominator {
  Wide constant;
  Wide linear;     // A = L / d
  Wide quadratic;  // B = Q / d^2
};

/// p(u) = e^u - 1 - u; for small u by its series, which does not cancel.
Wide expm1_minus_argument(Wide u) {
  if (u > 0.6875L) return std::exp(u) - 1 - u;
  Wide sum = 1;
  for (int n = 20; n > 2; --n) sum = 1 + sum * u / n;
  return sum * u * u / 2;
}

/// A function that is negative below the stationary point and positive beyond it, with two derivatives.
struct Slope {
  Wide value;
  Wide first;
  Wide second;
};

/// exp fog: D'(x) expm1(x) - D(x). A power series whose only negative coefficient is -C.
Slope slope_exp(const ScaledDenominator& d, Wide x) {
  const Wide p = expm1_minus_argument(x);
  const Wide e1 = x + p;
  const Wide growth = d.linear + 2 * d.quadratic * (1 + x);
  return {(d.linear + 2 * d.quadratic * x) * p + d.quadratic * x * x - d.constant,  //
          e1 * growth,                                                              //
          (e1 + 1) * growth + 2 * d.quadratic * e1};
}

/// exp2 fog: D'(x) expm1(x^2) / (2 x) - D(x). A power series; only -C and the linear term -A x / 2 are negative.
Slope slope_exp2(const ScaledDenominator& d, Wide x) {
  const Wide w = x * x;
  const Wide p = expm1_minus_argument(w);
  const Wide e1 = w + p;
  const Wide half = d.linear / (2 * x);
  const Wide growth = d.linear + 2 * d.quadratic * x - half / x;
  return {(half + d.quadratic) * p - d.linear * x / 2 - d.constant,  //
          e1 * growth,                                               //
          2 * x * (e1 + 1) * growth + 2 * e1 * (d.quadratic + half / w)};
}

/// u with e^u - 1 - u = z within a few percent: right for small and for large z, good between.
Wide guess_depth(Wide z) { return std::log1p(z + std::sqrt(2 * z)); }

Wide guess_stationary_exp(const ScaledDenominator& d) { return guess_depth(d.constant / (d.linear + 2 * d.quadratic)); }

Wide guess_stationary_exp2(const ScaledDenominator& d) {
  const Wide w = guess_depth((2 * d.constant + d.linear) / (d.linear + 2 * d.quadratic));
  if (w > Wide(0.1)) return std::sqrt(w);
  // Small x: B x^4 - A x = 2 C, and the larger of the two one-term roots is near.
  return std::max(std::sqrt(std::sqrt(2 * d.constant / d.quadratic)), std::cbrt(d.linear / d.quadratic));
}

struct Root {
  Wide x;
  SolveStatus status;
};

/// The one sign change of a slope on (0, upper]: Halley from a guess, kept inside the bracket, bisected on escape.
/// A step that moves x by the fraction m leaves an error of about m^3 (1 + x^2 / 12) in exp fog and m^3 (1 + x^4 / 3) in
/// exp2 fog, so that a step below the bound leaves the peak's range good to 1e-9 and its height to the square of that.
template <typename SlopeAt>
Root find_sign_change(const SlopeAt& slope_at, Wide guess, Wide upper) {
  constexpr int kMaxSteps = 100;
  Wide low = 0;
  Wide high = upper;
  Wide x = std::min(guess, upper);
  bool is_close = false;
  for (int step = 0; step < kMaxSteps && !is_close; ++step) {
    const Slope slope = slope_at(x);
    (slope.value < 0 ? low : high) = x;
    const Wide move = 2 * slope.value * slope.first / (2 * slope.first * slope.first - slope.value * slope.second);
    Wide next = x - move;
    if (!(next > low && next < high) && next != x) next = low > 0 ? std::sqrt(low) * std::sqrt(high) : high / 2;
    is_close = std::abs(next - x) * (1 + x * x) <= Wide(1e-3) * x;
    x = next;
  }
  return {x, is_close ? SolveStatus::ok : SolveStatus::not_converged};
}

/// The x = d r at which the derivative of opacity * 1/D vanishes; 0 if it is negative from the start (C = 0).
Root find_stationary_point(const BasicAttenuation<Wide>& attenuation, FogMode mode, Wide density) {
  const ScaledDenominator d{attenuation.constant, attenuation.linear / density,
                            attenuation.quadratic / density / density};
  // Above this depth e^u nears the largest value; the slope is positive there for all coefficients.
  constexpr Wide kMaxDepth = 11000;
  if (mode == FogMode::exp) {
    if (d.constant == 0) return {0, SolveStatus::ok};
    return find_sign_change([&](Wide x) { return slope_exp(d, x); }, guess_stationary_exp(d), kMaxDepth);
  }
  if (d.constant == 0 && d.linear == 0) return {0, SolveStatus::ok};
  return find_sign_change([&](Wide x) { return slope_exp2(d, x); }, guess_stationary_exp2(d), std::sqrt(kMaxDepth));
}

/// The solve proper, for 0 < density < infinity and a light with an end.
FogIntensity solve_wide(const Attenuation& asked, const Fog& fog, double threshold) {
  const auto attenuation = convert<Wide>(asked);
  const Wide density = fog.density;
  const Wide extent = level_range(attenuation, Wide(threshold)).high;
  if (extent == 0) return {0, 0, 0, SolveStatus::ok};
  const Root stationary = find_stationary_point(attenuation, fog.mode, density);
  const auto solved_at = [&](Wide range, Wide level) {
    const Wide depth = fog.mode == FogMode::exp ? density * range : (density * range) * (density * range);
    const double intensity = std::min(double(level * -std::expm1(-depth)), 1.0);  // rounding upward may exceed 1
    return FogIntensity{intensity, double(range), double(extent), stationary.status};
  };
  const Wide range = stationary.x / density;
  if (range >= extent) return solved_at(extent, threshold);  // the attenuation is the threshold there by definition
  if (attenuation.constant < 1) {
    const Wide knee = level_range(attenuation, Wide(1)).high;
    if (range <= knee) return solved_at(knee, 1);
  }
  return solved_at(range, 1 / (attenuation.constant + range * (attenuation.linear + range * attenuation.quadratic)));
}

/// The limit cases that need no search: intensity and peak range without the extent.
bool is_limit_case(const Attenuation& attenuation, const Fog& fog) {
  return fog.density == 0 || std::isinf(fog.density) || (attenuation.linear == 0 && attenuation.quadratic == 0);
}

/// Whether solve_by_series takes the arguments.
bool is_series_case(const Attenuation& attenuation, const Fog& fog, double threshold) {
  const auto [constant, linear, quadratic] = attenuation;
  return is_in_safe_range(constant, linear, quadratic, fog.density, threshold) && linear + quadratic > 0 &&
         fog.density != 0 && threshold != 0 && threshold < 1;
}

FogIntensity solve_limit_case(const Attenuation& attenuation, const Fog& fog, double threshold) {
  const double extent = unchecked::compute_extent(attenuation, threshold);
  if (extent == 0 || fog.density == 0) return {0, 0, extent, SolveStatus::ok};
  // Total fog takes the attenuation at 0+, constant attenuation the opacity 1 at infinity.
  return {attenuation_at(attenuation, 0), std::isinf(fog.density) ? 0 : std::numeric_limits<double>::infinity(), extent,
          SolveStatus::ok};
}

}  // namespace

FogIntensity unchecked::solve_fog_intensity(const Attenuation& attenuation, const Fog& fog, double threshold) {
  if (is_limit_case(attenuation, fog)) return solve_limit_case(attenuation, fog, threshold);
  if (is_series_case(attenuation, fog, threshold)) {
    if (const auto solved = solve_by_series(attenuation, fog, threshold)) return *solved;
  }
  return solve_wide(attenuation, fog, threshold);
}

FogIntensity solve_fog_intensity(const Attenuation& attenuation, const Fog& fog, double threshold) {
  if (is_series_case(attenuation, fog, threshold)) {  // what passes is valid
    if (const auto solved = solve_by_series(attenuation, fog, threshold)) return *solved;
  }
  require(find_error(attenuation));
  require(find_error(fog));
  require(find_threshold_error(threshold));
  return unchecked::solve_fog_intensity(attenuation, fog, threshold);
}

FogIntensity solve_fog_intensity(const Light& light, const Fog& fog) {
  require(find_error(light));
  require(find_error(fog));
  return unchecked::solve_fog_intensity(light.attenuation, unchecked::scaled(fog, light.density_scale),
                                        light.threshold);
}

FogIntensityF solve_fog_intensity(const AttenuationF& attenuation, const FogF& fog, float threshold) {
  const auto wide = solve_fog_intensity(Attenuation{attenuation.constant, attenuation.linear, attenuation.quadratic},
                                        Fog{fog.mode, fog.density}, double(threshold));
  return {float(wide.intensity), float(wide.peak_range), float(wide.extent), wide.status};
}

FogIntensity sample_fog_intensity(const Attenuation& attenuation, const Fog& fog, double threshold, int samples) {
  require(find_error(attenuation));
  require(find_error(fog));
  require(find_threshold_error(threshold));
  if (!(samples >= 1)) require(ValueError{"samples", double(samples), "must be >= 1"});
  if (is_limit_case(attenuation, fog)) return solve_limit_case(attenuation, fog, threshold);
  const double extent = unchecked::compute_extent(attenuation, threshold);
  FogIntensity best{0, 0, extent, SolveStatus::ok};
  for (int i = 1; i <= samples; ++i) {
    const double range = extent * (double(i) / samples);
    const double intensity = opacity_at(fog, range) * attenuation_at(attenuation, range);
    if (intensity > best.intensity) best = {intensity, range, extent, SolveStatus::ok};
  }
  return best;
}

}  // namespace litfog
