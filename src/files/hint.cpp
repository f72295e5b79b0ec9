// SPDX-License-Identifier: Apache-2.0
#include "files/hint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "model/float_limit.h"
#include "text/ascii_text.h"
#include "text/number_text.h"

namespace litfog::files {
namespace {

/// The number of insertions, deletions, replacements and swaps of neighbours from one word to another (optimal string
/// alignment).
std::size_t slips_between(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> slips(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  std::iota(slips[0].begin(), slips[0].end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    slips[i][0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool is_same = a[i - 1] == b[j - 1];
      slips[i][j] = std::min({slips[i - 1][j] + 1, slips[i][j - 1] + 1, slips[i - 1][j - 1] + (is_same ? 0 : 1)});
      const bool is_swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swapped) slips[i][j] = std::min(slips[i][j], slips[i - 2][j - 2] + 1);
    }
  }
  return slips[a.size()][b.size()];
}

/// A percentage as a fraction, without the digits that division by 100 adds: 1.1 / 100 is 0.011000000000000001.
std::string percent_text(double percent) { return fmt::format("; {} % is {:.15g}", percent, percent / 100); }

}  // namespace

std::string hint_for_word(std::string_view word, const std::vector<std::string_view>& known) {
  constexpr std::size_t kMaxSize = 40;  // longer words are no slips, and slow to compare
  if (word.size() < 3 || word.size() > kMaxSize) return "";
  const std::string typed = lower(word);
  std::string_view nearest;
  std::size_t fewest = typed.size() / 3 + 1;
  for (const std::string_view candidate : known) {
    const std::size_t slips = candidate.starts_with(typed) ? 1 : slips_between(typed, candidate);
    if (slips >= fewest) continue;
    fewest = slips;
    nearest = candidate;
  }
  return nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest);
}

std::string hint_for_number(std::string_view text) {
  text = trimmed(text);
  if (!text.ends_with('%')) return "";
  const auto percent = finite_number(trimmed(text.substr(0, text.size() - 1)));
  return percent ? percent_text(*percent) : "";
}

std::string hint_for_quoted_number(std::string_view text) {
  const auto number = finite_number(trimmed(text));
  return number ? fmt::format("; write {}, without quotation marks", *number) : hint_for_number(text);
}

std::string hint_for_fraction(double number, std::string_view rule) {
  constexpr std::array<std::string_view, 3> kFractions{"in (0, 1", "in [0, 1", "in [1e-100, 1"};
  rule.remove_suffix(rule.empty() ? 0 : 1);
  const bool is_fraction = std::ranges::any_of(kFractions, [rule](auto end) { return rule.ends_with(end); });
  return is_fraction && number > 1 && !is_float_of(1, number) && number <= 100 ? percent_text(number) : "";
}

std::string hint_for_syntax(std::string_view text, std::size_t offset) {
  const bool is_end = offset < text.size() && (text[offset] == '}' || text[offset] == ']');
  return is_end && trimmed(text.substr(0, offset)).ends_with(',') ? "; leave out the comma before it" : "";
}

}  // namespace litfog::files
