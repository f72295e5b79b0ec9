// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "litfog/photometry/luminaire.h"

namespace litfog {

/// Parses a photometric file of any kind except GLDF; the kind follows from the content.
///
/// path  for messages and for the file's ending
Luminaire parse_luminaire(std::string bytes, const std::string& path);

}  // namespace litfog
