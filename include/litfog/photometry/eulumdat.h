// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "litfog/photometry/luminaire.h"

namespace litfog {

/// Parses a EULUMDAT file (Stockmar 1990; EULUMDAT/2, 1998): one field a line. A decimal comma is read as a point. Text
/// is UTF-8, or else Latin-1.
///
/// Intensities are the file's cd/klm times its conversion factor times the flux of the first set of lamps (the others
/// are alternatives). The angles in the file are used; the distances Dc and Dg between them are not.
///
/// Errors, besides missing or malformed numbers: intensities < 0 or all 0, a conversion factor or flux <= 0, angles
/// beyond [0, 360] and [0, 180] or not increasing, more than 10,000 of them, planes that do not fit the symmetry,
/// numbers after the last intensity.
///
/// name       of the file, for messages
/// throws     InputError
Luminaire parse_eulumdat(std::string text, const std::string& name);

}  // namespace litfog
