// SPDX-License-Identifier: Apache-2.0
#include "text_scanner.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace litfog {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{64} << 20;
constexpr std::size_t kMaxShown = 40;  // of a value in a message
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlank = " \t\v\f\x1A";  // 0x1A ended a file under DOS
constexpr std::string_view kLineEnd = "\r\n";
constexpr std::string_view kSeparators = " \t\v\f\x1A\r\n,";

unsigned byte_of(char c) { return static_cast<unsigned char>(c); }
bool continues_code_point(char c) { return (byte_of(c) & 0xC0) == 0x80; }

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const unsigned lead = byte_of(text.front());
    const std::size_t length = lead < 0x80   ? 1
                               : lead < 0xC2 ? 0
                               : lead < 0xE0 ? 2
                               : lead < 0xF0 ? 3
                               : lead < 0xF5 ? 4
                                             : 0;
    if (length == 0 || text.size() < length) return false;
    const std::string_view rest = text.substr(1, length - 1);
    if (!std::ranges::all_of(rest, continues_code_point)) return false;
    // Overlong forms, surrogates, and what lies beyond U+10FFFF show in the second byte.
    const unsigned second = rest.empty() ? 0 : byte_of(rest.front());
    if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F)) return false;
    if ((lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F)) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string utf8_from_latin1(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (byte_of(c) < 0x80) {
      result += c;
    } else {
      result += char(0xC0 | (byte_of(c) >> 6));
      result += char(0x80 | (byte_of(c) & 0x3F));
    }
  }
  return result;
}

/// Text for a message: cut where it is long, control characters replaced.
std::string excerpt(std::string_view text) {
  std::size_t end = std::min(text.size(), kMaxShown);
  while (end < text.size() && end > 0 && continues_code_point(text[end])) --end;
  std::string shown(text.substr(0, end));
  std::ranges::replace_if(
      shown, [](char c) { return byte_of(c) < 0x20 || byte_of(c) == 0x7F; }, '?');
  return end < text.size() ? shown + "..." : shown;
}

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double number;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

}  // namespace

std::string read_photometric_file(const std::string& path) {
  const auto fail = [&path](const std::string& sentence) { throw PhotometryError(path, 0, 0, sentence); };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) fail(std::string("file: cannot be read: ") + std::strerror(errno));
  std::string text;
  std::vector<char> chunk(65536);
  while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
    text.append(chunk.data(), count);
    if (text.size() > kMaxBytes) fail("file: must not be larger than 67108864 bytes");
  }
  if (std::ferror(file.get())) fail(std::string("file: cannot be read: ") + std::strerror(errno));
  return text;
}

TextScanner::TextScanner(std::string text, std::string name) : text_(std::move(text)), name_(std::move(name)) {
  if (text_.starts_with(kByteOrderMark)) text_.erase(0, kByteOrderMark.size());
  if (!is_utf8(text_)) text_ = utf8_from_latin1(text_);
}

TextScanner::Piece TextScanner::next(Unit unit) { return unit == Unit::token ? next_token() : next_line(); }

TextScanner::Piece TextScanner::next_token() {
  const std::size_t begin = std::min(text_.find_first_not_of(kSeparators, cursor_), text_.size());
  cursor_ = std::min(text_.find_first_of(kSeparators, begin), text_.size());
  return {std::string_view(text_).substr(begin, cursor_ - begin), begin, begin == text_.size()};
}

TextScanner::Piece TextScanner::next_line() {
  const bool is_missing = is_at_end();
  const std::size_t end = std::min(text_.find_first_of(kLineEnd, cursor_), text_.size());
  const std::size_t begin = std::min(text_.find_first_not_of(kBlank, cursor_), end);
  const std::string_view line = std::string_view(text_).substr(begin, end - begin);
  cursor_ = std::min(end + (text_.compare(end, 2, kLineEnd) == 0 ? 2 : 1), text_.size());
  return {line.substr(0, line.find_last_not_of(kBlank) + 1), begin, is_missing};
}

double TextScanner::number(const Piece& piece, std::string_view what) const {
  std::string_view text = piece.text;
  std::string with_point;  // a decimal comma, which only lines can hold
  if (const auto comma = text.find(','); comma != text.npos && text.find('.') == text.npos) {
    with_point = text;
    with_point[comma] = '.';
    text = with_point;
  }
  const auto value = parse_number(text);
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

void TextScanner::fail(const Piece& piece, std::string_view what, std::string_view rule) const {
  const std::string_view before = std::string_view(text_).substr(0, piece.offset);
  std::size_t line = 1, line_begin = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool ends_line = before[i] == '\n' || (before[i] == '\r' && text_.compare(i, 2, kLineEnd) != 0);
    if (ends_line) {
      ++line;
      line_begin = i + 1;
    }
  }
  const auto column = 1 + std::ranges::count_if(before.substr(line_begin), std::not_fn(continues_code_point));
  std::string sentence(what);
  sentence += piece.text.empty() ? ": must be given" : " = " + excerpt(piece.text) + ": " + std::string(rule);
  throw PhotometryError(name_, line, std::size_t(column), sentence);
}

}  // namespace litfog
