// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace litfog::command {

/// Appends to standard output. Throws OutputError.
void write_standard_output(std::string_view text);

/// Writes printable_lines() immediately, to a pipe too: the progress of a command that takes a while. Throws
/// OutputError.
void report(std::string_view text);

/// Closes standard output. Throws OutputError if any of it was lost.
void close_standard_output();

}  // namespace litfog::command
