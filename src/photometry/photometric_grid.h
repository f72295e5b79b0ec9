// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "litfog/photometry/intensity_distribution.h"
#include "text_scanner.h"

namespace litfog {

/// Angles and intensities as both kinds of photometric file hold them: read in degrees, one piece each. Nothing is
/// allocated for a count, only for what is read.
class PhotometricGrid {
 public:
  PhotometricGrid(TextScanner& scanner, TextScanner::Unit unit) : scanner_(scanner), unit_(unit) {}

  /// The number of angles: an integer from `least` to 10,000.
  int count(std::string_view what, int least);
  /// Strictly increasing angles within [low, high] degrees.
  std::vector<double> angles(std::string_view what, int count, double low, double high);
  /// Intensities times a factor: candela.
  std::vector<double> intensities(std::size_t count, double factor);
  /// What was read last, for an error.
  const TextScanner::Piece& last() const { return last_; }
  /// The largest intensity that was read.
  const TextScanner::Piece& largest() const { return largest_; }

 private:
  TextScanner& scanner_;
  TextScanner::Unit unit_;
  TextScanner::Piece last_{};
  TextScanner::Piece largest_{};
};

/// Whether planes of type C in degrees go all round: the gap to the first one is no wider than the widest step.
bool is_closed_turn(const std::vector<double>& planes_deg);

/// Adds the first plane again where the turn of such planes ends, unless it is there.
void close_turn(std::vector<double>& planes_deg, std::vector<double>& intensity);

std::vector<double> radians_from_degrees(std::vector<double> angles);

}  // namespace litfog
