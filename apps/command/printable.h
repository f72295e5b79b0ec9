// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace litfog::command {

/// A text for people, whatever bytes it came with: valid UTF-8 that a terminal takes no command from and an XML
/// document may hold. Control characters become \x1b or \u0085, bytes that are no UTF-8 \xff, noncharacters \ufffe.
std::string printable(std::string_view text);

/// printable() for a text of several lines: line feeds stay.
std::string printable_lines(std::string_view text);

}  // namespace litfog::command
