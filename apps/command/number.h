// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace litfog::command {

/// whole_number(), but refuses nan.
std::optional<double> parse_number(std::string_view text);

/// Parses an integer: decimal digits with an optional minus.
std::optional<int> parse_integer(std::string_view text);

/// Splits a text at its commas into one part or more: "1,,2" has three.
std::vector<std::string_view> split_at_commas(std::string_view text);

}  // namespace litfog::command
