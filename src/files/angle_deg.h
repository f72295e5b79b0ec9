// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <string>

namespace litfog::files {

/// An angle in a file, in radians. Exact at 90 and 180 degrees, where the model's ranges end.
inline double radians(double degrees) { return degrees / 180 * std::numbers::pi; }

/// The inverse of radians(): among the doubles next to the quotient the one with the fewest digits that reads back as
/// the same angle, or the quotient if there is none.
double degrees(double radians);

/// degrees() as text for a sentence.
std::string shown_degrees(double radians);

}  // namespace litfog::files
