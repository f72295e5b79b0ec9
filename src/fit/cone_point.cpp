// SPDX-License-Identifier: Apache-2.0
#include "fit/cone_point.h"

namespace litfog {

std::vector<ConePoint> points_of(const ConeTarget& target) {
  std::vector<ConePoint> points;
  if (target.beam_angle || target.field_angle) points.emplace_back(0, 1, 1);
  if (target.beam_angle) points.emplace_back(*target.beam_angle / 2, kBeamLevel, 1);
  if (target.field_angle) points.emplace_back(*target.field_angle / 2, kFieldLevel, 1);
  const double peak = peak_of(target.samples);
  for (const auto& [angle, intensity, weight] : target.samples) points.emplace_back(angle, intensity / peak, weight);
  std::stable_sort(points.begin(), points.end(),
                   [](const ConePoint& a, const ConePoint& b) { return a.angle < b.angle; });
  return points;
}

}  // namespace litfog
