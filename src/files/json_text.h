// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace litfog::files {

/// Text as a JSON string with its quotes, escapes included; bytes that are no UTF-8 become U+FFFD.
std::string json_quoted(std::string_view text);

/// Text for a message: quoted, and cut where it is long.
std::string quoted_excerpt(std::string_view text);

}  // namespace litfog::files
