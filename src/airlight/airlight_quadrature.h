// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "airlight_text.h"

// The reference airlight: the integrand of the shared text by adaptive bisection.

namespace litfog::airlight_text {

/// Adaptive quadrature of a function.
template <typename Function, typename Real>
class Bisection {
 public:
  /// agreement  relative difference between a stretch and the sum of its halves, at which halving ends
  Bisection(const Function& function, Real agreement) : function_(function), agreement_(agreement) {}

  /// Estimates a stretch by eight Gauss-Legendre nodes.
  Real estimate(Real low, Real high) const {
    using Rules = Text<Real, NoCookie>;
    constexpr int kNodes = 8, kRule = kNodes * (kNodes - 1) / 2;
    Real sum = 0;
    for (int i = kRule; i < kRule + kNodes; ++i) {
      sum += Rules::litfog_gauss_weights[i] * function_(low + (high - low) * Rules::litfog_gauss_nodes[i]);
    }
    return sum * (high - low);
  }

  /// Halves a stretch until its halves agree with the whole, or differ from it by a negligible amount. Those of a ray
  /// that runs along the edge of a cone, where rounding lights each point by itself, never agree: they end by number.
  Real refine(Real low, Real high, Real whole, Real negligible, int depth) {
    constexpr int kMaxHalvings = 1 << 17;
    const Real middle = (low + high) / 2;
    const Real left = estimate(low, middle);
    const Real right = estimate(middle, high);
    const Real error = std::abs(left + right - whole);
    if (error <= std::max(agreement_ * (left + right), negligible) || depth == 0 || ++halvings_ > kMaxHalvings) {
      return left + right;
    }
    return refine(low, middle, left, negligible, depth - 1) + refine(middle, high, right, negligible, depth - 1);
  }

 private:
  const Function& function_;
  Real agreement_;
  int halvings_ = 0;
};

/// The integral of a function >= 0 over the stretches between cuts in ascending order.
///
/// bound  an upper bound of the function. A hundredth of an epsilon of its integral is negligible: rounding in the edge
///        of a cone
template <typename Real, typename Function, typename Bound>
Real integrate(const std::vector<Real>& cuts, const Function& function, const Bound& bound, Real agreement) {
  constexpr int kDepth = 40;
  constexpr Real kRounding = std::numeric_limits<Real>::epsilon() / 100;
  const Real negligible_fraction = agreement / 10;  // of the total, for some hundred stretches
  Bisection bisection(function, agreement);
  const Bisection bisection_of_bound(bound, agreement);
  std::vector<Real> estimates;
  Real total = 0;
  Real total_of_bound = 0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    total += estimates.emplace_back(bisection.estimate(cuts[i], cuts[i + 1]));
    total_of_bound += bisection_of_bound.estimate(cuts[i], cuts[i + 1]);
  }
  for (;;) {  // repeats if the first estimate was so high that its negligible amount is not negligible
    const Real negligible = std::max(negligible_fraction * total, kRounding * total_of_bound);
    Real refined = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      refined += bisection.refine(cuts[i], cuts[i + 1], estimates[i], negligible, kDepth);
    }
    if (refined >= total / 100) return refined;
    total = refined;
  }
}

/// In the edge of a narrow cone, long double has no more than 1e-13.
inline constexpr long double kReferenceAgreement = 1e-12L;

/// Cookie  like Text's; its append_kinks(cuts) appends the distances along the ray where it is not smooth
template <typename Real, typename Cookie>
Real integrate_airlight(Text<Real, Cookie> text, const typename Text<Real, Cookie>::LitfogAirlight& air,
                        Real agreement = kReferenceAgreement) {
  if (std::isinf(air.density)) return text.at_the_eye(air);
  const bool is_layered = text.litfog_airlight_is_layered(air);
  const Real thickest = air.density + (is_layered ? air.layer_scale * text.litfog_largest_profile_density() : 0);
  if (thickest == 0 || air.offset >= air.extent) return 0;
  const Real chord = text.litfog_airlight_chord(air, air.extent);
  const Real fog_scale = 1 / thickest;
  const Real low = std::max(-air.approach, -chord);
  const Real depths = formulas::is_exp(air.mode) ? 11400 : 107;  // at which e^-depth is 0
  const Real end = is_layered ? text.litfog_airlight_end_of_layers(air, depths) : depths * fog_scale;
  const Real high = std::min({air.ray_length - air.approach, chord, end - air.approach});
  if (!(high > low)) return 0;

  // Where the integrand is not smooth or has a peak, and the shortest distance over which it changes there.
  std::vector<Real> cuts{low, high, 0};
  Real scale = std::min(fog_scale, fog_scale / (air.density * (air.approach + low)));
  if (air.offset > 0) scale = std::min(scale, air.offset);
  const Real plateau = text.litfog_airlight_chord(air, text.litfog_airlight_level(air, 1));
  cuts.insert(cuts.end(), {-plateau, plateau});
  const Real denominator = formulas::denominator(air.offset, air.constant, air.linear, air.quadratic);
  const Real falloff =
      text.litfog_airlight_chord(air, text.litfog_airlight_level(air, 2 * std::max(Real(1), denominator)));
  if (falloff > 0) scale = std::min(scale, falloff);
  if (!formulas::is_exp(air.mode)) cuts.push_back((air.lamp_leg != 0 ? Real(-0.5) : Real(-1)) * air.approach);
  if (formulas::litfog_has_cone(air.profile)) {
    for (const Real cosine :
         {air.cone_x, formulas::litfog_cone_has_inner_edge(air.profile) ? air.cone_y : air.cone_x}) {
      const auto inside = text.litfog_airlight_inside(air, cosine);
      cuts.insert(cuts.end(), {inside.low, inside.high});
    }
    if (air.axis_offset > 0) {
      const Real crossing = air.axis_slope * air.offset * air.offset / air.axis_offset;
      const Real sharpness = formulas::litfog_cone_is_cut_off(air.profile) ? 1 + air.cone_y : 1 / (1 - air.cone_x);
      const Real range = text.litfog_airlight_range(air, crossing);
      cuts.push_back(crossing);
      scale = std::min(scale, range * (range / air.offset) / std::sqrt(sharpness));
    }
  }
  for (int i = 0; is_layered && i < text.litfog_knot_count() && air.rise != 0; ++i) {
    cuts.push_back((text.litfog_knot_height(i) - air.height) / air.rise);
  }
  text.cookie.append_kinks(cuts);
  for (Real& cut : cuts) cut = std::clamp(cut, low, high);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());

  // Towards each of them in steps that shrink down to that distance.
  scale = std::max(scale, Real(1e-36) * (high - low));
  const std::size_t kinks = cuts.size();
  for (std::size_t i = 0; i + 1 < kinks; ++i) {
    const Real from = cuts[i], to = cuts[i + 1];
    for (Real size = (to - from) / 2; size > scale; size /= 8) {
      cuts.insert(cuts.end(), {from + size, to - size});
    }
  }
  std::sort(cuts.begin(), cuts.end());
  auto without_cone = air;
  without_cone.profile = LITFOG_PROFILE_NONE;
  const auto integrand_of = [&text](const auto& of) {
    return [&text, &of](Real along) { return text.litfog_airlight_integrand(of, along); };
  };
  return integrate(cuts, integrand_of(air), integrand_of(without_cone), agreement);
}

}  // namespace litfog::airlight_text
