// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "litfog/photometry/luminaire.h"

namespace litfog {

/// Whether text begins like a EULUMDAT file: after the company, a type indicator from 0 to 3 and a symmetry indicator
/// from 0 to 4.
bool is_eulumdat(std::string_view text);

/// Parses a EULUMDAT file (Stockmar 1990; EULUMDAT/2, 1998): one field per line. Decimal commas and Fortran exponents
/// (1.5D+03) are accepted. Text is UTF-8, UTF-16, or in a code page, which is guessed.
///
/// Intensities are the file's cd/klm times its conversion factor times the flux of the first set of lamps (the others
/// are alternatives). The file's angles are used, not the distances Dc and Dg between them. A field that does not
/// affect intensities may be blank or any number; an impossible number counts as not stated.
///
/// Intensities below 0 by no more than 0.1 % of the largest are noise in dark directions and become 0.
///
/// Errors, besides missing or malformed numbers: intensities further below 0 or all 0, a conversion factor or flux <=
/// 0, angles beyond [-180, 360] and [0, 180] or not increasing, more than 10,000 angles, planes that do not fit the
/// symmetry, numbers after the last intensity.
///
/// name       the file's, for messages
/// throws     InputError
Luminaire parse_eulumdat(std::string text, const std::string& name);

}  // namespace litfog
