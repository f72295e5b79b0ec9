// SPDX-License-Identifier: Apache-2.0
#include "measure/picture_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/double_limits.h"
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

TEST(PictureError, ErrorUpTo1IsInStepsOfTheDisplay) {
  const PictureError error =
      picture_error(picture({0.25f, 0, 0, 0.5f, 0.002f, 0.5f}), row({0.2f, 0, 0, 0.5f, 0, 0.5f}));
  const double first = 255 * (srgb_from_linear(0.25) - srgb_from_linear(0.2));
  const double second = 255 * 12.92 * 0.002;
  EXPECT_NEAR(error.pixels[0], first, 1e-4);
  EXPECT_NEAR(error.pixels[1], second, 1e-4);
  EXPECT_NEAR(error.largest, std::max(first, second), 1e-4);
  EXPECT_NEAR(error.mean, (first + second) / 2, 1e-4);
}

TEST(PictureError, ErrorAbove1IsRelative) {
  const double ten_percent = 255 * 1.055 / 2.4 * std::log(1.1);
  EXPECT_NEAR(picture_error(picture({1.1f, 1, 1}), row({1, 1, 1})).largest, ten_percent, 1e-3);
  EXPECT_NEAR(picture_error(picture({55, 1, 1}), row({50, 1, 1})).largest, ten_percent, 1e-3);
}

TEST(PictureError, StepsAreAsLargeJustAbove1AsJustBelow) {
  const double below = picture_error(picture({0.999f, 1, 1}), row({1, 1, 1})).largest;
  const double above = picture_error(picture({1.001f, 1, 1}), row({1, 1, 1})).largest;
  EXPECT_NEAR(below / above, 1, 0.01);
}

TEST(PictureError, IsThatOfTheExposedPictures) {
  const double plain = picture_error(picture({0.4f, 1, 1}), row({0.2f, 1, 1})).largest;
  EXPECT_EQ(picture_error(picture({0.1f, 0.25f, 0.25f}), row({0.05f, 0.25f, 0.25f}), 2).largest, plain);
  EXPECT_EQ(picture_error(picture({0.8f, 2, 2}), row({0.4f, 2, 2}), -1).largest, plain);
}

TEST(PictureError, LightBelow0CountsAs0) { EXPECT_EQ(picture_error(picture({-1, 0, 0}), row({0, 0, 0})).largest, 0); }

TEST(PictureError, ExcludedPixelsAreCountedAndNotCompared) {
  ReferencePicture reference = row({0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f});
  reference.is_at_jump[0] = 1;
  const PictureError error = picture_error(picture({0, 0, 0, 0.5f, 0.5f, 0.5f}), reference);
  EXPECT_EQ(error.excluded, 1u);
  EXPECT_EQ(error.pixels[0], -1);
  EXPECT_EQ(error.largest, 0);
  EXPECT_EQ(error.mean, 0);
}

TEST(PictureError, ErrorBeyondMapsIsWhatTheirTexelsDoNotExplain) {
  ReferencePicture reference = row({0.5f, 0.5f, 0.5f});
  reference.least.rgb = {0.4f, 0.5f, 0.5f};
  reference.most.rgb = {0.5f, 0.7f, 0.5f};
  EXPECT_EQ(picture_error(picture({0.45f, 0.65f, 0.5f}), reference).beyond_maps, 0);
  const double below = 255 * (srgb_from_linear(0.4) - srgb_from_linear(0.3));
  EXPECT_NEAR(picture_error(picture({0.3f, 0.65f, 0.5f}), reference).beyond_maps, below, 1e-4);
}

TEST(PictureError, PixelThatIsNotFiniteHasInfiniteError) {
  for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    const std::vector<float> good{0.5f, 0.5f, 0.5f};
    const std::vector<float> bad{0.5f, value, 0.5f};
    for (const PictureError& error : {picture_error(picture(bad), row(good)), picture_error(picture(good), row(bad)),
                                      picture_error(picture(bad), row(bad))}) {
      EXPECT_EQ(error.largest, kInfinity);
      EXPECT_EQ(error.mean, kInfinity);
      EXPECT_EQ(error.beyond_maps, kInfinity);
    }
    ReferencePicture excluded = row(good);
    excluded.is_at_jump[0] = 1;
    EXPECT_EQ(picture_error(picture(bad), excluded).largest, kInfinity);
    ReferencePicture open = row(good);
    open.most.rgb[1] = value;
    EXPECT_EQ(picture_error(picture(good), open).beyond_maps, kInfinity);
  }
}

TEST(PictureError, SummaryNamesTheNumberOfExcludedPixels) {
  EXPECT_EQ(error_in_words({.largest = 0.13912, .mean = 0.0126}), "largest error 0.139, mean 0.0126 of 1/255");
  EXPECT_EQ(error_in_words({.largest = 17.2, .mean = 2, .excluded = 3}),
            "largest error 17.2, mean 2 of 1/255; pixels excluded: 3");
}

}  // namespace

}  // namespace litfog::test
