// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "litfog/input_error.h"
#include "litfog/photometry/intensity_distribution.h"

namespace litfog {

/// How a lamp's output changes as its luminaire is tilted from the attitude in which it was measured (IES LM-63, TILT).
/// The intensities are those of that attitude; the factor of another attitude multiplies them all. It is stored, not
/// applied, because a file does not state how its luminaire will be mounted.
struct LampTilt {
  std::string file = {};        ///< with these data, as found; empty if they stand in the luminaire's own
  int geometry = 1;             ///< 1: the lamp is vertical; 2, 3: horizontal, in the plane of 0 or of 90 degrees
  std::vector<double> angles;   ///< radians in [0, pi], strictly increasing
  std::vector<double> factors;  ///< > 0, one per angle
};

/// The luminous opening in metres. A negative size is the diameter of a round one (IES LM-63), 0 is none.
struct LuminousOpening {
  double width = 0;   ///< across the plane of 0 degrees
  double length = 0;  ///< along it
  double height = 0;
};

/// What a photometric file states about a luminaire.
struct Luminaire {
  std::string file = {};     ///< as named to the reader
  std::string name;          ///< UTF-8, as all text; empty if the file does not state it
  std::string manufacturer;  ///< likewise
  IntensityDistribution distribution;
  InputLocation peak_location;  ///< of the largest intensity in the file

  /// Rated flux of all its lamps in lumens, > 0; nothing if the file does not state it, as in absolute IES photometry.
  std::optional<double> lamp_flux;
  /// Stated fraction of the lamps' flux that leaves the luminaire (EULUMDAT's LORL).
  std::optional<double> light_output_ratio;
  bool is_absolute = false;  ///< measured as a whole, without separate ratings of its lamps

  LuminousOpening opening;
  std::optional<LampTilt> tilt;
};

/// The luminaire's flux in lumens as its file states it, to compare with luminous_flux(distribution): lamp_flux *
/// light_output_ratio, which only EULUMDAT has.
std::optional<double> stated_flux(const Luminaire& luminaire);

/// What reading a photometric file takes at most, in bytes: its text, its numbers and their copies.
inline constexpr std::size_t kMaxLuminaireMemory = std::size_t{1} << 30;

/// Reads an IES LM-63 or EULUMDAT file or an isocandela table. It is a table if it has the header of one or if its name
/// ends in .csv; it is IES LM-63 if it has that label or a TILT line, or if its name ends in .ies; else it is EULUMDAT.
///
/// The file, and that with the tilt data, may have 64 MiB each. Reading takes less than kMaxLuminaireMemory, whatever
/// counts a file states.
///
/// throws     InputError
Luminaire read_luminaire(const std::string& path);

}  // namespace litfog
