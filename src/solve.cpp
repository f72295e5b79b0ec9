// SPDX-License-Identifier: Apache-2.0
#include "litfog/solve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "level_range.h"
#include "require.h"
#include "unchecked.h"

namespace litfog {
namespace {

template <typename T>
constexpr T kInfinity = std::numeric_limits<T>::infinity();

/// The stationary point is sought in x = d r, where the denominator is C + A x + B x^2.
template <typename T>
struct ScaledDenominator {
  T constant;
  T linear;     // A = L / d
  T quadratic;  // B = Q / d^2
};

/// Below this depth the series of p is used, beyond it the exponential.
template <typename T>
constexpr T kSeriesDepth = T(0.6875);

/// p(u) = e^u - 1 - u. Its series (to 1e-17 for |u| <= kSeriesDepth, summed in pairs for a short chain of dependent
/// operations) does not cancel.
template <typename T>
T expm1_minus_argument(T u) {
  if (u > kSeriesDepth<T>) return std::exp(u) - 1 - u;
  const T u2 = u * u;
  const T u4 = u2 * u2;
  const auto pair = [u](double even_factorial, double odd_factorial) {
    return T(1 / even_factorial) + u * T(1 / odd_factorial);
  };
  const T low = (pair(2, 6) + u2 * pair(24, 120)) + u4 * (pair(720, 5040) + u2 * pair(40320, 362880));
  const T high = (pair(3628800, 39916800) + u2 * pair(479001600, 6227020800)) +
                 u4 * (pair(87178291200, 1307674368000) + u2 * T(1 / 20922789888000.));
  return u2 * (low + u4 * u4 * high);
}

/// A function that is negative below the stationary point and positive beyond, with two derivatives.
template <typename T>
struct Slope {
  T value;
  T first;
  T second;
};

/// exp fog: D'(x) expm1(x) - D(x). A power series whose only negative coefficient is -C.
template <typename T>
Slope<T> slope_exp(const ScaledDenominator<T>& d, T x) {
  const T p = expm1_minus_argument(x);
  const T e1 = x + p;
  const T growth = d.linear + 2 * d.quadratic * (1 + x);
  return {(d.linear + 2 * d.quadratic * x) * p + d.quadratic * x * x - d.constant,  //
          e1 * growth,                                                              //
          (e1 + 1) * growth + 2 * d.quadratic * e1};
}

/// exp2 fog: D'(x) expm1(x^2) / (2 x) - D(x). A power series; only -C and the linear term -A x / 2 are negative.
template <typename T>
Slope<T> slope_exp2(const ScaledDenominator<T>& d, T x) {
  const T w = x * x;
  const T p = expm1_minus_argument(w);
  const T e1 = w + p;
  const T half = d.linear / (2 * x);
  const T growth = d.linear + 2 * d.quadratic * x - half / x;
  return {(half + d.quadratic) * p - d.linear * x / 2 - d.constant,  //
          e1 * growth,                                               //
          2 * x * (e1 + 1) * growth + 2 * e1 * (d.quadratic + half / w)};
}

/// u with e^u - 1 - u = z to within a few percent: right for small and for large z, good between.
template <typename T>
T guess_depth(T z) {
  return std::log1p(z + std::sqrt(2 * z));
}

template <typename T>
T guess_stationary_exp(const ScaledDenominator<T>& d) {
  return guess_depth(d.constant / (d.linear + 2 * d.quadratic));
}

template <typename T>
T guess_stationary_exp2(const ScaledDenominator<T>& d) {
  const T w = guess_depth((2 * d.constant + d.linear) / (d.linear + 2 * d.quadratic));
  if (w > T(0.1)) return std::sqrt(w);
  // Small x: B x^4 - A x = 2 C, and the larger of the two one-term roots is near.
  return std::max(std::sqrt(std::sqrt(2 * d.constant / d.quadratic)), std::cbrt(d.linear / d.quadratic));
}

template <typename T>
struct Root {
  T x;
  SolveStatus status;
};

/// The one sign change of a slope on (0, upper]: Halley from a guess, kept inside the bracket, bisected on escape.
/// A step that moves x by the fraction m leaves an error of about m^3 (1 + x^2 / 12), so that a step below the bound
/// leaves the peak's range good to 1e-9 and its height to the square of that.
template <typename T, typename SlopeAt>
Root<T> find_sign_change(const SlopeAt& slope_at, T guess, T upper) {
  constexpr int kMaxSteps = 100;
  T low = 0;
  T high = upper;
  T x = std::min(guess, upper);
  for (int step = 0; step < kMaxSteps; ++step) {
    const Slope<T> slope = slope_at(x);
    (slope.value < 0 ? low : high) = x;
    const T move = 2 * slope.value * slope.first / (2 * slope.first * slope.first - slope.value * slope.second);
    T next = x - move;
    if (!(next > low && next < high) && next != x) next = low > 0 ? std::sqrt(low) * std::sqrt(high) : high / 2;
    const bool is_close = std::abs(next - x) * (1 + x) <= T(1e-3) * x;
    x = next;
    if (is_close) return {x, SolveStatus::ok};
  }
  return {x, SolveStatus::not_converged};
}

/// Where the derivative of opacity * 1/D vanishes, in x = d r; 0 where it is negative from the start (C = 0).
template <typename T>
Root<T> find_stationary_point(const BasicAttenuation<T>& attenuation, FogMode mode, T density) {
  const ScaledDenominator<T> d{attenuation.constant, attenuation.linear / density,
                               attenuation.quadratic / density / density};
  // Above this depth e^u nears T's largest value; the slope is positive there for all coefficients T is used with.
  constexpr T kMaxDepth = std::numeric_limits<T>::max_exponent > 1024 ? T(11000) : T(700);
  if (mode == FogMode::exp) {
    if (d.constant == 0) return {0, SolveStatus::ok};
    return find_sign_change([&](T x) { return slope_exp(d, x); }, guess_stationary_exp(d), kMaxDepth);
  }
  if (d.constant == 0 && d.linear == 0) return {0, SolveStatus::ok};
  return find_sign_change([&](T x) { return slope_exp2(d, x); }, guess_stationary_exp2(d), std::sqrt(kMaxDepth));
}

/// Opacity 1 - e^-depth at a range, both to more digits than T has.
template <typename T>
Split<T> split_opacity(FogMode mode, T density, const Split<T>& range) {
  Split<T> depth = two_product(density, range.high);
  depth.low += density * range.low;
  if (mode == FogMode::exp2) {
    const Split<T> square = two_product(depth.high, depth.high);
    depth = {square.high, square.low + 2 * depth.high * depth.low};
  }
  const bool is_thin = depth.high < kSeriesDepth<T>;
  const Split<T> opacity =
      is_thin ? two_sum(depth.high, -expm1_minus_argument(-depth.high)) : two_sum(T(1), -std::exp(-depth.high));
  return {opacity.high, opacity.low + (1 - opacity.high) * depth.low};
}

/// The solve proper, for 0 < density < infinity and a light that ends somewhere.
template <typename T>
BasicFogIntensity<T> solve_peak(const BasicAttenuation<T>& attenuation, FogMode mode, T density, T threshold) {
  const Split<T> extent = level_range(attenuation, threshold);
  if (extent.high == 0) return {0, 0, 0, SolveStatus::ok};
  const Root<T> stationary = find_stationary_point(attenuation, mode, density);
  const T range = stationary.x / density;
  if (range >= extent.high) {  // the attenuation is the threshold there by definition
    const Split<T> opacity = split_opacity(mode, density, extent);
    return {threshold * (opacity.high + opacity.low), extent.high, extent.high, stationary.status};
  }
  if (attenuation.constant < 1) {
    const Split<T> knee = level_range(attenuation, T(1));
    if (range <= knee.high) {
      const Split<T> opacity = split_opacity(mode, density, knee);
      return {opacity.high + opacity.low, knee.high, extent.high, stationary.status};
    }
  }
  const Split<T> denominator = split_denominator(attenuation, range);
  const Split<T> opacity = split_opacity(mode, density, {range, 0});
  const T quotient = opacity.high / denominator.high;
  return {quotient + (opacity.low - quotient * denominator.low) / denominator.high, range, extent.high,
          stationary.status};
}

/// The limit cases that need no search: intensity and peak range without the extent.
bool is_limit_case(const Attenuation& attenuation, const Fog& fog) {
  return fog.density == 0 || std::isinf(fog.density) || (attenuation.linear == 0 && attenuation.quadratic == 0);
}

FogIntensity solve_limit_case(const Attenuation& attenuation, const Fog& fog, double threshold) {
  const double extent = unchecked::compute_extent(attenuation, threshold);
  if (extent == 0 || fog.density == 0) return {0, 0, extent, SolveStatus::ok};
  // Total fog takes the attenuation at 0+, constant attenuation the opacity 1 at infinity.
  return {attenuation_at(attenuation, 0), std::isinf(fog.density) ? 0 : kInfinity<double>, extent, SolveStatus::ok};
}

}  // namespace

FogIntensity unchecked::solve_fog_intensity(const Attenuation& attenuation, const Fog& fog, double threshold) {
  if (is_limit_case(attenuation, fog)) return solve_limit_case(attenuation, fog, threshold);
  const auto bounded = [](double intensity) { return std::min(intensity, 1.0); };  // rounding upward may exceed 1
  if (is_in_safe_range(attenuation.constant, attenuation.linear, attenuation.quadratic, fog.density, threshold)) {
    FogIntensity solved = solve_peak(attenuation, fog.mode, fog.density, threshold);
    solved.intensity = bounded(solved.intensity);
    return solved;
  }
  const auto wide = solve_peak<long double>(convert<long double>(attenuation), fog.mode, fog.density, threshold);
  return {bounded(double(wide.intensity)), double(wide.peak_range), double(wide.extent), wide.status};
}

FogIntensity solve_fog_intensity(const Attenuation& attenuation, const Fog& fog, double threshold) {
  require(check(attenuation));
  require(check(fog));
  require(check_threshold(threshold));
  return unchecked::solve_fog_intensity(attenuation, fog, threshold);
}

FogIntensity solve_fog_intensity(const Light& light, const Fog& fog) {
  require(check(light));
  require(check(fog));
  return unchecked::solve_fog_intensity(light.attenuation, unchecked::scaled(fog, light.density_scale),
                                        light.threshold);
}

FogIntensityF solve_fog_intensity(const AttenuationF& attenuation, const FogF& fog, float threshold) {
  const auto wide = solve_fog_intensity(Attenuation{attenuation.constant, attenuation.linear, attenuation.quadratic},
                                        Fog{fog.mode, fog.density}, double(threshold));
  return {float(wide.intensity), float(wide.peak_range), float(wide.extent), wide.status};
}

FogIntensity sample_fog_intensity(const Attenuation& attenuation, const Fog& fog, double threshold, int samples) {
  require(check(attenuation));
  require(check(fog));
  require(check_threshold(threshold));
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
