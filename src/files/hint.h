// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace litfog::files {

// Hints at what an author may have meant, as the end of a rule in a message: "; did you mean extent_m?". Empty without
// a plausible guess.

/// For an unknown word: the known word that begins with it, or else the nearest within a few slips of the keyboard.
std::string hint_for_word(std::string_view word, const std::vector<std::string_view>& known);

/// For a text that is not a number: a percentage as a fraction.
std::string hint_for_number(std::string_view text);

/// For a text in quotation marks that should be a number: the number without them, or the percentage as a fraction.
std::string hint_for_quoted_number(std::string_view text);

/// For a number that breaks a rule such as "must be in (0, 1)" and may be a percentage. 1 rounded to a float is not.
std::string hint_for_fraction(double number, std::string_view rule);

/// For JSON that is wrong at an offset: a comma after the last member or item.
std::string hint_for_syntax(std::string_view text, std::size_t offset);

}  // namespace litfog::files
