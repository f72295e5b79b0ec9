// SPDX-License-Identifier: Apache-2.0
#include "photometry/circle_sampler.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <limits>
#include <numbers>

namespace litfog {
namespace {

using std::numbers::pi;

using Column = std::array<double, kEquatorSteps>;

/// std::atan2(y, x) without branches and calls, so that compilers vectorise loops; 0 for two zeros. Circles differ from
/// those by std::atan2 by 1e-12. The rational function is from Cephes (S. L. Moshier, atan.c), which is valid to 0.66:
/// the tangent is reduced to at most tan(pi / 8).
inline double arc_tangent(double y, double x) {
  const double across = std::abs(y), along = std::abs(x);
  const double least = std::min(across, along), most = std::max(across, along);
  const bool is_diagonal = least > 0.41421356237309503 * most;
  const double numerator = is_diagonal ? least - most : least;
  const double denominator = is_diagonal ? least + most : most;
  const double tangent = numerator / std::max(denominator, std::numeric_limits<double>::min());
  const double z = tangent * tangent;
  double p = z * -8.750608600031904122785e-1 - 1.615753718733365076637e1;
  p = (p * z - 7.500855792314704667340e1) * z - 1.228866684490136173410e2;
  p = p * z - 6.485021904942025371773e1;
  double q = z + 2.485846490142306297962e1;
  q = (q * z + 1.650270098316988542046e2) * z + 4.328810604912902668951e2;
  q = (q * z + 4.853903996359136964868e2) * z + 1.945506571482613964425e2;
  double angle = tangent + tangent * (z * (p / q));
  angle += is_diagonal ? pi / 4 : 0;
  angle = across > along ? pi / 2 - angle : angle;
  angle = x < 0 ? pi - angle : angle;
  return std::copysign(angle, y);
}

void take_arc_tangents(const Column& y, const Column& x, std::size_t count, Column& angles) {
  for (std::size_t i = 0; i < count; ++i) angles[i] = arc_tangent(y[i], x[i]);
}

/// A turn folded into the measured part.
inline double folded(const CircleTable& table, double turn) {
  if (!table.is_c) return table.is_turn_mirrored ? std::abs(turn) : turn;
  double offset = turn - table.first_turn;
  offset += offset < 0 ? 2 * pi : 0;
  if (table.multiplicity >= 2) offset = std::min(offset, 2 * pi - offset);
  if (table.multiplicity == 4) offset = std::min(offset, pi - offset);
  return std::min(offset, table.turn.last);
}

/// Bilinear between the measured angles.
inline double intensity_between(const CircleTable& table, double turn, double rise) {
  if (table.turn.is_outside(turn) || table.rise.is_outside(rise)) return 0;
  const std::size_t turn_interval = table.turn.interval(turn), rise_interval = table.rise.interval(rise);
  const double turn_fraction = table.turn.fraction(turn_interval, turn);
  const double rise_fraction = table.rise.fraction(rise_interval, rise);
  const double* const low = table.intensity + turn_interval * table.turn.stride + rise_interval * table.rise.stride;
  const double* const high = low + table.turn.stride;
  const double at_low = low[0] + rise_fraction * (low[table.rise.stride] - low[0]);
  const double at_high = high[0] + rise_fraction * (high[table.rise.stride] - high[0]);
  return at_low + turn_fraction * (at_high - at_low);
}

}  // namespace

CircleTable::CircleTable(const IntensityDistribution& distribution)
    : is_c(distribution.type == PhotometryType::c),
      nadir(intensity_at(distribution, kPhotometricAxis)),
      zenith(intensity_at(distribution, -kPhotometricAxis)),
      unit(std::exp2(std::max(std::ilogb(std::ranges::max(distribution.intensity)), -1000))),
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
    const PoleCoordinates direction = coordinates_of(pi / 2, 2 * pi * i / kEquatorSteps);
    for (int stride = 1; std::vector<PoleCoordinates> & rim : rims_) {
      if (i % stride++ == 0) rim.push_back(direction);
    }
  }
}

Circle CircleSampler::at(double angle) const {
  const double sine = std::sin(angle), cosine = std::cos(angle);
  const int wanted = std::max(kMinSteps, int(std::ceil(kEquatorSteps * sine)));
  const std::vector<PoleCoordinates>& rim = rims_[std::size_t(kEquatorSteps / wanted) - 1];
  Column pole, ahead, aside, radius, turns, rises;
  std::size_t lit = 0;  // number of directions that may be lit
  for (const PoleCoordinates& at_rim : rim) {
    const PoleCoordinates direction{cosine * forward_.pole + sine * at_rim.pole,
                                    cosine * forward_.ahead + sine * at_rim.ahead,
                                    cosine * forward_.aside + sine * at_rim.aside};
    pole[lit] = direction.pole;
    ahead[lit] = direction.ahead;
    aside[lit] = direction.aside;
    lit += table_.darkness.holds(direction) ? 0 : 1;
  }
  if (lit == 0) return {};
  for (std::size_t i = 0; i < lit; ++i) radius[i] = std::sqrt(ahead[i] * ahead[i] + aside[i] * aside[i]);
  take_arc_tangents(aside, ahead, lit, turns);
  take_arc_tangents(table_.is_c ? radius : pole, table_.is_c ? pole : radius, lit, rises);
  const double per_unit = 1 / table_.unit;
  const auto value_at = [&](std::size_t i) {
    if (table_.is_c && radius[i] == 0) return (pole[i] > 0 ? table_.nadir : table_.zenith) * per_unit;
    const double rise = table_.is_rise_mirrored ? std::abs(rises[i]) : rises[i];
    return intensity_between(table_, folded(table_, turns[i]), rise) * per_unit;
  };
  const double pivot = value_at(0);  // sums of offsets from a pivot lose no digits
  double sum = 0, squares = 0, least = pivot, most = pivot;
  for (std::size_t i = 1; i < lit; ++i) {
    const double value = value_at(i), offset = value - pivot;
    sum += offset;
    squares += offset * offset;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  const double count = double(rim.size()), dark = count - double(lit);
  const double offset = (sum - dark * pivot) / count;  // the mean's offset from the pivot
  const double square = (squares + dark * pivot * pivot) / count - offset * offset;
  const double mean = std::max(0.0, pivot + offset);
  if (dark > 0) least = 0;
  const double deviation = std::max({0.0, mean - least, most - mean}), rms = std::sqrt(std::max(0.0, square));
  return {table_.unit * mean, table_.unit * deviation, table_.unit * rms};
}

}  // namespace litfog
