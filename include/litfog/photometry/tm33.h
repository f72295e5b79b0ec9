// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "litfog/photometry/luminaire.h"

namespace litfog {

/// Whether text is an XML document with the root of ANSI/IES TM-33: IESTM33-18, IESTM33-22 (of TM-33-23), ATLA_S001_A,
/// or LuminaireOpticalData, as in UNI 11733 and ATLA S001. Its elements may have a namespace prefix.
bool is_tm33(std::string_view text);

/// Parses an ANSI/IES TM-33 file of at most 16 MiB. The standard's text was not available: the reader follows what
/// files and programs agree on. It reads
/// - an intensity for each pair of angles, `<IntData h="0" v="45">` or `<IntensityData horz="0" vert="45">`, in the
///   LuminousData of the one Emitter that has any, directly or in its LuminousIntensity or IntensityDistribution;
/// - their Multiplier and PhotometryType;
/// - the Emitter's RatedLumens times Quantity, which change no intensity; impossible values count as not stated.
/// The given planes determine the symmetry.
///
/// Errors: XML that is not well-formed, no or several emitters with intensities, a metric other than luminous, pairs of
/// angles missing or given twice, and the errors of parse_ies() in numbers, angles and intensities.
///
/// name       the file's, for messages
/// throws     InputError
Luminaire parse_tm33(std::string text, const std::string& name);

}  // namespace litfog
