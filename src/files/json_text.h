// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace litfog::files {

/// Text as a JSON string with its quotes, escapes included; bytes that are not UTF-8 become U+FFFD.
std::string json_quoted(std::string_view text);

/// An object of members such as "\"a\": 1", or an array, one item a line.
///
/// depth  number of enclosing objects and arrays, which sets the indentation
std::string json_object(const std::vector<std::string>& members, int depth = 0);
std::string json_array(const std::vector<std::string>& items, int depth);

/// The start of a text, at most `most` bytes, up to the end of a code point.
std::string_view start_of(std::string_view text, std::size_t most);

/// Text for a message: quoted, and cut if long.
std::string quoted_excerpt(std::string_view text);

}  // namespace litfog::files
