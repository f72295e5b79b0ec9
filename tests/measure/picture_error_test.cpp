// SPDX-License-Identifier: Apache-2.0
#include "measure/picture_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/srgb.h"

namespace litfog::test {
using namespace render;
using namespace measure;

namespace {

using litfog::test::srgb_from_linear;

ReferencePicture row(const std::vector<float>& rgb) {
  const Picture picture{int(rgb.size() / 3), 1, rgb};
  return {picture, picture, picture, std::vector<std::uint8_t>(rgb.size() / 3)};
}

Picture picture(const std::vector<float>& rgb) { return {int(rgb.size() / 3), 1, rgb}; }

TEST(PictureError, IsThatOfTheSrgbValuesInThe255thPartsOfTheDisplaysRange) {
  const PictureError error =
      picture_error(picture({0.25f, 0, 0, 0.5f, 0.002f, 0.5f}), row({0.2f, 0, 0, 0.5f, 0, 0.5f}));
  const double first = 255 * (srgb_from_linear(0.25) - srgb_from_linear(0.2));
  const double second = 255 * 12.92 * 0.002;
  EXPECT_NEAR(error.pixels[0], first, 1e-4);
  EXPECT_NEAR(error.pixels[1], second, 1e-4);
  EXPECT_NEAR(error.largest, std::max(first, second), 1e-4);
  EXPECT_NEAR(error.mean, (first + second) / 2, 1e-4);
}

TEST(PictureError, IsNothingBeyondWhatADisplayShows) {
  const PictureError error = picture_error(picture({1, 50, -1}), row({2, 7, 0}));
  EXPECT_EQ(error.largest, 0);
}

TEST(PictureError, ExceptedPixelsAreCountedAndNothingElse) {
  ReferencePicture reference = row({0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f});
  reference.is_at_jump[0] = 1;
  const PictureError error = picture_error(picture({0, 0, 0, 0.5f, 0.5f, 0.5f}), reference);
  EXPECT_EQ(error.excepted, 1u);
  EXPECT_EQ(error.pixels[0], -1);
  EXPECT_EQ(error.largest, 0);
  EXPECT_EQ(error.mean, 0);
}

TEST(PictureError, BeyondMapsIsWhatTheLeastAndTheMostDoNotExplain) {
  ReferencePicture reference = row({0.5f, 0.5f, 0.5f});
  reference.least.rgb = {0.4f, 0.5f, 0.5f};
  reference.most.rgb = {0.5f, 0.7f, 0.5f};
  EXPECT_EQ(picture_error(picture({0.45f, 0.65f, 0.5f}), reference).beyond_maps, 0);
  const double below = 255 * (srgb_from_linear(0.4) - srgb_from_linear(0.3));
  EXPECT_NEAR(picture_error(picture({0.3f, 0.65f, 0.5f}), reference).beyond_maps, below, 1e-4);
}

TEST(PictureError, OfAPixelThatIsNotANumberIsInfinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(picture_error(picture({0, nan, 0.5f}), row({0, 0, 0})).largest, std::numeric_limits<double>::infinity());
}

TEST(PictureError, InWordsSaysHowManyPixelsAreExceptedIfAny) {
  EXPECT_EQ(error_in_words({.largest = 0.13912, .mean = 0.0126}), "largest error 0.139, mean 0.0126 of 1/255");
  EXPECT_EQ(error_in_words({.largest = 17.2, .mean = 2, .excepted = 3}),
            "largest error 17.2, mean 2 of 1/255; pixels excepted: 3");
}

}  // namespace

}  // namespace litfog::test
