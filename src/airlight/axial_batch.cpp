// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "litfog/airlight.h"
#include "model/unchecked.h"
#include "solve/batch_columns.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "airlight/axial_batch.cpp"  // this file, once for each SIMD target
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Highway's order: highway.h first.
#include <hwy/contrib/math/math-inl.h>

#include "solve/batch_lanes.h"

// Gauss-Legendre nodes and weights of (0, 1), once for all targets.
#ifndef LITFOG_AXIAL_NODES
#define LITFOG_AXIAL_NODES
namespace litfog {

template <typename T>
struct AxialNodes {
  static constexpr int kCount = sizeof(T) == 4 ? 20 : 40;
  std::array<T, kCount> positions;
  std::array<T, kCount> weights;
};

template <typename T>
const AxialNodes<T>& axial_nodes();

}  // namespace litfog
#endif

HWY_BEFORE_NAMESPACE();
namespace litfog::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// With x = density r, f the fog factor and D the attenuation's denominator the integral is
//   1 - f(x0) + integral over [x0, x1] of -f'(x) / D(x) dx,
// x0 at the knee and x1 at the extent, or where f leaves nothing. The scale s on which the second integrand changes is
// that in which D doubles, or in which the fog fades. In t with x = x0 + s (e^t - 1) it changes evenly. The nodes are
// enough for kLongest of t. The length over s is below 1 / threshold + 19, so that only thresholds below 1/600 need
// more; such lights are integrated one by one.

constexpr double kLongest = 6.5;

/// The integral; NaN for lights beyond the figures that it holds for.
template <FogMode kMode, class D, class V = hn::Vec<D>>
HWY_INLINE V integrate_axially(D d, const Lanes<V>& in) {
  using T = hn::TFromD<D>;
  constexpr bool kIsFloat = sizeof(T) == 4;
  constexpr bool kIsExp = kMode == FogMode::exp;
  constexpr double kFogEnd = kIsExp ? (kIsFloat ? 18 : 38) : (kIsFloat ? 4.25 : 6.2);  // x at which f is 2^-26, 2^-55
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1);
  const V metres = hn::Div(one, in.density);
  const V linear = hn::Mul(in.linear, metres);
  const V quadratic = hn::Mul(hn::Mul(in.quadratic, metres), metres);
  const V first = hn::Max(in.constant, one);  // D at x0
  const auto range_at = [&](V rise) HWY_ATTR { return level_root(d, rise, linear, quadratic); };
  const V end = range_at(hn::Div(hn::NegMulAdd(in.constant, in.threshold, one), in.threshold));
  const V knee = hn::Min(range_at(hn::Sub(one, in.constant)), end);
  const V doubling = hn::Sub(range_at(hn::Sub(hn::Add(first, first), in.constant)), knee);
  const V most = kIsExp ? hn::Set(d, T(kFogEnd)) : hn::Max(hn::Sub(hn::Set(d, T(kFogEnd)), knee), zero);
  const V length = hn::Min(hn::Sub(end, knee), most);
  const V fading = hn::Set(d, T(kIsExp ? 2 : 1));
  const V scale = hn::Div(hn::Mul(doubling, fading), hn::Add(doubling, fading));
  const V longest = hn::Log1p(d, hn::Div(length, scale));

  const AxialNodes<T>& nodes = axial_nodes<T>();
  V sum = zero;
  for (int i = 0; i < AxialNodes<T>::kCount; ++i) {
    const V growth = hn::Exp(d, hn::Mul(longest, hn::Set(d, nodes.positions[std::size_t(i)])));
    const V x = hn::MulAdd(scale, hn::Sub(growth, one), knee);
    const V denominator = hn::MulAdd(x, hn::MulAdd(x, quadratic, linear), in.constant);
    V scattered;  // -f'
    if constexpr (kIsExp) {
      scattered = hn::Exp(d, hn::Neg(x));
    } else {
      scattered = hn::Mul(hn::Add(x, x), hn::Exp(d, hn::Neg(hn::Mul(x, x))));
    }
    const V weight = hn::Set(d, nodes.weights[std::size_t(i)]);
    sum = hn::MulAdd(weight, hn::Div(hn::Mul(growth, scattered), hn::Max(denominator, one)), sum);
  }
  const V depth = kIsExp ? knee : hn::Mul(knee, knee);
  const V before_knee = hn::Neg(hn::Expm1(d, hn::Neg(depth)));
  const V airlight = hn::Min(hn::MulAdd(hn::Mul(scale, longest), sum, before_knee), one);

  const auto is_within = [&](V value, double low, double high) HWY_ATTR {
    return hn::And(hn::Ge(value, hn::Set(d, T(low))), hn::Le(value, hn::Set(d, T(high))));
  };
  const V fall = hn::Add(in.linear, in.quadratic);
  const V least = hn::Min(in.constant, hn::Min(in.linear, in.quadratic));
  const auto is_lit = hn::And(hn::Gt(end, zero), hn::Le(longest, hn::Set(d, T(kLongest))));
  const auto is_ordinary =
      hn::And(hn::And(is_within(hn::Add(in.constant, fall), 0, 0x1p+20), hn::Ge(least, zero)),
              hn::And(hn::And(is_within(fall, 0x1p-30, 0x1p+20), is_within(in.threshold, 0x1p-14, 1 - 0x1p-14)),
                      is_within(in.density, 0x1p-17, 0x1p+10)));
  return hn::IfThenElse(hn::And(is_lit, is_ordinary), airlight, hn::NaN(d));
}

/// A light by the scalar integral: 0 and one more invalid if it is.
template <typename T>
T integrate_one(FogMode mode, const BasicBatchLights<T>& lights, std::size_t at, std::size_t& invalid) {
  const Attenuation attenuation{lights.constant[at], lights.linear[at], lights.quadratic[at]};
  const Fog fog{mode, value_at(lights.density, at)};
  const double threshold = value_at(lights.threshold, at);
  if (!check(attenuation) && !check(fog) && !check_threshold(threshold)) {
    return T(unchecked::axial_airlight(attenuation, fog, threshold));
  }
  ++invalid;
  return 0;
}

template <FogMode kMode, typename T>
std::size_t integrate_columns(const BasicBatchLights<T>& lights, std::span<T> airlights) {
  const hn::ScalableTag<T> d;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t count = airlights.size();
  std::size_t invalid = 0;
  for (std::size_t at = 0; at < count; at += lanes) {
    const std::size_t used = std::min(lanes, count - at);
    T columns[5][hn::MaxLanes(d)];
    T results[hn::MaxLanes(d)];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      copy_light(lights, std::min(at + lane, count - 1), columns, lane);  // beyond the end the last light again
    }
    const Lanes<hn::Vec<decltype(d)>> in{hn::LoadU(d, columns[0]), hn::LoadU(d, columns[1]), hn::LoadU(d, columns[2]),
                                         hn::LoadU(d, columns[3]), hn::LoadU(d, columns[4])};
    hn::StoreU(integrate_axially<kMode>(d, in), d, results);
    for (std::size_t lane = 0; lane < used; ++lane) {
      const bool is_done = results[lane] == results[lane];
      airlights[at + lane] = is_done ? results[lane] : integrate_one(kMode, lights, at + lane, invalid);
    }
  }
  return invalid;
}

std::size_t axial_exp_double(const BatchLights& lights, std::span<double> airlights) {
  return integrate_columns<FogMode::exp>(lights, airlights);
}
std::size_t axial_exp2_double(const BatchLights& lights, std::span<double> airlights) {
  return integrate_columns<FogMode::exp2>(lights, airlights);
}
std::size_t axial_exp_float(const BatchLightsF& lights, std::span<float> airlights) {
  return integrate_columns<FogMode::exp>(lights, airlights);
}
std::size_t axial_exp2_float(const BatchLightsF& lights, std::span<float> airlights) {
  return integrate_columns<FogMode::exp2>(lights, airlights);
}

}  // namespace litfog::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace litfog {
namespace {

/// The roots of the Legendre polynomial by Newton's method, from Tricomi's guess.
template <typename T>
AxialNodes<T> make_axial_nodes() {
  constexpr int kCount = AxialNodes<T>::kCount;
  AxialNodes<T> nodes;
  for (int i = 0; i < kCount; ++i) {
    long double z = std::cos(std::numbers::pi_v<long double> * (i + 0.75L) / (kCount + 0.5L));
    long double slope = 0;
    for (int step = 0; step < 8; ++step) {  // quadratic convergence: five are enough
      long double before = 1;
      long double value = z;
      for (int n = 2; n <= kCount; ++n) {
        const long double next = ((2 * n - 1) * z * value - (n - 1) * before) / n;
        before = value;
        value = next;
      }
      slope = kCount * (z * value - before) / (z * z - 1);
      z -= value / slope;
    }
    nodes.positions[std::size_t(i)] = T((1 - z) / 2);
    nodes.weights[std::size_t(i)] = T(1 / ((1 - z * z) * slope * slope));
  }
  return nodes;
}

}  // namespace

template <typename T>
const AxialNodes<T>& axial_nodes() {
  static const AxialNodes<T> kNodes = make_axial_nodes<T>();
  return kNodes;
}
template const AxialNodes<float>& axial_nodes<float>();
template const AxialNodes<double>& axial_nodes<double>();

HWY_EXPORT(axial_exp_double);
HWY_EXPORT(axial_exp2_double);
HWY_EXPORT(axial_exp_float);
HWY_EXPORT(axial_exp2_float);

std::size_t axial_airlights(FogMode mode, const BatchLights& lights, std::span<double> airlights) {
  assert(holds_lights(lights, airlights.size()));
  return mode == FogMode::exp ? HWY_DYNAMIC_DISPATCH(axial_exp_double)(lights, airlights)
                              : HWY_DYNAMIC_DISPATCH(axial_exp2_double)(lights, airlights);
}

std::size_t axial_airlights(FogMode mode, const BatchLightsF& lights, std::span<float> airlights) {
  assert(holds_lights(lights, airlights.size()));
  return mode == FogMode::exp ? HWY_DYNAMIC_DISPATCH(axial_exp_float)(lights, airlights)
                              : HWY_DYNAMIC_DISPATCH(axial_exp2_float)(lights, airlights);
}

}  // namespace litfog
#endif
