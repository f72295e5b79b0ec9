// SPDX-License-Identifier: Apache-2.0
#include "photometry/darkness.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "photometry/angle_index.h"

namespace litfog {
namespace {

bool is_plane_lit(const IntensityDistribution& distribution, std::size_t horizontal) {
  const auto first = distribution.intensity.begin() + std::ptrdiff_t(horizontal * distribution.vertical.size());
  const auto last = first + std::ptrdiff_t(distribution.vertical.size());
  return std::any_of(first, last, [](double candela) { return candela > 0; });
}

struct AngleRange {
  double low, high;
};

/// The angles beyond which all is dark, on both sides if angles are mirrored.
template <typename IsLit>
AngleRange lit_range(std::span<const double> angles, bool is_mirrored, const IsLit& is_lit_at) {
  std::size_t first = 0, last = angles.size() - 1;
  while (first < last && !is_lit_at(first)) ++first;
  while (last > first && !is_lit_at(last)) --last;
  const double high = angles[std::min(last + 1, angles.size() - 1)];
  return is_mirrored ? AngleRange{-high, high} : AngleRange{angles[first == 0 ? 0 : first - 1], high};
}

}  // namespace

bool is_row_lit(const IntensityDistribution& distribution, std::size_t vertical) {
  const std::size_t rows = distribution.vertical.size();
  for (std::size_t h = 0; h < distribution.horizontal.size(); ++h) {
    if (distribution.intensity[h * rows + vertical] > 0) return true;
  }
  return false;
}

Darkness::Darkness(const IntensityDistribution& distribution) {
  const auto& [type, horizontal, vertical, intensity] = distribution;
  const bool is_c = type == PhotometryType::c;
  const auto in_rows =
      lit_range(vertical, !is_c && is_mirrored(vertical), [&](std::size_t v) { return is_row_lit(distribution, v); });
  if (is_c) {
    least_pole_ = std::cos(in_rows.high);
    most_pole_ = std::cos(in_rows.low);
    return;
  }
  const auto in_planes =
      lit_range(horizontal, is_mirrored(horizontal), [&](std::size_t h) { return is_plane_lit(distribution, h); });
  const bool is_a = type == PhotometryType::a;
  const auto [elevation, turn] = is_a ? std::pair(in_rows, in_planes) : std::pair(in_planes, in_rows);
  least_pole_ = std::sin(elevation.low);
  most_pole_ = std::sin(elevation.high);
  low_ahead_ = std::sin(turn.low);
  low_aside_ = std::cos(turn.low);
  high_ahead_ = -std::sin(turn.high);
  high_aside_ = -std::cos(turn.high);
  is_wide_ = turn.high - turn.low > std::numbers::pi;
}

}  // namespace litfog
