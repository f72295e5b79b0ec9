// SPDX-License-Identifier: Apache-2.0
#include "photometry/photometric_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "model/float_limit.h"
#include "text/number_text.h"

namespace litfog {
namespace {

constexpr int kMaxAngles = 10'000;
constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr double kNoGap = 1e-9;  // degrees: what rounding may leave of none

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
    const double angle = with_right_angles(scanner_.number(piece, what));
    if (!(angle >= low && angle <= high)) {
      scanner_.fail(piece, name(), range_rule(low, high));
    }
    if (i > 0 && (angle < angles.back() || is_same_angle(angle, angles.back()))) {
      scanner_.fail(piece, name(), "must be greater than the one before, " + number_text(angles.back()));
    }
    angles.push_back(angle);
  }
  return angles;
}

std::vector<double> PhotometricGrid::intensities(std::size_t count, double factor) {
  IntensityReader reader(scanner_, count, factor);
  for (std::size_t i = 0; i < count; ++i) reader.add(scanner_.next(unit_));
  largest_ = reader.largest();
  return reader.finish();
}

std::string IntensityReader::name(std::size_t index) const { return name_of("intensity", index, count_); }

void IntensityReader::add(const TextScanner::Piece& piece) {
  const std::size_t index = intensities_.size();
  if (piece.text.empty()) scanner_.fail(piece, name(index), "");
  const double candela = snapped(scanner_.number(piece, "intensity") * factor_, -kMaxIntensity, kMaxIntensity);
  if (!(candela <= kMaxIntensity)) {
    scanner_.fail(piece, name(index), "must be at most 1e30 candela, with all factors");
  }
  if (candela > largest_candela_) {
    largest_candela_ = candela;
    largest_ = piece;
  }
  if (candela < least_candela_) {
    least_candela_ = candela;
    least_ = piece;
    least_index_ = index;
  }
  last_ = piece;
  intensities_.push_back(std::max(candela, 0.0));
}

std::vector<double> IntensityReader::finish() {
  if (least_candela_ < -kMaxNegative * largest_candela_) scanner_.fail(least_, name(least_index_), "must be >= 0");
  if (largest_candela_ == 0) scanner_.fail(last_, name(intensities_.size() - 1), "must not be 0 as all others are");
  return std::move(intensities_);
}

std::optional<double> lamp_flux_of(double lamps, double lumens) {
  constexpr double kMaxLamps = 1e6;
  const double flux = lamps * lumens;
  const bool can_be = lamps >= 1 && lamps <= kMaxLamps && lamps == std::floor(lamps) && flux > 0 && std::isfinite(flux);
  return can_be ? std::optional(flux) : std::nullopt;
}

bool is_turn(const std::vector<double>& planes_deg) {
  const double first = planes_deg.front(), span = planes_deg.back() - first;
  if (planes_deg.size() == 1 || (std::abs(first) == 90 && span == 180)) return true;
  if (first == 0 && (span == 90 || span == 180)) return true;
  return (first == 0 || first == -180) && span > 180 && is_closed_turn(planes_deg);
}

bool is_closed_turn(const std::vector<double>& planes_deg) {
  double widest = 0;
  for (std::size_t i = 1; i < planes_deg.size(); ++i) widest = std::max(widest, planes_deg[i] - planes_deg[i - 1]);
  const double gap = planes_deg.front() + 360 - planes_deg.back();
  return gap >= -kNoGap && gap <= widest * (1 + 1e-9);
}

void close_turn(std::vector<double>& planes_deg, std::vector<double>& intensity) {
  if (planes_deg.front() + 360 - planes_deg.back() <= kNoGap) return;
  const std::vector<double> first_plane(intensity.begin(),
                                        intensity.begin() + std::ptrdiff_t(intensity.size() / planes_deg.size()));
  planes_deg.push_back(planes_deg.front() + 360);
  intensity.reserve(intensity.size() + first_plane.size());  // no more, because there may be millions
  intensity.insert(intensity.end(), first_plane.begin(), first_plane.end());
}

std::string range_rule(double low, double high) {
  return "must be in [" + number_text(low) + ", " + number_text(high) + "]";
}

double with_right_angles(double degrees) {
  const double right = 90 * std::round(degrees / 90);
  return is_float_of(right, degrees) ? right : degrees;
}

bool is_same_angle(double a_deg, double b_deg) { return a_deg * kRadiansPerDegree == b_deg * kRadiansPerDegree; }

std::vector<double> radians_from_degrees(std::vector<double> angles) {
  for (double& angle : angles) angle *= kRadiansPerDegree;
  return angles;
}

IntensityDistribution distribution_of_degrees(PhotometryType type, std::vector<double> horizontal,
                                              std::vector<double> vertical, std::vector<double> intensity) {
  IntensityDistribution distribution{type, radians_from_degrees(std::move(horizontal)),
                                     radians_from_degrees(std::move(vertical)), std::move(intensity)};
  assert(!find_error(distribution));
  return distribution;
}

}  // namespace litfog
