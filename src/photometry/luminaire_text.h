// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "litfog/photometry/luminaire.h"

namespace litfog {

/// Parses a photometric file of any kind but GLDF, which its content says.
///
/// path  of the file, for messages and for the ending
Luminaire parse_luminaire(std::string bytes, const std::string& path);

}  // namespace litfog
