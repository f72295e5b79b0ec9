// SPDX-License-Identifier: Apache-2.0
#include "files/hint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>

#include "model/float_limit.h"
#include "text/ascii_text.h"

namespace litfog::files {
namespace {

constexpr std::string_view kDigits = "0123456789";

/// Insertions, deletions, replacements and swaps of neighbours that lead from one word to another (optimal string
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

/// How a member's name ends and what people write for it.
struct Unit {
  std::string_view symbol;
  std::string_view name;
  std::string_view sign = {};  ///< another symbol
};

constexpr std::array kUnits{Unit{"deg", "degrees", "\u00b0"},
                            Unit{"m", "metres"},
                            Unit{"cd", "candela"},
                            Unit{"lm", "lumens"},
                            Unit{"lx", "lux"},
                            Unit{"k", "kelvin"}};

/// That of a member's value, or of an item's in its array.
const Unit* unit_of(std::string_view member) {
  if (member.ends_with(']')) member = member.substr(0, member.rfind('['));
  const std::string_view last = member.substr(member.find_last_of("._") + 1);
  const bool is_suffix = last.size() < member.size();
  const auto found = std::ranges::find(kUnits, last, &Unit::symbol);
  return is_suffix && found != kUnits.end() ? &*found : nullptr;
}

/// A number that JSON can hold.
std::optional<double> parse_number(std::string_view text) {
  double number;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return stop == end && error == std::errc() && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// A number with a decimal comma, with a point. JSON has digits on both sides of it.
std::optional<std::string> with_point(std::string_view text) {
  const auto comma = text.find(',');
  const auto is_digit_at = [text](std::size_t i) { return i < text.size() && kDigits.find(text[i]) != kDigits.npos; };
  if (comma == text.npos || !is_digit_at(comma - 1) || !is_digit_at(comma + 1)) return std::nullopt;
  std::string result(text);
  result[comma] = '.';
  return parse_number(result) ? std::optional(result) : std::nullopt;
}

/// What to write for a number with a comma, which may also stand between thousands.
std::string advice_on_comma(std::string_view text, const std::string& with_point) {
  const auto comma = text.find(',');
  const bool may_be_thousands = text.size() == comma + 4 && text.find_first_not_of(kDigits, comma + 1) == text.npos;
  if (!may_be_thousands) return fmt::format("; write {}, with a decimal point", with_point);
  return fmt::format("; write {} or {}{}", with_point, text.substr(0, comma), text.substr(comma + 1));
}

/// A percentage as a fraction, without the digits that division by 100 adds: 1.1 / 100 is 0.011000000000000001.
std::string percent_text(double percent) { return fmt::format("; {} % is {:.15g}", percent, percent / 100); }

/// A unit that data sheets have and no member has.
struct ForeignUnit {
  std::string_view symbol;
  std::string_view own;  ///< of the members
  double factor;
};
constexpr std::array kForeignUnits{ForeignUnit{"ft", "m", 0.3048},     ForeignUnit{"km", "m", 1000},
                                   ForeignUnit{"nm", "m", 1852},       ForeignUnit{"fc", "lx", 10.7639},
                                   ForeignUnit{"kcd", "cd", 1000},     ForeignUnit{"klm", "lm", 1000},
                                   ForeignUnit{"rad", "deg", 57.29578}};

/// "; did you mean range_m?" and, of "range_ft", " 1 ft is 0.3048 m".
std::string suggestion(std::string_view typed, std::string_view name) {
  std::string text = fmt::format("; did you mean {}?", name);
  const auto foreign = std::ranges::find(kForeignUnits, typed.substr(typed.rfind('_') + 1), &ForeignUnit::symbol);
  if (foreign != kForeignUnits.end() && foreign->own == name.substr(name.rfind('_') + 1)) {
    text += fmt::format(" 1 {} is {} {}", foreign->symbol, foreign->factor, foreign->own);
  }
  return text;
}

std::string_view first_part(std::string_view name) { return name.substr(0, name.find('_')); }

/// The only known name with the unit that a word ends with or is, as "distance_m" and "lumens", or the only one of
/// these that begins as it does, as "beam_deg": angles are of many kinds.
std::string_view name_by_unit(std::string_view word, const std::vector<std::string_view>& known) {
  const auto named = std::ranges::find_if(kUnits, [word](const Unit& unit) { return word.ends_with(unit.name); });
  const Unit* const unit = named != kUnits.end() ? &*named : unit_of(word);
  if (unit == nullptr) return {};
  std::vector<std::string_view> alike;
  std::ranges::copy_if(known, std::back_inserter(alike), [unit](auto name) { return unit_of(name) == unit; });
  if (alike.size() > 1 || unit->symbol == "deg") {
    std::erase_if(alike, [word](auto name) { return first_part(name) != first_part(word); });
  }
  return alike.size() == 1 ? alike.front() : std::string_view();
}

}  // namespace

std::string hint_for_word(std::string_view word, const std::vector<std::string_view>& known) {
  constexpr std::size_t kLongest = 40;  // beyond it a word is no slip, and comparing takes its time
  const std::string typed = lower(word);
  const auto foreign = std::ranges::find(kForeignUnits, typed, &ForeignUnit::symbol);
  if (foreign != kForeignUnits.end() && std::ranges::count(known, foreign->own) > 0) {
    return suggestion(typed, foreign->own);
  }
  if (word.size() < 3 || word.size() > kLongest) return "";
  std::string_view nearest;
  std::size_t fewest = typed.size() / 3 + 1;
  for (const std::string_view candidate : known) {
    const std::size_t slips = candidate.starts_with(typed) ? 1 : slips_between(typed, candidate);
    if (slips >= fewest) continue;
    fewest = slips;
    nearest = candidate;
  }
  if (nearest.empty()) nearest = name_by_unit(typed, known);
  return nearest.empty() ? "" : suggestion(typed, nearest);
}

std::string hint_for_number(std::string_view text, std::string_view member) {
  text = trimmed(text);
  const std::size_t end = text.find_last_of(kDigits) + 1;
  const std::string_view behind = trimmed(text.substr(end));
  text = text.substr(0, end);
  const auto with = with_point(text);
  const auto number = parse_number(with ? *with : text);
  if (!number) return "";
  if (const Unit* const unit = unit_of(member); unit && !behind.empty()) {
    const std::string written = lower(behind);
    const bool is_unit = written == unit->symbol || written == unit->name || written == unit->sign;
    return is_unit ? fmt::format("; write {} alone", *number) : fmt::format("; its unit is {}", unit->name);
  }
  if (behind == "%") return percent_text(*number);
  return behind.empty() && with ? advice_on_comma(text, *with) : "";
}

std::string hint_for_quoted_number(std::string_view text, std::string_view member) {
  if (const auto number = parse_number(trimmed(text)))
    return fmt::format("; write {}, without quotation marks", *number);
  return hint_for_number(text, member);
}

std::string hint_for_fraction(double number, std::string_view rule) {
  constexpr std::array<std::string_view, 3> kFractions{"in (0, 1", "in [0, 1", "in [1e-100, 1"};
  rule.remove_suffix(rule.empty() ? 0 : 1);
  const bool is_fraction = std::ranges::any_of(kFractions, [rule](auto end) { return rule.ends_with(end); });
  return is_fraction && number > 1 && !is_float_of(1, number) && number <= 100 ? percent_text(number) : "";
}

std::string hint_for_syntax(std::string_view text, std::size_t offset) {
  const bool is_end = offset < text.size() && (text[offset] == '}' || text[offset] == ']');
  if (is_end && trimmed(text.substr(0, offset)).ends_with(',')) return "; leave out the comma before it";
  // Behind a comma an object has no number, and an array none of two digits that begins with 0: the comma is a decimal
  // one. Elsewhere it divides the items of an array.
  const std::string_view before = text.substr(0, offset);
  const bool is_number = offset < text.size() && kDigits.find(text[offset]) != kDigits.npos;
  if (!is_number || !(before.ends_with(',') || before.ends_with(",0"))) return "";
  const auto is_part = [](char c) { return kDigits.find(c) != kDigits.npos || c == ','; };
  const auto begin =
      std::find_if_not(text.rbegin() + std::ptrdiff_t(text.size() - offset), text.rend(), is_part).base();
  const auto end = std::find_if_not(text.begin() + std::ptrdiff_t(offset), text.end(), is_part);
  std::string_view number(begin, end);
  if (number.ends_with(',')) number.remove_suffix(1);
  const auto with = with_point(number);
  return with ? advice_on_comma(number, *with) : "";
}

}  // namespace litfog::files
