// SPDX-License-Identifier: Apache-2.0
#include "drawing/glare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace litfog::test {
using namespace drawing;
using render::Picture;

namespace {

constexpr double kHalfTurn = std::numbers::pi;
const double kUsual = 720 / (2 * std::tan(0.5));  ///< pixels per radian of 720 rows and 57 degrees

Picture black(int width, int height) { return {width, height, std::vector<float>(std::size_t(3 * width * height))}; }

float& at(Picture& picture, int x, int y, int channel = 1) {
  return picture.rgb[std::size_t(3 * (y * picture.width + x) + channel)];
}

double sum(const Picture& picture) {
  double sum = 0;
  for (const float light : picture.rgb) sum += double(light);
  return sum;
}

/// A lamp in the middle of a picture with an odd number of pixels a side, by green light alone.
Picture lamp(int side, float light) {
  Picture picture = black(side, side);
  at(picture, side / 2, side / 2) = light;
  return picture;
}

/// The fraction of a pixel's light that the eye brings into the pixel that is so many pixels off, by its function at
/// points that lie the closer together the nearer they are to the light.
double fraction(int x, int y, double pixels_per_radian) {
  // Of a pixel's half or whole side, t^3 has points as close as needed around its middle.
  constexpr int kSteps = 1000;
  const bool is_own = x == 0 && y == 0;
  const int steps = is_own ? kSteps : 200;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < steps; ++k) {
      const double s = 2 * (i + 0.5) / steps - 1;
      const double t = 2 * (k + 0.5) / steps - 1;
      const double u = is_own ? s * s * s : s;
      const double v = is_own ? t * t * t : t;
      const double weight = is_own ? 9 * s * s * t * t : 1;
      sum += weight * eye_spread(std::hypot(x + u / 2, y + v / 2) / pixels_per_radian);
    }
  }
  return sum / (double(steps) * steps) / (pixels_per_radian * pixels_per_radian);
}

TEST(Glare, EyeSpreadsAllLightAndNoMoreOverTheHemisphere) {
  constexpr int kSteps = 100'000;  // of the angle's logarithm
  const double least = std::log(1e-8);
  const double step = (std::log(kHalfTurn / 2) - least) / kSteps;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = std::exp(least + (i + 0.5) * step);
    sum += eye_spread(angle) * 2 * kHalfTurn * std::sin(angle) * angle * step;
  }
  EXPECT_NEAR(sum, 1, 5e-4);
}

TEST(Glare, EyeSpreadHasThePublishedValues) {
  const double degree = kHalfTurn / 180;
  EXPECT_NEAR(eye_spread(0), 0.384 * 2.61e6 + 0.478 * 20.91 / 8e-6 + 0.138 * 72.37 / 4e-4, 1);
  EXPECT_NEAR(eye_spread(degree), 0.478 * 20.91 / 1.061208 + 0.138 * 72.37 / 1.0404, 1e-9);
  EXPECT_NEAR(eye_spread(10 * degree), 0.478 * 20.91 / 1006.012008 + 0.138 * 72.37 / 100.4004, 1e-9);
}

TEST(Glare, PictureIsThatOfADirectConvolution) {
  for (const auto& [width, height] : {std::pair{9, 5}, {1, 7}, {6, 1}, {1, 1}}) {
    for (const double pixels_per_radian : {kUsual, 40.0, 20'000.0}) {
      Picture picture = black(width, height);
      for (std::size_t i = 0; i < picture.rgb.size(); ++i)
        picture.rgb[i] = float(1 + i * i % 17) * (i % 7 == 0 ? 100 : 1);
      const Picture seen = with_glare(picture, pixels_per_radian);
      std::vector<double> fractions;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) fractions.push_back(fraction(x, y, pixels_per_radian));
      }
      for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
        const int x = int(i) / 3 % width;
        const int y = int(i) / 3 / width;
        double expected = 0;
        for (std::size_t k = i % 3; k < picture.rgb.size(); k += 3) {
          const int dx = std::abs(int(k) / 3 % width - x);
          const int dy = std::abs(int(k) / 3 / width - y);
          expected += fractions[std::size_t(dy * width + dx)] * double(picture.rgb[k]);
        }
        EXPECT_NEAR(double(seen.rgb[i]), expected, 1e-3 * expected) << width << "x" << height << ", " << i;
      }
    }
  }
}

TEST(Glare, LampsLightIsKeptWhereItsGlareFits) {
  // 90 degrees to each side.
  const Picture seen = with_glare(lamp(1001, 1000), 500 / (kHalfTurn / 2));
  EXPECT_NEAR(sum(seen), 1000, 10);
}

TEST(Glare, GlareIsTheSameToAllSidesAndFallsWithTheAngle) {
  constexpr int kSide = 101;
  constexpr int kMiddle = kSide / 2;
  Picture seen = with_glare(lamp(kSide, 1e6f), kUsual);
  for (int y = 0; y <= kMiddle; ++y) {
    for (int x = 0; x <= kMiddle; ++x) {
      const float light = at(seen, kMiddle + x, kMiddle + y);
      for (const auto& [dx, dy] : {std::pair{-x, y}, {x, -y}, {-x, -y}, {y, x}}) {
        EXPECT_NEAR(at(seen, kMiddle + dx, kMiddle + dy), light, 1e-6f * light) << x << ", " << y;
      }
      EXPECT_LT(light, x == 0 ? 1e6f : at(seen, kMiddle + x - 1, kMiddle + y)) << x << ", " << y;
    }
  }
  EXPECT_EQ(at(seen, kMiddle, kMiddle, 0), 0);
}

TEST(Glare, LightAtOneEdgeDoesNotComeInAtTheOther) {
  Picture picture = black(300, 3);
  at(picture, 299, 1) = 1e6f;
  Picture seen = with_glare(picture, kUsual);
  EXPECT_LT(at(seen, 0, 1), 1e6 * 1.1 * eye_spread(299 / kUsual) / (kUsual * kUsual));
}

TEST(Glare, TwiceTheLightIsTwiceTheGlareAndTheBrighterLampIsTheLarger) {
  Picture seen = with_glare(lamp(201, 50'000), kUsual);
  Picture brighter = with_glare(lamp(201, 100'000), kUsual);
  int area = 0;
  int brighter_area = 0;
  for (std::size_t i = 1; i < seen.rgb.size(); i += 3) {
    EXPECT_NEAR(brighter.rgb[i], 2 * seen.rgb[i], 1e-4f * seen.rgb[i]);
    area += seen.rgb[i] > 1;
    brighter_area += brighter.rgb[i] > 1;
  }
  EXPECT_GT(area, 30);
  EXPECT_GT(brighter_area, 1.3 * area);
}

TEST(Glare, BlackPictureStaysBlack) {
  const Picture picture = black(64, 36);
  EXPECT_EQ(with_glare(picture, kUsual).rgb, picture.rgb);
}

TEST(Glare, LightThatIsNoNumberSpreadsNothing) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float light : {infinity, -infinity, std::numeric_limits<float>::quiet_NaN(), -1.0f}) {
    Picture seen = with_glare(lamp(5, light), kUsual);
    EXPECT_FALSE(at(seen, 2, 2) >= 0 && at(seen, 2, 2) < infinity) << light;
    at(seen, 2, 2) = 0;
    EXPECT_EQ(seen.rgb, black(5, 5).rgb) << light;
  }
  for (const float light : with_glare(lamp(5, 3e38f), kUsual).rgb) EXPECT_TRUE(std::isfinite(light));
}

TEST(Glare, ErrorInACornerIsAsStated) {
  // A lamp in the lower right corner of 16:9, and points of its glare along the radius and across it.
  const double x = 16.0 / 9 * std::tan(0.5);
  const double y = std::tan(0.5);
  const double cosine = 1 / std::sqrt(1 + x * x + y * y);
  EXPECT_NEAR(std::pow(cosine, -3), 3.4, 0.05);
  EXPECT_NEAR(1 / cosine, 1.5, 0.05);
  const double solid_angle = std::pow(cosine, 3);  // of a pixel, over one in the middle
  const double radius = std::hypot(x, y);
  for (const double pixels : {1.0, 2.0, 5.0, 10.0, 30.0, 60.0}) {
    const double distance = pixels / kUsual;
    for (int direction = 0; direction < 36; ++direction) {
      const double turn = direction * kHalfTurn / 18;
      const double along = distance * std::cos(turn);
      const double across = distance * std::sin(turn);
      const double px = x + (along * x - across * y) / radius;
      const double py = y + (along * y + across * x) / radius;
      const double dot = (x * px + y * py + 1) * cosine / std::sqrt(1 + px * px + py * py);
      const double seen = solid_angle * eye_spread(std::acos(dot));
      const double drawn = eye_spread(distance);
      EXPECT_LT(seen, drawn * std::pow(cosine, -3)) << pixels << ", " << direction;
      EXPECT_LT(drawn, seen / cosine * 1.02) << pixels << ", " << direction;
    }
  }
}

}  // namespace

}  // namespace litfog::test
