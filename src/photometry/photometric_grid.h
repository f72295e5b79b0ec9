// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "litfog/photometry/intensity_distribution.h"
#include "photometry/text_scanner.h"

namespace litfog {

/// How far an intensity may lie below zero, as a fraction of the largest: the noise of a dark direction.
inline constexpr double kMaxNegative = 1e-3;

/// Reads intensities, one piece each, and scales them to candela. Those below zero by no more than kMaxNegative of the
/// largest are 0.
class IntensityReader {
 public:
  /// count  for errors: "intensity 12 of 361"
  IntensityReader(const TextScanner& scanner, std::size_t count, double factor)
      : scanner_(scanner), count_(count), factor_(factor) {}

  void add(const TextScanner::Piece& piece);
  /// The intensities added, one or more, checked as a whole.
  std::vector<double> finish();
  /// The largest intensity that was added.
  const TextScanner::Piece& largest() const { return largest_; }

 private:
  std::string name(std::size_t index) const;

  const TextScanner& scanner_;
  std::size_t count_;
  double factor_;
  std::vector<double> intensities_ = {};
  std::size_t least_index_ = 0;
  TextScanner::Piece last_{};
  TextScanner::Piece least_{};
  TextScanner::Piece largest_{};
  double least_candela_ = 0;
  double largest_candela_ = 0;
};

/// Angles and intensities as in both kinds of plain photometric file: in degrees, one piece each. Memory is allocated
/// only for what is read, never for a stated count.
class PhotometricGrid {
 public:
  PhotometricGrid(TextScanner& scanner, TextScanner::Unit unit) : scanner_(scanner), unit_(unit) {}

  /// The number of angles: an integer from `least` to 10,000.
  int count(std::string_view what, int least);
  /// Strictly increasing angles within [low, high] degrees.
  std::vector<double> angles(std::string_view what, int count, double low, double high);
  /// Intensities, by the rules of IntensityReader.
  std::vector<double> intensities(std::size_t count, double factor);
  /// The piece read last, for an error.
  const TextScanner::Piece& last() const { return last_; }
  /// The largest intensity that was read.
  const TextScanner::Piece& largest() const { return largest_; }

 private:
  TextScanner& scanner_;
  TextScanner::Unit unit_;
  TextScanner::Piece last_{};
  TextScanner::Piece largest_{};
};

/// The rated flux of all lamps. No intensity depends on it, so an impossible number of lamps or flux counts as not
/// stated.
std::optional<double> lamp_flux_of(double lamps, double lumens);

/// The range of a type's angles, in degrees.
struct AngleLimits {
  double least_horizontal, most_horizontal, least_vertical, most_vertical;
};
constexpr AngleLimits limits_of(PhotometryType type) {
  switch (type) {
    case PhotometryType::a:
      return {-180, 180, -90, 90};
    case PhotometryType::b:
      return {-90, 90, -180, 180};
    case PhotometryType::c:
      break;
  }
  return {-180, 360, 0, 180};
}

/// Whether planes of type C span the whole turn, or the part left by a symmetry.
bool is_turn(const std::vector<double>& planes_deg);
inline constexpr const char* kTurns =  ///< those planes, for messages
    "planes at 0, from 0 to 90, 180 or 360, from 90 to 270, from -90 to 90, or from -180 to 180";

/// Whether planes of type C in degrees go once round: the gap to the first one is at most the widest step, and none lie
/// beyond it.
bool is_closed_turn(const std::vector<double>& planes_deg);

/// Closes a turn for which is_closed_turn(): repeats the first plane at the end, unless it is there.
void close_turn(std::vector<double>& planes_deg, std::vector<double>& intensity);

/// "must be in [-90, 90]"
std::string range_rule(double low, double high);

/// An angle, snapped to a multiple of 90 degrees, where parts of a turn end, if it differs only by a float's rounding.
double with_right_angles(double degrees);

/// Whether angles in degrees round to the same in radians.
bool is_same_angle(double a_deg, double b_deg);

std::vector<double> radians_from_degrees(std::vector<double> angles);

/// The distribution at angles in degrees, all of which the reader has checked.
IntensityDistribution distribution_of_degrees(PhotometryType type, std::vector<double> horizontal,
                                              std::vector<double> vertical, std::vector<double> intensity);

}  // namespace litfog
