// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "litfog/photometry/cookie.h"

namespace litfog {

/// A cookie as the bytes of an OpenEXR file: scan lines of one 32-bit channel Y, zip compression, the faces in one
/// column from the top. Equal cookies give equal bytes; there is no time stamp.
///
/// throws     std::invalid_argument for what find_error(cookie) finds
std::string format_cookie(const Cookie& cookie);

/// Parses a cookie file. Accepts only what format_cookie() could have written: one part, scan lines, one 32-bit float
/// channel, N columns and 6 N rows from (0, 0), N at most kMaxCookieSize, zip compression, all rows present and all
/// values in [0, 1]. A header that claims more texels than zip can pack into the bytes is refused before memory is
/// allocated.
///
/// name       the file's, for messages
/// throws     InputError for the file as a whole
Cookie parse_cookie(std::string_view bytes, const std::string& name);

/// Reads a cookie file of at most 400 MiB.
///
/// throws     InputError for the file as a whole
Cookie read_cookie(const std::string& path);

}  // namespace litfog
