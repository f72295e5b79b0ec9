// SPDX-License-Identifier: Apache-2.0
#include "bench/rival.h"

#include <algorithm>
#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/sampled_batch.cpp"  // this file, once for each SIMD target
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Highway's order: highway.h first.
#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace litfog::bench::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<float>;
using Vector = hn::Vec<Tag>;

/// The state of one vector of lights at a sample.
struct Sampling {
  Vector constant, linear, quadratic;  ///< denominator's terms in steps of extent / N
  Vector opacity, best;
  Vector step, growth;  ///< opacity of the step from this sample to the next, and what it grows by (exp2)
};

Sampling start(FogMode mode, const BatchLightsF& lights, std::size_t i, int samples) {
  const Tag d;
  const Vector constant = hn::LoadU(d, &lights.constant[i]);
  const Vector linear = hn::LoadU(d, &lights.linear[i]);
  const Vector quadratic = hn::LoadU(d, &lights.quadratic[i]);
  const Vector one = hn::Set(d, 1);
  const Vector excess = hn::Sub(hn::Div(one, hn::LoadU(d, &lights.threshold[i])), constant);
  const Vector root = hn::Sqrt(hn::MulAdd(hn::Mul(hn::Set(d, 4), quadratic), excess, hn::Mul(linear, linear)));
  const Vector extent = hn::Div(hn::Add(excess, excess), hn::Add(linear, root));
  const Vector h = hn::Div(extent, hn::Set(d, float(samples)));
  const Vector depth = hn::Mul(hn::LoadU(d, &lights.density[i]), h);
  const auto opacity = [&](Vector x) { return hn::Neg(hn::CallExpm1(d, hn::Neg(x))); };
  const Vector square = hn::Mul(depth, depth);
  return {.constant = constant,
          .linear = hn::Mul(linear, h),
          .quadratic = hn::Mul(hn::Mul(quadratic, h), h),
          .opacity = hn::Zero(d),
          .best = hn::Zero(d),
          .step = opacity(mode == FogMode::exp ? depth : square),
          .growth = mode == FogMode::exp ? hn::Zero(d) : opacity(hn::Add(square, square))};
}

template <FogMode kMode>
void take_sample(Vector index, Sampling& s) {
  const Tag d;
  const Vector one = hn::Set(d, 1);
  s.opacity = hn::MulAdd(hn::Sub(one, s.opacity), s.step, s.opacity);
  if constexpr (kMode == FogMode::exp2) s.step = hn::MulAdd(hn::Sub(one, s.step), s.growth, s.step);
  const Vector denominator = hn::MulAdd(index, hn::MulAdd(index, s.quadratic, s.linear), s.constant);
  s.best = hn::Max(s.best, hn::Div(s.opacity, hn::Max(denominator, one)));
}

template <FogMode kMode>
void sample_mode(const BatchLightsF& lights, int samples, std::span<float> intensity) {
  const Tag d;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t count = lights.constant.size();
  assert(count >= 2 * lanes);
  // Two vectors at once, so that one hides the other's latency; the last pair overlaps the previous one.
  for (std::size_t begin = 0; begin < count; begin += 2 * lanes) {
    const std::size_t i = std::min(begin, count - 2 * lanes);
    Sampling first = start(kMode, lights, i, samples);
    Sampling second = start(kMode, lights, i + lanes, samples);
    Vector index = hn::Zero(d);
    for (int n = 0; n < samples; ++n) {
      index = hn::Add(index, hn::Set(d, 1));
      take_sample<kMode>(index, first);
      take_sample<kMode>(index, second);
    }
    hn::StoreU(first.best, d, &intensity[i]);
    hn::StoreU(second.best, d, &intensity[i + lanes]);
  }
}

void sample(FogMode mode, const BatchLightsF& lights, int samples, std::span<float> intensity) {
  mode == FogMode::exp ? sample_mode<FogMode::exp>(lights, samples, intensity)
                       : sample_mode<FogMode::exp2>(lights, samples, intensity);
}

}  // namespace litfog::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace litfog::bench {

HWY_EXPORT(sample);

void sample_fog_intensities(FogMode mode, const BatchLightsF& lights, int samples, std::span<float> intensity) {
  HWY_DYNAMIC_DISPATCH(sample)(mode, lights, samples, intensity);
}

}  // namespace litfog::bench
#endif
