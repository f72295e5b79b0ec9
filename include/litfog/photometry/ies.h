// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "litfog/photometry/luminaire.h"

namespace litfog {

/// Whether text is an IES LM-63 file: it begins with IESNA or IES:LM-63, or has a line with TILT=.
bool is_ies(std::string_view text);

/// Parses an IES LM-63 file of any edition: 1986 (without label), 1991, 1995, 2002, 2019. Numbers may be separated by
/// white space, commas and line ends. Counts may be decimals, and exponents Fortran's (1.5D+03). Text is UTF-8, UTF-16,
/// or in a code page, which is guessed.
///
/// Intensities are the file's values times its multiplier, its ballast factor and, in 1986 and 1991 only, the
/// ballast-lamp photometric factor (later editions use its field otherwise). Neither the number of lamps nor TILT
/// changes them. A field that does not affect intensities may be any number; an impossible number counts as not stated.
/// Intensities below 0 by no more than 0.1 % of the largest are noise in dark directions and become 0.
///
/// Errors, besides missing or malformed numbers: intensities further below 0 or all 0, a multiplier or factor <= 0,
/// angles beyond their type's range or not increasing, more than 10,000 angles, two or more horizontal angles of type C
/// that span neither 360 degrees nor the part of it that a symmetry needs, numbers after the last intensity. If the
/// last plane is short of 360 degrees by no more than the widest step, the first plane closes the circle.
///
/// name       the file's, for messages; TILT=file is looked for below its folder
/// throws     InputError
Luminaire parse_ies(std::string text, const std::string& name);

}  // namespace litfog
