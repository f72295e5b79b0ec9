// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <filesystem>

#include "litfog/input_error.h"
#include "text/file_text.h"

namespace litfog::scene {
namespace {

constexpr std::uint8_t kNone = 64;  // marks a character that is not a digit of base64

/// Decodes a URI's path: %20 becomes a blank.
std::string percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = text.data() + i + 1;
    const bool is_escape =
        text[i] == '%' && i + 2 < text.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    decoded += is_escape ? char(byte) : text[i];
    if (is_escape) i += 2;
  }
  return decoded;
}

/// noun       the owner's kind, for the error's sentence
/// read_file  reads the file of a path
template <typename ReadFile>
std::string read_uri(const JsonValue& owner, std::string_view noun, const ReadFile& read_file) {
  const auto path = gltf_uri_path(owner);
  if (!path) {
    const JsonValue uri = owner.member("uri");
    const std::string_view text = uri.string();
    const std::size_t comma = text.find(',');
    if (!text.substr(0, comma).ends_with(";base64")) uri.fail("must be a data URI in base64");
    auto bytes = decode_base64(text.substr(comma + 1));
    if (!bytes) uri.fail("must hold base64 after its comma");
    return *std::move(bytes);
  }
  try {
    return read_file(*path);
  } catch (const InputError& error) {
    owner.fail(fmt::format("must be a {} that can be read: {}", noun, error.what()));
  }
}

}  // namespace

std::optional<std::string> decode_base64(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  static const auto kValues = [&] {
    std::array<std::uint8_t, 256> values;
    values.fill(kNone);
    for (std::size_t i = 0; i < kDigits.size(); ++i) values[static_cast<unsigned char>(kDigits[i])] = std::uint8_t(i);
    return values;
  }();
  if (text.size() % 4 == 0) {
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
  }
  if (text.size() % 4 == 1) return std::nullopt;  // six bits make no byte
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int bit_count = 0;
  for (const char digit : text) {
    const std::uint8_t value = kValues[static_cast<unsigned char>(digit)];
    if (value == kNone) return std::nullopt;
    bits = bits << 6 | value;
    bit_count += 6;
    if (bit_count < 8) continue;
    bit_count -= 8;
    bytes += char(bits >> bit_count);
  }
  return bytes;
}

std::optional<std::string> gltf_uri_path(const JsonValue& owner) {
  const auto uri = owner.optional("uri");
  if (!uri || uri->string().starts_with("data:")) return std::nullopt;
  const std::filesystem::path path = percent_decoded(uri->string());
  return (std::filesystem::path(owner.file()).parent_path() / path.relative_path()).string();
}

std::string read_gltf_picture(const JsonValue& picture, std::size_t max_bytes) {
  return read_uri(picture, "picture", [&](const std::string& path) { return read_file_text(path, max_bytes); });
}

std::string read_gltf_buffer(const JsonValue& buffer, std::size_t max_bytes) {
  std::string bytes =
      read_uri(buffer, "buffer", [&](const std::string& path) { return read_file_start(path, max_bytes); });
  bytes.resize(std::min(bytes.size(), max_bytes));
  return bytes;
}

}  // namespace litfog::scene
