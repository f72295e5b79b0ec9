// SPDX-License-Identifier: Apache-2.0
// Included once for each SIMD target (Highway's quick reference, "Dynamic dispatch").
#if defined(LITFOG_BATCH_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LITFOG_BATCH_LANES_H
#undef LITFOG_BATCH_LANES_H
#else
#define LITFOG_BATCH_LANES_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace litfog::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One vector's columns.
template <class V>
struct Lanes {
  V constant;
  V linear;
  V quadratic;
  V threshold;
  V density;
};

/// The range at which l r + q r^2 is an excess K: 2 K / (l + sqrt(l^2 + 4 q K)), 0 where K <= 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V level_root(D d, V excess, V linear, V quadratic) {
  const V twice = hn::Add(excess, excess);
  const V root = hn::Sqrt(hn::MulAdd(linear, linear, hn::Mul(hn::Add(quadratic, quadratic), twice)));
  return hn::IfThenElseZero(hn::Gt(excess, hn::Zero(d)), hn::Div(twice, hn::Add(linear, root)));
}

}  // namespace litfog::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
