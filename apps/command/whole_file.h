// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace litfog::command {

/// Writes a file whole or not at all: `write` fills a temporary file beside it, with the same ending, which then takes
/// its name. An earlier file stays as it was when anything fails. Throws CannotWrite.
void write_whole_file(const std::string& path, const std::function<void(const std::string& temporary)>& write);

/// The same for a text.
void write_whole_file(const std::string& path, std::string_view text);

/// Throws CannotWrite where the path is a folder or in none: for commands that work long before they write.
void expect_place_for_file(const std::string& path);

}  // namespace litfog::command
