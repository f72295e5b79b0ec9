// SPDX-License-Identifier: Apache-2.0
#include "drawing/heat_map.h"

#include <gtest/gtest.h>

#include <glm/glm.hpp>
#include <limits>

#include "render/pixel.h"

namespace litfog::test {
using namespace drawing;
using namespace measure;
using namespace render;

namespace {

double luminance(const glm::dvec3& color) { return glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722)); }

TEST(HeatMap, ColorsGrowBrighterFromBlackToWhite) {
  EXPECT_LT(luminance(heat_color(0)), 1e-6);
  EXPECT_NEAR(luminance(heat_color(1)), 1, 1e-4);
  for (int i = 1; i <= 255; ++i) {
    EXPECT_GT(luminance(heat_color(i / 255.0)), luminance(heat_color((i - 1) / 255.0))) << i;
  }
}

TEST(HeatMap, EachPixelsErrorIsShownOnTheScaleMagnifiedByAWholeNumber) {
  const float inf = std::numeric_limits<float>::infinity();
  const PictureError error{.width = 6, .height = 1, .pixels = {0, 0.1f, 3.1623f, 100, inf, -1}};
  const Picture map = make_heat_map(error, "test");
  ASSERT_GE(map.width, 640);
  ASSERT_EQ(map.width % 6, 0);
  const int cell = map.width / 6;
  const glm::dvec3 expected[] = {heat_color(0), heat_color(0), heat_color(0.5),
                                 heat_color(1), heat_color(1), {1, 0, 0}};
  for (int i = 0; i < 6; ++i) {
    for (const int x : {i * cell, (i + 1) * cell - 1}) {
      EXPECT_LT(glm::distance(pixel(map, x, cell - 1), expected[i]), 1e-3f) << i;
    }
  }
}

TEST(HeatMap, PictureOfItsColorsAloneHasThePicturesSize) {
  const PictureError error{.width = 2, .height = 2, .pixels = {0, 3.1623f, 100, -1}};
  const Picture map = heat_picture(error);
  ASSERT_EQ(map.width, 2);
  ASSERT_EQ(map.height, 2);
  const glm::dvec3 expected[] = {heat_color(0), heat_color(0.5), heat_color(1), {1, 0, 0}};
  for (int i = 0; i < 4; ++i) EXPECT_LT(glm::distance(pixel(map, i % 2, i / 2), expected[i]), 1e-3f) << i;
}

TEST(HeatMap, NarrowPictureIsMagnifiedNoFurtherThanToTwoThousandRows) {
  const PictureError error{.width = 1, .height = 1000, .pixels = std::vector<float>(1000, 100.0f)};
  const Picture map = make_heat_map(error, "test");
  EXPECT_EQ(map.width, 640);  // the text's width
  EXPECT_LT(map.height, 2048 + 100);
  EXPECT_LT(glm::distance(pixel(map, 1, 1999), glm::dvec3(heat_color(1))), 1e-3f);
  EXPECT_LT(luminance(pixel(map, 2, 1999)), 0.02);  // beside the picture
  const PictureError tall{.width = 1, .height = 16384, .pixels = std::vector<float>(16384, 100.0f)};
  EXPECT_LT(make_heat_map(tall, "test").height, 16384 + 100);
}

TEST(HeatMap, ScaleWithTextIsUnderTheMap) {
  const PictureError error{.width = 700, .height = 2, .pixels = std::vector<float>(1400, 0.0f)};
  const Picture map = make_heat_map(error, "test");
  double brightest = 0;
  for (int y = 3; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) brightest = std::max(brightest, luminance(pixel(map, x, y)));
  }
  EXPECT_GT(brightest, 0.9);  // the end of the scale
}

}  // namespace

}  // namespace litfog::test
