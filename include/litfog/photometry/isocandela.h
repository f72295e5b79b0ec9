// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "litfog/photometry/luminaire.h"

namespace litfog {

// clang-format off
/// Isocandela tables: CSV with commas and decimal points, or with semicolons and decimal points or commas; cells may be
/// in quotes. With semicolons, 1.200 is an error, because it may mean thousands, unless no cell has a comma and another
/// has a point that can only be decimal, as in 0.5. Lines that begin with # are comments; the first is the light's
/// name. The light's axis is at 0, 0. The header says which kind of table it is.
///
/// A grid's header has horizontal angles, to the right of the axis. Each row has a vertical angle, above the axis, and
/// the candela there. Angles are degrees of type A (litfog/photometry/intensity_distribution.h). The horizontal angles
/// increase, the vertical ones go one way. There are at least two of each; angles that begin at 0 are mirrored.
///
///     # position light, left
///     vertical_deg,-110,-20,-10,0
///     30,1.5,9,12,12
///     0,5,30,40,40
///
/// Ellipses, 1000 at most, have a row each, from the inner to the outer, with half axes in degrees (elliptical_beam()).
/// Within the first, the light has the first one's candela; beyond the last, it has none.
///
///     # approach side row light
///     candela,horizontal_deg,vertical_deg
///     5000,7,5
///     500,11.5,6
// clang-format on

/// Whether a text has the header of an isocandela table.
bool is_isocandela(std::string_view text);

/// Parses an isocandela table.
///
/// name       the file's, for messages
/// throws     InputError with the line and column of what is wrong
Luminaire parse_isocandela(std::string text, const std::string& name);

}  // namespace litfog
