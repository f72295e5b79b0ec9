// SPDX-License-Identifier: Apache-2.0
#include "circle_sampler.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <limits>
#include <numbers>

#include "measured_angles.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "photometry/circle_sampler.cpp"  // this file, once for each SIMD target
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace litfog::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// atan2 to 1e-15, but for the sign of a zero x; of two zeros it is a zero. The rational function is that of Cephes
/// (S. L. Moshier, atan.c), which holds to 0.66: the tangent is brought to within tan(pi / 8).
template <class D, class V = hn::Vec<D>>
HWY_INLINE V arc_tangent(D d, V y, V x) {
  constexpr double kPi = std::numbers::pi;
  const auto set = [d](double value) HWY_ATTR { return hn::Set(d, value); };
  const V across = hn::Abs(y), along = hn::Abs(x);
  const V least = hn::Min(across, along), most = hn::Max(across, along);
  const auto is_diagonal = hn::Gt(least, hn::Mul(set(0.41421356237309503), most));
  const V numerator = hn::IfThenElse(is_diagonal, hn::Sub(least, most), least);
  const V denominator = hn::IfThenElse(is_diagonal, hn::Add(least, most), most);
  const V tangent = hn::Div(numerator, hn::Max(denominator, set(std::numeric_limits<double>::min())));
  const V z = hn::Mul(tangent, tangent);
  const auto step = [&](V sum, double coefficient) HWY_ATTR { return hn::MulAdd(sum, z, set(coefficient)); };
  V p = step(set(-8.750608600031904122785e-1), -1.615753718733365076637e1);
  p = step(step(step(p, -7.500855792314704667340e1), -1.228866684490136173410e2), -6.485021904942025371773e1);
  V q = hn::Add(z, set(2.485846490142306297962e1));
  q = step(step(q, 1.650270098316988542046e2), 4.328810604912902668951e2);
  q = step(step(q, 4.853903996359136964868e2), 1.945506571482613964425e2);
  V angle = hn::MulAdd(tangent, hn::Mul(z, hn::Div(p, q)), tangent);
  angle = hn::Add(angle, hn::IfThenElseZero(is_diagonal, set(kPi / 4)));
  angle = hn::IfThenElse(hn::Gt(across, along), hn::Sub(set(kPi / 2), angle), angle);
  angle = hn::IfThenElse(hn::Lt(x, hn::Zero(d)), hn::Sub(set(kPi), angle), angle);
  return hn::CopySign(angle, y);
}

/// Where angles lie in a table.
template <class D>
struct Found {
  hn::Vec<hn::RebindToSigned<D>> offset;
  hn::Vec<D> fraction;
  hn::Mask<D> is_outside;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE Found<D> find_angles(D d, const AngleIndex& index, V angle) {
  const hn::RebindToSigned<D> di;
  const hn::Rebind<std::int32_t, D> di32;
  const auto set = [d](double value) HWY_ATTR { return hn::Set(d, value); };
  const V place = hn::Mul(hn::Sub(angle, set(index.first)), set(index.scale));
  const V bucket = hn::Min(hn::Max(place, hn::Zero(d)), set(index.last_bucket));
  auto interval = hn::GatherIndex(di, index.intervals.data(), hn::PromoteTo(di, hn::DemoteTo(di32, bucket)));
  for (;;) {
    const auto is_beyond = hn::Ge(angle, hn::GatherIndex(d, index.next.data(), interval));
    if (hn::AllFalse(d, is_beyond)) break;
    interval = hn::Sub(interval, hn::BitCast(di, hn::VecFromMask(d, is_beyond)));  // + 1
  }
  const V fraction = hn::Mul(hn::Sub(angle, hn::GatherIndex(d, index.low.data(), interval)),
                             hn::GatherIndex(d, index.reciprocal.data(), interval));
  return {hn::GatherIndex(di, index.offset.data(), interval), hn::Min(hn::Max(fraction, hn::Zero(d)), set(1)),
          hn::Or(hn::Lt(angle, set(index.first - kAngleTolerance)), hn::Gt(angle, set(index.last + kAngleTolerance)))};
}

/// The turn in the measured part of one.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V folded(D d, const CircleTable& table, V turn) {
  if (!table.is_c) return table.is_turn_mirrored ? hn::Abs(turn) : turn;
  const V whole = hn::Set(d, 2 * std::numbers::pi), half = hn::Set(d, std::numbers::pi);
  V offset = hn::Sub(turn, hn::Set(d, table.first_turn));
  offset = hn::Add(offset, hn::IfThenElseZero(hn::Lt(offset, hn::Zero(d)), whole));
  if (table.multiplicity >= 2) offset = hn::Min(offset, hn::Sub(whole, offset));
  if (table.multiplicity == 4) offset = hn::Min(offset, hn::Sub(half, offset));
  return hn::Min(offset, hn::Set(d, table.turn.last));
}

/// Intensities in units towards unit directions, bilinear between the measured angles.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V intensities(D d, const CircleTable& table, V pole, V ahead, V aside) {
  const V radius = hn::Sqrt(hn::MulAdd(ahead, ahead, hn::Mul(aside, aside)));
  const Found<D> turn = find_angles(d, table.turn, folded(d, table, arc_tangent(d, aside, ahead)));
  V angle = table.is_c ? arc_tangent(d, radius, pole) : arc_tangent(d, pole, radius);
  if (table.is_rise_mirrored) angle = hn::Abs(angle);
  const Found<D> rise = find_angles(d, table.rise, angle);
  const auto offset = hn::Add(turn.offset, rise.offset);
  const auto at_rise = [&](const double* candela) HWY_ATTR {
    const V low = hn::GatherIndex(d, candela, offset);
    const V high = hn::GatherIndex(d, candela + table.rise.stride, offset);
    return hn::MulAdd(rise.fraction, hn::Sub(high, low), low);
  };
  const V low = at_rise(table.intensity);
  V candela = hn::MulAdd(turn.fraction, hn::Sub(at_rise(table.intensity + table.turn.stride), low), low);
  if (table.is_c) {
    const V on_pole = hn::IfThenElse(hn::Gt(pole, hn::Zero(d)), hn::Set(d, table.nadir), hn::Set(d, table.zenith));
    candela = hn::IfThenElse(hn::Eq(radius, hn::Zero(d)), on_pole, candela);
  }
  candela = hn::IfThenZeroElse(hn::Or(turn.is_outside, rise.is_outside), candela);
  return hn::Mul(candela, hn::Set(d, 1 / table.unit));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_dark(D d, const Darkness& darkness, V pole, V ahead, V aside) {
  constexpr double kMargin = 1e-6;  // above the tolerance of measured angles
  const auto set = [d](double value) HWY_ATTR { return hn::Set(d, value); };
  const auto is_off = [&](double along_ahead, double along_aside) HWY_ATTR {  // within half a turn
    return hn::Gt(hn::NegMulAdd(set(along_aside), aside, hn::Mul(set(along_ahead), ahead)), set(kMargin));
  };
  const auto is_below = is_off(darkness.low_ahead, darkness.low_aside);
  const auto is_above = is_off(darkness.high_ahead, darkness.high_aside);
  const auto is_turned_off = darkness.is_wide ? hn::And(is_below, is_above) : hn::Or(is_below, is_above);
  const auto is_risen_off =
      hn::Or(hn::Lt(pole, set(darkness.least_pole - kMargin)), hn::Gt(pole, set(darkness.most_pole + kMargin)));
  return hn::Or(is_turned_off, is_risen_off);
}

Circle sample_circle(const CircleTable& table, const PoleCoordinates& forward, const Rim& rim, double angle) {
  const hn::CappedTag<double, kMostLanes> d;
  using V = hn::Vec<decltype(d)>;
  const std::size_t lanes = hn::Lanes(d);
  const auto set = [d](double value) HWY_ATTR { return hn::Set(d, value); };
  const V sine = set(std::sin(angle));
  const double cosine = std::cos(angle);
  const V forward_pole = set(cosine * forward.pole), forward_ahead = set(cosine * forward.ahead),
          forward_aside = set(cosine * forward.aside);
  double pole[kRoom], ahead[kRoom], aside[kRoom];
  std::size_t lit = 0;  // of directions that may be
  for (std::size_t i = 0; i < rim.count; i += lanes) {
    const V p = hn::MulAdd(sine, hn::LoadU(d, rim.pole.data() + i), forward_pole);
    const V ahead_i = hn::MulAdd(sine, hn::LoadU(d, rim.ahead.data() + i), forward_ahead);
    const V aside_i = hn::MulAdd(sine, hn::LoadU(d, rim.aside.data() + i), forward_aside);
    const auto is_lit = hn::AndNot(is_dark(d, table.darkness, p, ahead_i, aside_i), hn::FirstN(d, rim.count - i));
    hn::CompressStore(p, is_lit, d, pole + lit);
    hn::CompressStore(ahead_i, is_lit, d, ahead + lit);
    lit += hn::CompressStore(aside_i, is_lit, d, aside + lit);
  }
  if (lit == 0) return {};
  for (double* const column : {pole, ahead, aside}) hn::StoreU(set(1), d, column + lit);  // the last vector is whole
  V pivot = hn::Zero(d);  // the first intensity: sums of offsets from it lose no digits
  V sums = hn::Zero(d), squares = hn::Zero(d), least = hn::Zero(d), most = hn::Zero(d);
  for (std::size_t i = 0; i < lit; i += lanes) {
    const V value = intensities(d, table, hn::LoadU(d, pole + i), hn::LoadU(d, ahead + i), hn::LoadU(d, aside + i));
    if (i == 0) pivot = least = most = set(hn::GetLane(value));
    const V known = hn::IfThenElse(hn::FirstN(d, lit - i), value, pivot);
    const V offset = hn::Sub(known, pivot);
    sums = hn::Add(sums, offset);
    squares = hn::MulAdd(offset, offset, squares);
    least = hn::Min(least, known);
    most = hn::Max(most, known);
  }
  const bool is_partly_dark = lit < rim.count;
  const double first = hn::GetLane(pivot), count = double(rim.count), dark = count - double(lit);
  const double offset = (hn::GetLane(hn::SumOfLanes(d, sums)) - dark * first) / count;  // of the mean
  const double square = (hn::GetLane(hn::SumOfLanes(d, squares)) + dark * first * first) / count - offset * offset;
  const double mean = std::max(0.0, first + offset);
  const double lowest = is_partly_dark ? 0 : hn::GetLane(hn::MinOfLanes(d, least));
  const double highest = hn::GetLane(hn::MaxOfLanes(d, most));
  return {table.unit * mean, table.unit * std::max({0.0, mean - lowest, highest - mean}),
          table.unit * std::sqrt(std::max(0.0, square))};
}

}  // namespace litfog::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace litfog {

using std::numbers::pi;

AngleIndex::AngleIndex(std::span<const double> angles, std::size_t stride_given)
    : first(angles.front()), last(angles.back()), stride(stride_given) {
  const std::size_t count = angles.size() - 1;
  last_bucket = 2 * double(count);
  scale = last_bucket / (last - first);
  const auto bucket_of = [this](double angle) {  // as SIMD rounds it
    return std::size_t(std::clamp((angle - first) * scale, 0.0, last_bucket));
  };
  for (std::size_t bucket = 0, interval = 0; bucket <= 2 * count; ++bucket) {
    while (interval + 1 < count && bucket_of(angles[interval + 1]) < bucket) ++interval;
    intervals.push_back(std::int64_t(interval));
  }
  for (std::size_t i = 0; i < count; ++i) {
    low.push_back(angles[i]);
    next.push_back(i + 1 < count ? angles[i + 1] : std::numeric_limits<double>::infinity());
    reciprocal.push_back(1 / (angles[i + 1] - angles[i]));
    offset.push_back(std::int64_t(i * stride));
  }
}

CircleTable::CircleTable(const IntensityDistribution& distribution)
    : is_c(distribution.type == PhotometryType::c),
      nadir(intensity_at(distribution, kPhotometricAxis)),
      zenith(intensity_at(distribution, -kPhotometricAxis)),
      unit(std::exp2(std::ilogb(find_peak(distribution).intensity))),
      intensity(distribution.intensity.data()),
      darkness(distribution) {
  const auto& [type, horizontal, vertical, intensities] = distribution;
  const std::size_t rows = vertical.size();
  if (is_c) {
    rise = AngleIndex(vertical, 1);
    if (horizontal.size() == 1) {  // the same all round
      turn = AngleIndex(std::array{0.0, 2 * pi}, 0);
      return;
    }
    std::vector<double> offsets = horizontal;
    for (double& offset : offsets) offset -= horizontal.front();
    turn = AngleIndex(offsets, rows);
    first_turn = std::remainder(horizontal.front(), 2 * pi);
    multiplicity = turn_multiplicity(horizontal);
    return;
  }
  const bool is_a = type == PhotometryType::a;
  turn = is_a ? AngleIndex(horizontal, rows) : AngleIndex(vertical, 1);
  rise = is_a ? AngleIndex(vertical, 1) : AngleIndex(horizontal, rows);
  is_turn_mirrored = is_mirrored(is_a ? horizontal : vertical);
  is_rise_mirrored = is_mirrored(is_a ? vertical : horizontal);
}

CircleSampler::CircleSampler(const IntensityDistribution& distribution, const glm::dvec3& axis) : table_(distribution) {
  const glm::dmat3 luminaire_from_light = litfog::luminaire_from_light(axis);
  const auto coordinates_of = [&](double angle, double turn) {
    return pole_coordinates(distribution.type, luminaire_from_light * direction_of(PhotometryType::c, turn, angle));
  };
  forward_ = coordinates_of(0, 0);
  for (int i = 0; i < kEquatorSteps; ++i) {
    const auto [pole, ahead, aside] = coordinates_of(pi / 2, 2 * pi * i / kEquatorSteps);
    for (std::size_t stride = 1; Rim & rim : rims_) {
      if (std::size_t(i) % stride++ > 0) continue;
      rim.pole.push_back(pole);
      rim.ahead.push_back(ahead);
      rim.aside.push_back(aside);
    }
  }
  for (Rim& rim : rims_) {
    rim.count = rim.pole.size();
    for (auto* column : {&rim.pole, &rim.ahead, &rim.aside}) column->resize(rim.count + kMostLanes);  // whole vectors
  }
}

HWY_EXPORT(sample_circle);

Circle CircleSampler::at(double angle) const {
  const int wanted = std::max(kLeastSteps, int(std::ceil(kEquatorSteps * std::sin(angle))));
  const auto stride = std::size_t(kEquatorSteps / wanted);
  return HWY_DYNAMIC_DISPATCH(sample_circle)(table_, forward_, rims_[stride - 1], angle);
}

}  // namespace litfog
#endif
