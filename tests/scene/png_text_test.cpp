// SPDX-License-Identifier: Apache-2.0
#include "image/png_text.h"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace litfog::test {
namespace {

using namespace std::string_view_literals;
using image::decode_png;
using image::ImageError;
using Values = std::vector<std::uint8_t>;

/// Red, half transparent, and green, by a palette of 1 bit.
constexpr std::string_view kPalette{
    "\211PNG\015\012\032\012\000\000\000\015IHDR\000\000\000\002\000\000\000\001\001\003\000\000\000\316\354\355\311\000\000\000\006PLTE\377\000\000\000\377\000\322\207\357q\000\000\000\001tRNS\200\255^[F\000\000\000\012IDATx\332cp\000\000\000B\000A\204\277\216b\000\000\000\000IEND\256B`\202"sv};
/// Three levels of grey.
constexpr std::string_view kTwoBits{
    "\211PNG\015\012\032\012\000\000\000\015IHDR\000\000\000\003\000\000\000\001\002\000\000\000\000t;S\311\000\000\000\012IDATx\332c\220\001\000\000\036\000\035K81\333\000\000\000\000IEND\256B`\202"sv};
/// 255 of 65,535.
constexpr std::string_view kSixteenBits{
    "\211PNG\015\012\032\012\000\000\000\015IHDR\000\000\000\001\000\000\000\001\020\000\000\000\000j\356G\026\000\000\000\013IDATx\332c`\370\017\000\001\002\001\000\321\032\313\217\000\000\000\000IEND\256B`\202"sv};
/// A level of 80 in linear light, and a text whose checksum is wrong.
constexpr std::string_view kWarnings{
    "\211PNG\015\012\032\012\000\000\000\015IHDR\000\000\000\001\000\000\000\001\010\000\000\000\000:~\233U\000\000\000\004gAMA\000\001\206\2401\350\226_\000\000\000\001tEXtau\363\213(\000\000\000\012IDATx\332c\010\000\000\000R\000QZ\251\243:\000\000\000\000IEND\256B`\202"sv};

void accept(int, int) {}

TEST(PngText, LevelsOfEveryKindAreRead) {
  const image::Levels palette = decode_png(kPalette, accept);
  EXPECT_EQ(palette.channels, 4u);
  EXPECT_EQ(palette.values, (Values{255, 0, 0, 128, 0, 255, 0, 255}));
  EXPECT_EQ(decode_png(kTwoBits, accept).values, (Values{0, 85, 255}));
  EXPECT_EQ(decode_png(kSixteenBits, accept).values, Values{1});
}

TEST(PngText, NothingIsPrinted) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(decode_png(kWarnings, accept).values, Values{80});
  EXPECT_THROW(decode_png(kPalette.substr(0, 60), accept), ImageError);
  std::string broken(kTwoBits);
  broken[broken.size() - 14] ^= 1;  // in the checksum of the levels
  EXPECT_THROW(decode_png(broken, accept), ImageError);
  EXPECT_THROW(decode_png("\x89PNG", accept), ImageError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(PngText, WrittenLevelsAreReadAgain) {
  const Values levels{1, 2, 3, 4, 5, 6};
  const image::Levels read = decode_png(image::png_text(1, 2, levels), accept);
  EXPECT_EQ(std::pair(read.width, read.height), std::pair(1, 2));
  EXPECT_EQ(read.values, levels);
}

TEST(PngText, SizeIsAcceptedBeforeMemoryIsTaken) {
  struct Refused {};
  EXPECT_THROW(decode_png(kTwoBits, [](int, int) { throw Refused(); }), Refused);
}

}  // namespace
}  // namespace litfog::test
