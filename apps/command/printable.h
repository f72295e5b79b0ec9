// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace litfog::command {

/// Makes any bytes printable: valid UTF-8 without terminal commands, allowed in XML. Control characters become \x1b or
/// \u0085, bytes that are not UTF-8 \xff, noncharacters \ufffe.
std::string printable(std::string_view text);

/// printable() for several lines: line feeds stay.
std::string printable_lines(std::string_view text);

}  // namespace litfog::command
