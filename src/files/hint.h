// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace litfog::files {

// What an author may have meant, as the end of a rule in a message: "; did you mean extent_m?". Empty where nothing
// suggests itself.

/// Of a word that is none of the known ones: the known word that begins with it, or else one that is a few slips of the
/// keyboard away.
std::string hint_for_word(std::string_view word, const std::vector<std::string_view>& known);

/// Of a text where a number is due: a number with its unit, a percentage, a decimal comma.
///
/// member  that the number is for. The end of its name states its unit, as in "extent_m"; a number without a unit may
///         be a fraction
std::string hint_for_number(std::string_view text, std::string_view member = {});

/// The same of a text in quotation marks, which a number by itself lacks.
std::string hint_for_quoted_number(std::string_view text, std::string_view member = {});

/// Of a number that breaks a rule such as "must be in (0, 1)" and may be a percentage, as 1 in floats is not.
std::string hint_for_fraction(double number, std::string_view rule);

/// Of JSON that is wrong at an offset: a decimal comma, or one behind the last member or item.
std::string hint_for_syntax(std::string_view text, std::size_t offset);

}  // namespace litfog::files
