// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "litfog/photometry/luminaire.h"

namespace litfog {

/// Whether text is an XML document with the root of ANSI/IES TM-33: IESTM33-18, IESTM33-22 (of TM-33-23), ATLA_S001_A,
/// or LuminaireOpticalData, as in UNI 11733 and ATLA S001. Its elements may have the prefix of a namespace.
bool is_tm33(std::string_view text);

/// Parses an ANSI/IES TM-33 file of at most 16 MiB. The text of the standard was not at hand: the reader follows what
/// files and programs agree on. That is an intensity for each pair of angles, `<IntData h="0" v="45">` or
/// `<IntensityData horz="0" vert="45">`, in the LuminousData of the one Emitter that has any, directly or in its
/// LuminousIntensity or IntensityDistribution; their Multiplier and PhotometryType; and the Emitter's RatedLumens times
/// Quantity, which change no intensity and count as not stated where they are impossible. The symmetry is that of the
/// planes given.
///
/// Errors: XML that is not well-formed, no or several emitters with intensities, a metric other than luminous, pairs of
/// angles missing or given twice, and what parse_ies() names of numbers, angles and intensities.
///
/// name       the file's, for messages
/// throws     InputError
Luminaire parse_tm33(std::string text, const std::string& name);

}  // namespace litfog
