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
/// The file's intensities are for that attitude; in another, tilt_factor() multiplies them all. Readers store the tilt
/// data without applying them, because a file does not state how its luminaire will be mounted.
struct LampTilt {
  std::string file = {};        ///< path of the file with these data; empty if the luminaire's own file has them
  int geometry = 1;             ///< 1: the lamp is vertical; 2, 3: horizontal, in the plane of 0 or of 90 degrees
  std::vector<double> angles;   ///< radians in [0, pi], strictly increasing
  std::vector<double> factors;  ///< > 0, one per angle
};

/// The luminous opening in metres. A negative size is a diameter of a round opening (IES LM-63); 0 is none.
struct LuminousOpening {
  double width = 0;   ///< across the plane of 0 degrees
  double length = 0;  ///< along that plane
  double height = 0;
};

/// Metres: an opening whose disc is smaller counts as none, because files state such sizes for a point.
inline constexpr double kMinOpeningRadius = 1e-3;

/// Radius in metres of a disc with the opening's area; 0 without an opening. The area is width times length; if one of
/// them is 0, the other times height. Two negative sizes are the axes of an ellipse; one alone, or with the height of a
/// cylinder, is the diameter of a circle.
double opening_radius(const LuminousOpening& opening);

/// What a photometric file states about a luminaire.
struct Luminaire {
  std::string file = {};     ///< path as given to the reader
  std::string name;          ///< UTF-8, like all text; empty if not stated
  std::string manufacturer;  ///< empty if not stated
  IntensityDistribution distribution;
  InputLocation peak_location;  ///< where the file has the largest intensity

  /// Rated flux of all lamps in lumens, > 0; nothing if not stated, as in absolute IES photometry, or impossible.
  std::optional<double> lamp_flux;
  /// Stated fraction of the lamps' flux that leaves the luminaire (EULUMDAT's LORL).
  std::optional<double> light_output_ratio;
  bool is_absolute = false;    ///< measured as a whole, without separate ratings of its lamps
  bool is_isocandela = false;  ///< from an isocandela table: the beam is ahead, wherever its lamp is pointed

  LuminousOpening opening;
  std::optional<LampTilt> tilt;
};

/// The flux in lumens that the file states, to compare with luminous_flux(distribution): lamp_flux *
/// light_output_ratio, which only EULUMDAT has.
std::optional<double> stated_flux(const Luminaire& luminaire);

/// Upper bound of the memory for reading a photometric file, in bytes: its text, its numbers and their copies.
inline constexpr std::size_t kMaxLuminaireMemory = std::size_t{1} << 30;

/// The factor on a lamp's output, linear between the file's angles and constant beyond them.
///
/// angle      between the luminaire's attitude and the one in which it was measured, radians in [0, pi]
/// throws     std::invalid_argument naming field, value and rule
double tilt_factor(const LampTilt& tilt, double angle);

/// Reads a photometric file and recognises its kind from the content: IES LM-63 (ies.h), EULUMDAT (eulumdat.h), TM-33
/// (tm33.h), an isocandela table (isocandela.h), or a GLDF container. From a container it reads the only photometric
/// file, or the one that a path of list_gldf() (gldf.h) names.
///
/// The file, its file of tilt data, and a file in a container may have 64 MiB each, XML files 16 MiB. Reading takes
/// less than kMaxLuminaireMemory, whatever counts a file states.
///
/// throws     InputError
Luminaire read_luminaire(const std::string& path);

}  // namespace litfog
