// SPDX-License-Identifier: Apache-2.0
#include "fit/light_pictures.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <vector>

#include "litfog/airlight.h"

namespace litfog::test {
namespace {

using namespace fit;

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // sRGB: the library would make it linear in steps of 1/255

  /// Linear.
  double at(int x, int y, int channel = 0) const {
    const double level = rgb[std::size_t((y * width + x) * 3 + channel)] / 255.;
    return level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4);
  }
};

Picture read_png(const std::string& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
  image.format = PNG_FORMAT_RGB;
  Picture picture{int(image.width), int(image.height), std::vector<std::uint8_t>(image.width * image.height * 3)};
  EXPECT_TRUE(png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr));
  return picture;
}

Light spot() {
  return {.name = "spot",
          .color = {1, 0.5, 0},
          .attenuation = {1, 0, 0.01},
          .cone = {.profile = ConeProfile::smoothstep, .inner = 0.1, .outer = 0.3}};
}

TEST(FogPicture, ViewIsTheAirlightThatAnEyeBesideTheBeamSees) {
  const Picture picture = read_png(draw_fog_picture(spot()));
  ASSERT_EQ(picture.height, kFogPictureHeight);
  const double metres_per_pixel = kFogPictureMetres / kFogPictureWidth;
  for (std::size_t view = 0; view < 3; ++view) {
    const Fog fog = Fog::from_visibility(FogMode::exp, kFogPictureVisibilities[view]);
    for (const auto& [x, y] : {std::pair{30, 45}, {60, 40}, {100, 30}, {150, 50}}) {
      // The lamp is 6 m from the left, the eye 30 m from the middle.
      const glm::dvec3 point{-6 + (x + 0.5) * metres_per_pixel, (45 - y - 0.5) * metres_per_pixel, 0};
      const glm::dvec3 eye{14, 0, 30};
      const PlacedLight placed{.light = spot(), .position = {}, .direction = {1, 0, 0}};
      const EyeRay ray{.origin = eye, .direction = glm::normalize(point - eye)};
      const double expected = 16 * kAirlightUnit * reference_airlight(placed, {fog}, ray);
      const int column = int(view) * (kFogPictureWidth + 2) + x;
      double fast;
      airlight(placed, {fog}, {&ray, 1}, LampLeg::fogged, {&fast, 1});
      fast = std::min(1.0, 16 * kAirlightUnit * fast);
      EXPECT_NEAR(picture.at(column, y), fast, 0.005 * std::sqrt(fast) + 0.0002) << "half a step of sRGB";
      // Airlight's error times the exposure, and a step of sRGB.
      EXPECT_NEAR(picture.at(column, y), std::min(1.0, expected), 4 * kAirlightMaxError + 0.01) << x << " " << y;
    }
  }
}

TEST(FogPicture, ViewIsMirroredAtTheBeamAndHasTheLightsColor) {
  const Picture picture = read_png(draw_fog_picture(spot()));
  double brightest = 0;
  for (int x = 0; x < kFogPictureWidth; ++x) {
    for (int y = 0; y < kFogPictureHeight / 2; ++y) {
      EXPECT_EQ(picture.at(x, y), picture.at(x, kFogPictureHeight - 1 - y));
      EXPECT_NEAR(picture.at(x, y, 1), picture.at(x, y) / 2, 0.01);
      EXPECT_EQ(picture.at(x, y, 2), 0);
      brightest = std::max(brightest, picture.at(x, y));
    }
  }
  EXPECT_GT(brightest, 0.01);
}

}  // namespace
}  // namespace litfog::test
