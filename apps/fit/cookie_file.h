// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "litfog/photometry/cookie.h"

namespace litfog::fit {

/// Writes a cookie as an OpenEXR image of one 32-bit channel, its six faces in one column, +x -x +y -y +z -z from the
/// top, each with its rows and columns as glTexImage2D takes them. Throws CannotWrite.
void write_cookie(const std::string& path, const litfog::Cookie& cookie);

}  // namespace litfog::fit
