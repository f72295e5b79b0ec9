// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/cookie_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <glm/geometric.hpp>
#include <limits>

#include "command/temporary_directory.h"
#include "core/value_errors.h"
#include "litfog/input_error.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

Cookie random_cookie(int size) {
  Random random(3);
  return make_cookie(size, [&](const glm::dvec3&) { return random.uniform(0, 1); });
}

/// "accepted", or what is wrong with a file without its name.
std::string cookie_file_error(const std::string& bytes) {
  try {
    parse_cookie(bytes, "c.exr");
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().file, "c.exr");
    return std::string(error.what()).substr(7);
  }
  return "accepted";
}

/// Offset of the value of an attribute: its name and type come before it, then its size.
std::size_t offset_of(const std::string& bytes, const std::string& name, const std::string& type) {
  const std::size_t at = bytes.find(name + '\0' + type + '\0');
  EXPECT_NE(at, std::string::npos) << name;
  return at + name.size() + type.size() + 2 + sizeof(std::int32_t);
}

template <typename Value>
std::string with(std::string bytes, std::size_t offset, Value value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
  return bytes;
}

/// The bytes with other corners of the data window.
std::string with_window(const std::string& bytes, std::array<std::int32_t, 4> corners) {
  return with(bytes, offset_of(bytes, "dataWindow", "box2i"), corners);
}

constexpr const char* kUnreadable = "cannot be read as OpenEXR: ";

TEST(CookieFile, EveryTexelIsReadBack) {
  for (const int size : {1, 2, 5, 16, 33}) {
    const Cookie written = random_cookie(size);
    const Cookie read = parse_cookie(format_cookie(written), "c.exr");
    EXPECT_EQ(read.size, size);
    EXPECT_EQ(read.texels, written.texels);
  }
}

TEST(CookieFile, LargeCookieOfOneValueIsReadBackFromASixHundredthOfItsBytes) {
  constexpr int kSize = 1024;
  const Cookie written{.size = kSize, .texels = std::vector<float>(std::size_t{6} * kSize * kSize, 1.0f)};
  const std::string bytes = format_cookie(written);
  EXPECT_LT(bytes.size(), written.texels.size() * sizeof(float) / 600);
  EXPECT_TRUE(parse_cookie(bytes, "c.exr").texels == written.texels);
}

TEST(CookieFile, SameCookieHasTheSameBytesAndNoTime) {
  const std::string bytes = format_cookie(random_cookie(8));
  EXPECT_EQ(bytes, format_cookie(random_cookie(8)));
  EXPECT_EQ(bytes.find("capDate"), std::string::npos);
  EXPECT_EQ(bytes.find("Date"), std::string::npos);
}

TEST(CookieFile, ImageThatIsNoColumnOfSixFacesIsAnError) {
  const std::string bytes = format_cookie(random_cookie(5));
  const std::string rule = ": must be N x 6 N from (0, 0), six faces in a column, N at most 4096";
  EXPECT_EQ(cookie_file_error(with_window(bytes, {0, 0, 4, 24})), "size = 5x25" + rule);
  EXPECT_EQ(cookie_file_error(with_window(bytes, {1, 0, 5, 29})), "size = 5x30" + rule);
  EXPECT_EQ(cookie_file_error(with_window(bytes, {0, -1, 4, 28})), "size = 5x30" + rule);
  EXPECT_EQ(cookie_file_error(with_window(bytes, {0, 0, 4096, 24581})), "size = 4097x24582" + rule);
  EXPECT_EQ(cookie_file_error(with_window(bytes, {0, 0, 4095, 24575})),
            "size = 4096x24576: must not be more than the file can hold");
}

TEST(CookieFile, WindowBeyondAllBoundsIsAnError) {
  const std::string bytes = format_cookie(random_cookie(5));
  constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  for (const auto& corners : {std::array{0, 0, kMost, kMost}, std::array{kLeast, kLeast, kMost, kMost},
                              std::array{0, 0, -1, -1}, std::array{4, 29, 0, 0}, std::array{0, 0, 4, kMost}}) {
    EXPECT_NE(cookie_file_error(with_window(bytes, corners)), "accepted");
  }
}

TEST(CookieFile, ImageOfAnotherKindIsAnError) {
  const std::string bytes = format_cookie(random_cookie(5));
  const std::size_t channels = offset_of(bytes, "channels", "chlist");
  EXPECT_EQ(cookie_file_error(with(bytes, channels + 2, std::int32_t{0})), "channel = Y: must be of 32-bit floats");
  EXPECT_EQ(cookie_file_error(with(with(bytes, channels, '\n'), channels + 2, std::int32_t{0})),
            "channel = ?: must be of 32-bit floats");
  EXPECT_NE(cookie_file_error(with(bytes, channels + 10, std::int32_t{5})), "accepted");  // a sample for five texels
  const std::size_t compression = offset_of(bytes, "compression", "compression");
  EXPECT_EQ(cookie_file_error(with(bytes, compression, char{4})),
            "compression: must be zip, of 16 rows at a time");  // PIZ
  constexpr std::size_t kVersion = 4;
  EXPECT_NE(cookie_file_error(with(bytes, kVersion, std::int32_t{0x202})), "accepted");   // tiled
  EXPECT_NE(cookie_file_error(with(bytes, kVersion, std::int32_t{0x802})), "accepted");   // deep
  EXPECT_NE(cookie_file_error(with(bytes, kVersion, std::int32_t{0x1002})), "accepted");  // several parts
}

TEST(CookieFile, ValueThatIsNoFractionIsAnError) {
  for (const auto& [wrong, shown] : {std::pair{-0.1f, "-0.10000000149011612"},
                                     {1.5f, "1.5"},
                                     {std::numeric_limits<float>::quiet_NaN(), "nan"},
                                     {std::numeric_limits<float>::infinity(), "inf"}}) {
    // One row's texels are 36 bytes that zip does not make smaller, so that they stand in the file as they are.
    Cookie cookie = random_cookie(1);
    cookie.texels[4] = 0.5f;
    const std::string bytes = format_cookie(cookie);
    const std::size_t at = bytes.rfind(std::string("\0\0\0\x3F", 4));
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(cookie_file_error(with(bytes, at, wrong)), std::string("texel = ") + shown + ": must be in [0, 1]");
    cookie.texels[4] = wrong;
    EXPECT_THROW(format_cookie(cookie), std::invalid_argument);
  }
}

TEST(CookieFile, OtherFormatsAreErrors) {
  for (const std::string bytes : {"", "DDS |", "II*\0", "\x76\x2F\x31\x01", "litfog"}) {
    EXPECT_EQ(cookie_file_error(bytes).substr(0, 27), kUnreadable) << bytes;
  }
}

// zip makes a chunk of one in about fifteen of these neither smaller nor larger.
TEST(CookieFile, CookiesThatHardlyCompressAreReadBack) {
  for (int i = 1; i <= 100; ++i) {
    const Cookie cookie =
        make_cookie(32, [i](const glm::dvec3& d) { return std::pow(std::max(-d.z / glm::length(d), 0.0), 0.25 * i); });
    EXPECT_EQ(parse_cookie(format_cookie(cookie), "c.exr").texels, cookie.texels) << i;
  }
}

TEST(CookieFile, EveryTruncationIsAnError) {
  const std::string bytes = format_cookie(random_cookie(6));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_NE(cookie_file_error(bytes.substr(0, size)), "accepted") << size;
}

TEST(CookieFile, MissingFileIsAnError) {
  const TemporaryDirectory directory;
  const std::string path = (directory.path() / "c.exr").string();
  EXPECT_EQ(sentence_of<InputError>([&] { read_cookie(path); }), path + ": cannot be read: No such file or directory");
  std::ofstream(path, std::ios::binary) << format_cookie(random_cookie(3));
  EXPECT_EQ(read_cookie(path).texels, random_cookie(3).texels);
}

}  // namespace
}  // namespace litfog::test
