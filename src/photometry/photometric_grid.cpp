// SPDX-License-Identifier: Apache-2.0
#include "photometric_grid.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>

namespace litfog {
namespace {

constexpr int kMaxAngles = 10'000;
constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr double kMaxCandela = 1e30;  // as check(IntensityDistribution) asks

std::string as_written(double x) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

/// "candela value 12 of 361"
std::string name_of(std::string_view what, std::size_t index, std::size_t count) {
  return std::string(what) + " " + std::to_string(index + 1) + " of " + std::to_string(count);
}

}  // namespace

int PhotometricGrid::count(std::string_view what, int least) {
  return scanner_.integer(scanner_.next(unit_), what, least, kMaxAngles);
}

std::vector<double> PhotometricGrid::angles(std::string_view what, int count, double low, double high) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) {
    const TextScanner::Piece& piece = last_ = scanner_.next(unit_);
    const auto name = [&] { return name_of(what, std::size_t(i), std::size_t(count)); };
    if (piece.text.empty()) scanner_.fail(piece, name(), "");
    const double angle = scanner_.number(piece, what);
    if (!(angle >= low && angle <= high)) {
      scanner_.fail(piece, name(), "must be in [" + as_written(low) + ", " + as_written(high) + "]");
    }
    if (i > 0 && !(angle * kRadiansPerDegree > angles.back() * kRadiansPerDegree)) {  // they may round to the same
      scanner_.fail(piece, name(), "must be greater than the one before, " + as_written(angles.back()));
    }
    angles.push_back(angle);
  }
  return angles;
}

std::vector<double> PhotometricGrid::intensities(std::size_t count, double factor) {
  std::vector<double> intensities;
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const TextScanner::Piece& piece = last_ = scanner_.next(unit_);
    if (piece.text.empty()) scanner_.fail(piece, name_of("intensity", i, count), "");
    const double intensity = scanner_.number(piece, "intensity");
    const double candela = intensity * factor;
    if (!(intensity >= 0)) scanner_.fail(piece, name_of("intensity", i, count), "must be >= 0");
    if (!(candela <= kMaxCandela)) {
      scanner_.fail(piece, name_of("intensity", i, count), "must be at most 1e30 candela, with all factors");
    }
    if (candela > largest) {
      largest = candela;
      largest_ = piece;
    }
    intensities.push_back(candela);
  }
  if (largest == 0) scanner_.fail(last_, name_of("intensity", count - 1, count), "must not be 0 as all others are");
  return intensities;
}

bool is_closed_turn(const std::vector<double>& planes_deg) {
  double widest = 0;
  for (std::size_t i = 1; i < planes_deg.size(); ++i) widest = std::max(widest, planes_deg[i] - planes_deg[i - 1]);
  return planes_deg.front() + 360 - planes_deg.back() <= widest * (1 + 1e-9);
}

void close_turn(std::vector<double>& planes_deg, std::vector<double>& intensity) {
  constexpr double kNone = 1e-9;
  if (planes_deg.front() + 360 - planes_deg.back() <= kNone) return;
  const std::vector<double> first_plane(intensity.begin(),
                                        intensity.begin() + std::ptrdiff_t(intensity.size() / planes_deg.size()));
  planes_deg.push_back(planes_deg.front() + 360);
  intensity.reserve(intensity.size() + first_plane.size());  // all that it may take, where there are millions
  intensity.insert(intensity.end(), first_plane.begin(), first_plane.end());
}

std::vector<double> radians_from_degrees(std::vector<double> angles) {
  for (double& angle : angles) angle *= kRadiansPerDegree;
  return angles;
}

}  // namespace litfog
