// SPDX-License-Identifier: Apache-2.0
#include "photometry/text_encoding.h"

#include <iconv.h>
#include <uchardet/uchardet.h>
#include <utf8.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <iterator>
#include <memory>
#include <new>
#include <type_traits>

namespace litfog {
namespace {

constexpr std::string_view kLittleEndianMark = "\xFF\xFE";
constexpr std::string_view kBigEndianMark = "\xFE\xFF";
constexpr std::size_t kSampleBytes = std::size_t{64} << 10;  // sample size, enough for a guess

bool is_beyond_ascii(char c) { return static_cast<unsigned char>(c) >= 0x80; }

std::string utf8_from_latin1(std::string_view text) {
  std::string result;
  result.reserve(2 * text.size());
  for (const char c : text) utf8::append(char32_t(static_cast<unsigned char>(c)), result);
  return result;
}

/// Converts a text. Nothing if iconv lacks an encoding, or the text is invalid in one or not representable in the
/// other.
std::optional<std::string> convert(std::string_view text, const char* from, const char* to = "UTF-8") {
  const auto close = [](iconv_t converter) { iconv_close(converter); };
  const iconv_t opened = iconv_open(to, from);
  if (opened == reinterpret_cast<iconv_t>(-1)) {
    if (errno == ENOMEM) throw std::bad_alloc();  // GCOV_EXCL_START: the C library has all that are asked for
    return std::nullopt;
  }  // GCOV_EXCL_STOP
  const std::unique_ptr<std::remove_pointer_t<iconv_t>, decltype(close)> converter(opened, close);
  std::string result;
  std::array<char, 4096> buffer;
  char* input = const_cast<char*>(text.data());  // iconv does not write there
  std::size_t input_left = text.size();
  while (input_left > 0) {
    char* output = buffer.data();
    std::size_t output_left = buffer.size();
    const std::size_t count = iconv(converter.get(), &input, &input_left, &output, &output_left);
    result.append(buffer.data(), output);
    if (count == std::size_t(-1) && errno != E2BIG) return std::nullopt;
  }
  return result;
}

/// The name of UTF-16 in a text's byte order, or null for other text. Photometric files begin with ASCII.
const char* utf16_of(std::string_view text) {
  if (text.starts_with(kLittleEndianMark)) return "UTF-16LE";
  if (text.starts_with(kBigEndianMark)) return "UTF-16BE";
  if (text.size() < 4 || text.size() % 2 != 0) return nullptr;
  const auto is_zero_at = [text](std::size_t first) { return text[first] == 0 && text[first + 2] == 0; };
  const auto is_text_at = [text](std::size_t first) { return text[first] > 0 && text[first + 2] > 0; };
  if (is_text_at(0) && is_zero_at(1)) return "UTF-16LE";
  if (is_zero_at(0) && is_text_at(1)) return "UTF-16BE";
  return nullptr;
}

/// The lines of a text that are not plain ASCII.
std::string lines_beyond_ascii(std::string_view text) {
  std::string sample;
  for (auto at = std::ranges::find_if(text, is_beyond_ascii); at != text.end() && sample.size() < kSampleBytes;) {
    const auto offset = std::size_t(at - text.begin());
    const std::size_t begin = offset == 0 ? 0 : text.find_last_of("\r\n", offset) + 1;  // npos + 1 is 0
    const std::size_t end = std::min(text.find_first_of("\r\n", offset), text.size());
    sample += text.substr(begin, std::min(end - begin, kSampleBytes));
    sample += '\n';
    at = std::find_if(text.begin() + std::ptrdiff_t(end), text.end(), is_beyond_ascii);
  }
  return sample;
}

std::string code_page_of(std::string_view text) {
  constexpr const char* kWestern = "WINDOWS-1252";
  const std::string sample = lines_beyond_ascii(text);
  const bool has_neighbours = std::ranges::adjacent_find(sample, [](char a, char b) {
                                return is_beyond_ascii(a) && is_beyond_ascii(b);
                              }) != sample.end();
  if (!has_neighbours) return kWestern;
  const std::unique_ptr<std::remove_pointer_t<uchardet_t>, decltype(&uchardet_delete)> detector(uchardet_new(),
                                                                                                uchardet_delete);
  if (uchardet_handle_data(detector.get(), sample.data(), sample.size()) != 0) throw std::bad_alloc();  // nothing else
  uchardet_data_end(detector.get());
  const std::string guess = uchardet_get_charset(detector.get());
  if (guess.empty()) return kWestern;
  // Capitals of one are small letters of the other. Programs that write photometric files run under Windows.
  return guess == "KOI8-R" ? "WINDOWS-1251" : guess;
}

}  // namespace

std::string utf8_from_bytes(std::string bytes) {
  if (const char* const encoding = utf16_of(bytes)) {
    if (auto text = convert(bytes, encoding)) bytes = *std::move(text);
  }
  if (utf8::starts_with_bom(bytes)) bytes.erase(0, std::size(utf8::bom));
  if (utf8::is_valid(bytes)) return bytes;
  auto text = convert(bytes, code_page_of(bytes).c_str());
  return text ? *std::move(text) : utf8_from_latin1(bytes);
}

std::optional<std::string> code_page_850_from_utf8(std::string_view text) { return convert(text, "UTF-8", "CP850"); }

}  // namespace litfog
