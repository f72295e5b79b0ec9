// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace litfog {

/// The bytes of a file in a GLDF container: at most kMaxPhotometricBytes, whatever the archive says. Throws InputError.
std::string read_gldf_entry(const std::string& path, const std::string& entry);

}  // namespace litfog
