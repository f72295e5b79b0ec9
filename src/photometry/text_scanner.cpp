// SPDX-License-Identifier: Apache-2.0
#include "photometry/text_scanner.h"

#include <utf8.h>

#include <algorithm>
#include <cmath>

#include "photometry/text_encoding.h"
#include "text/ascii_text.h"
#include "text/code_points.h"
#include "text/file_text.h"
#include "text/number_text.h"

namespace litfog {
namespace {

constexpr std::size_t kMaxShown = 40;               // characters of a value in a message
constexpr std::string_view kBlank = " \t\v\f\x1A";  // 0x1A ended a file under DOS
constexpr std::string_view kLineEnd = "\r\n";

bool is_separator(char c) {
  switch (c) {
    case ' ':
    case '\t':
    case '\v':
    case '\f':
    case '\x1A':
    case '\r':
    case '\n':
    case ',':
      return true;
  }
  return false;
}

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  std::string with_e;  // with E instead of Fortran's D
  if (const auto exponent = text.find_first_of("Dd"); exponent != text.npos) {
    with_e = text;
    with_e[exponent] = 'e';
    text = with_e;
  }
  return finite_number(text);
}

}  // namespace

std::string excerpt(std::string_view text) {
  std::string shown(text.substr(0, kMaxShown));
  shown.resize(std::min(shown.size(), utf8::find_invalid(shown)));  // no half of a code point
  const std::size_t length = shown.size();
  std::ranges::replace_if(
      shown, [](char c) { return (c >= 0 && c < 0x20 && c != '\t') || c == 0x7F; }, '?');
  return length < text.size() ? shown + "..." : shown;
}

void fail_at(InputLocation location, std::string_view what, std::string_view value, bool is_missing,
             std::string_view rule) {
  if (value.empty()) rule = is_missing ? "must be given, but the file ends here" : "must be given";
  throw InputError(std::move(location), what, excerpt(value), rule);
}

std::string read_photometric_file(const std::string& path) { return read_file_text(path, kMaxPhotometricBytes); }

TextScanner::TextScanner(std::string bytes, std::string name)
    : text_(utf8_from_bytes(std::move(bytes))), name_(std::move(name)) {}

TextScanner::Piece TextScanner::next(Unit unit) { return unit == Unit::token ? next_token() : next_line(); }

TextScanner::Piece TextScanner::next_token() {
  const auto begin = std::find_if_not(text_.begin() + std::ptrdiff_t(cursor_), text_.end(), is_separator);
  const auto end = std::find_if(begin, text_.end(), is_separator);
  cursor_ = std::size_t(end - text_.begin());
  return {std::string_view(begin, end), std::size_t(begin - text_.begin()), begin == text_.end()};
}

TextScanner::Piece TextScanner::next_line() {
  const bool is_missing = is_at_end();
  const std::size_t end = find_line_end(text_, cursor_);
  const std::size_t begin = std::min(text_.find_first_not_of(kBlank, cursor_), end);
  const std::string_view line = std::string_view(text_).substr(begin, end - begin);
  cursor_ = std::min(end + (text_.compare(end, 2, kLineEnd) == 0 ? 2 : 1), text_.size());
  return {line.substr(0, line.find_last_not_of(kBlank) + 1), begin, is_missing};
}

std::optional<double> TextScanner::number_if_any(const Piece& piece) {
  std::string_view text = piece.text;
  std::string with_point;  // a decimal comma, which only lines can hold
  if (const auto comma = text.find(','); comma != text.npos && text.find('.') == text.npos) {
    with_point = text;
    with_point[comma] = '.';
    text = with_point;
  }
  return parse_number(text);
}

double TextScanner::number(const Piece& piece, std::string_view what) const {
  const auto value = number_if_any(piece);
  if (!value) fail(piece, what, "must be a finite number");
  return *value;
}

int TextScanner::integer(const Piece& piece, std::string_view what, int low, int high) const {
  const double value = number(piece, what);
  if (!(value >= low && value <= high && value == std::floor(value))) {
    fail(piece, what, "must be an integer from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return int(value);
}

double TextScanner::positive(const Piece& piece, std::string_view what) const {
  const double value = number(piece, what);
  if (!(value > 0)) fail(piece, what, "must be > 0");
  return value;
}

void TextScanner::expect_no_more_numbers() {
  const Piece piece = next_token();
  if (parse_number(piece.text))
    fail(piece, "number after the last intensity", "must not be there by the file's counts");
}

InputLocation TextScanner::location(const Piece& piece) const {
  std::size_t end = std::min(piece.offset, text_.size());
  while (end > 0 && end < text_.size() && !starts_code_point(text_[end])) --end;  // an XML parser stops within one
  const std::string_view before = std::string_view(text_).substr(0, end);
  std::size_t line = 1, line_begin = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool ends_line = before[i] == '\n' || (before[i] == '\r' && text_.compare(i, 2, kLineEnd) != 0);
    if (ends_line) {
      ++line;
      line_begin = i + 1;
    }
  }
  return {name_, line, 1 + count_code_points(before.substr(line_begin))};
}

void TextScanner::fail(const Piece& piece, std::string_view what, std::string_view rule) const {
  fail_at(location(piece), what, piece.text, piece.is_missing, rule);
}

}  // namespace litfog
