// SPDX-License-Identifier: Apache-2.0
#include "drawing/picture_file.h"

#include <OpenImageIO/imagebuf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "command/exit_status.h"
#include "command/temporary_directory.h"
#include "litfog/files/output_error.h"
#include "reference/srgb.h"

namespace litfog::test {
using namespace render;
using namespace command;

namespace {

namespace fs = std::filesystem;
using drawing::write_picture;
using litfog::test::srgb_from_linear;
using render::Picture;

class PictureFile : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }

  std::vector<float> read(const std::string& name) const {
    OIIO::ImageBuf image(path(name));
    std::vector<float> values(std::size_t(image.spec().image_pixels()) * 3);
    EXPECT_TRUE(image.get_pixels(image.roi(), OIIO::TypeDesc::FLOAT, values.data())) << image.geterror();
    return values;
  }

  litfog::test::TemporaryDirectory directory_;
};

Picture gradient(int width, int height, double scale) {
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height * 3; ++i) picture.rgb.push_back(float(scale * i / (width * height * 3)));
  return picture;
}

TEST_F(PictureFile, PngHoldsSrgbWithinTheDither) {
  const Picture picture = gradient(64, 48, 1);
  write_picture(path("a.png"), picture);
  const std::vector<float> values = read("a.png");
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASSERT_NEAR(values[i] * 255, srgb_from_linear(double(picture.rgb[i])) * 255, 1.01) << i;
  }
}

TEST_F(PictureFile, PngIsDitheredAroundTheTrueValue) {
  const double linear = 0.0105;
  write_picture(path("a.png"), {128, 128, std::vector<float>(128 * 128 * 3, float(linear))});
  std::set<float> levels;
  double sum = 0;
  const std::vector<float> values = read("a.png");
  for (const float value : values) {
    levels.insert(value);
    sum += double(value);
  }
  EXPECT_GE(levels.size(), 2u);
  EXPECT_NEAR(sum / double(values.size()) * 255, srgb_from_linear(linear) * 255, 0.05);
}

TEST_F(PictureFile, ShownPixelsAreThoseOfThePng) {
  const Picture picture = gradient(61, 47, 1.3);
  write_picture(path("a.png"), picture);
  const std::vector<float> values = read("a.png");
  const std::vector<std::uint8_t> pixels = drawing::shown_pixels(picture);
  ASSERT_EQ(pixels.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) ASSERT_EQ(pixels[i], std::lround(values[i] * 255)) << i;
}

TEST_F(PictureFile, PngClampsLightBeyondTheDisplay) {
  write_picture(path("a.png"), {1, 1, {-1.0f, 2.0f, 50.0f}});
  const std::vector<float> values = read("a.png");
  EXPECT_LE(values[0], 1.0f / 255);
  EXPECT_GE(values[1], 254.0f / 255);
  EXPECT_GE(values[2], 254.0f / 255);
}

TEST_F(PictureFile, ExrHoldsLinearLightBeyondOne) {
  const Picture picture = gradient(32, 16, 20);
  write_picture(path("a.exr"), picture);
  const std::vector<float> values = read("a.exr");
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASSERT_NEAR(values[i], picture.rgb[i], picture.rgb[i] / 2048 + 1e-7f) << i;  // half a unit of half's 11 bits
  }
}

TEST_F(PictureFile, ExrHoldsLightBeyondHalfFloats) {
  for (const float brightest : {65504.0f, 65505.0f, 1.25e9f}) {
    const std::string name = std::to_string(int(brightest)) + ".exr";  // OpenImageIO remembers files by their names
    write_picture(path(name), {1, 2, {0.1f, 0.2f, 0.3f, 1, brightest, 2}});
    EXPECT_EQ(read(name)[4], brightest);
    const OIIO::ImageBuf image(path(name));
    EXPECT_EQ(image.spec().format, brightest > 65504 ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::HALF);
  }
}

TEST_F(PictureFile, ExrHoldsNoTime) {
  write_picture(path("a.exr"), gradient(4, 4, 1));
  std::ifstream file(path("a.exr"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(bytes.find("compression"), std::string::npos);  // attributes have their names in the file
  EXPECT_EQ(bytes.find("capDate"), std::string::npos);
}

TEST_F(PictureFile, UnwritablePathIsAnError) {
  const Picture picture = gradient(2, 2, 1);
  EXPECT_THROW(write_picture(path("none/a.png"), picture), OutputError);
  EXPECT_THROW(write_picture(path(""), picture), OutputError);
  EXPECT_THROW(write_picture(path(std::string(300, 'a') + ".png"), picture), OutputError);
}

}  // namespace

}  // namespace litfog::test
