// SPDX-License-Identifier: Apache-2.0
#include "render/display.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

namespace litfog::test {
using namespace render;

namespace {

constexpr glm::vec3 kSodium{4, 2, 0.5f};
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

glm::vec3 neutral(const glm::vec3& color) { return toned(ToneCurve::neutral, color); }

/// Where the middle channel lies between the least and the largest: it and their order are the hue.
float hue(const glm::vec3& color) { return (color.g - color.b) / (color.r - color.b); }

Picture row(const std::vector<glm::vec3>& colors) {
  Picture picture{int(colors.size()), 1, {}};
  for (const glm::vec3& color : colors) picture.rgb.insert(picture.rgb.end(), {color.r, color.g, color.b});
  return picture;
}

Picture with_exposure(const Picture& picture, double ev, ToneCurve tone) {
  return displayed(picture, {.exposure = {.ev = ev}, .tone = tone});
}

// Computed by hand from the published definition: F90 0.04, compression from 0.76, desaturation 0.15.
TEST(ToneCurve, NeutralHasItsPublishedValues) {
  const auto expect = [](const glm::vec3& color, const glm::vec3& shown) {
    EXPECT_LT(glm::distance(neutral(color), shown), 2e-6f) << color.r << ", " << color.g << ", " << color.b;
  };
  expect({0, 0, 0}, {0, 0, 0});
  expect({0.04f, 0.04f, 0.04f}, {0.01f, 0.01f, 0.01f});  // 6.25 x^2
  expect({0.5f, 0.3f, 0.04f}, {0.47f, 0.27f, 0.01f});    // less 0.04 - 0.01
  expect({0.5f, 0.3f, 0.1f}, {0.46f, 0.26f, 0.06f});     // less 0.04
  expect({0.8f, 0.8f, 0.8f}, {0.76f, 0.76f, 0.76f});     // where the compression begins
  expect({1.04f, 1.04f, 1.04f}, {0.88f, 0.88f, 0.88f});  // 1 - 0.24^2 / 0.48
  // Largest channel 4 - 0.04, compressed to 1 - 0.0576 / 3.44; scaled by that, then mixed with it as white.
  const double peak = 1 - 0.0576 / 3.44;
  const double white = 1 - 1 / (0.15 * (3.96 - peak) + 1);
  const glm::dvec3 scaled = glm::dvec3(3.96, 1.96, 0.46) * (peak / 3.96);
  expect(kSodium, glm::vec3(glm::mix(scaled, glm::dvec3(peak), white)));
}

TEST(ToneCurve, NeutralRisesWithoutAJumpAndStaysBelowWhite) {
  for (const glm::vec3& color : {glm::vec3(1), glm::vec3(1, 0.5f, 0.125f), glm::vec3(0, 0, 1), glm::vec3(1, 1, 0.9f)}) {
    float before = -1e-7f;
    for (float light = 0; light < 100; light += light < 2 ? 1e-4f : 1e-2f) {
      const glm::vec3 shown = neutral(color * light);
      const float peak = std::max({shown.r, shown.g, shown.b});
      ASSERT_GE(peak, before - 2e-7f) << light;
      ASSERT_LT(peak - before, light < 2 ? 2.1e-4f : 2.1e-2f) << light;  // a slope of at most 2
      ASSERT_LE(peak, 1.0f) << light;
      before = peak;
    }
  }
}

TEST(ToneCurve, NeutralIsContinuousAtItsJoints) {
  constexpr float kStep = 1e-6f;
  for (const glm::vec3& joint :
       {glm::vec3(0.08f), glm::vec3(0.3f, 0.2f, 0.08f), glm::vec3(0.8f), glm::vec3(0.8f, 0.4f, 0.1f)}) {
    EXPECT_LT(glm::distance(neutral(joint - kStep), neutral(joint + kStep)), 8 * kStep);
  }
}

TEST(ToneCurve, ClipLeavesColorsUpToOneAndCutsEachChannel) {
  for (float light = 0; light <= 1; light += 1.0f / 512) {
    EXPECT_EQ(toned(ToneCurve::clip, {light, 0.5f, 1 - light}), glm::vec3(light, 0.5f, 1 - light));
  }
  EXPECT_EQ(toned(ToneCurve::clip, {1.5f, 0.25f, 1e30f}), glm::vec3(1, 0.25f, 1));
}

TEST(ToneCurve, SodiumLampKeepsItsHueByNeutralAndIsYellowByClip) {
  for (const float light : {0.1f, 1.0f, 4.0f, 16.0f}) {
    EXPECT_NEAR(hue(neutral(kSodium * light)), hue(kSodium), 1e-4f) << light;
  }
  const glm::vec3 cut = toned(ToneCurve::clip, kSodium);
  EXPECT_EQ(cut.r, cut.g);
  EXPECT_LT(cut.b, cut.g);
}

TEST(Exposure, AStopDoublesTheLight) {
  const Picture shown = with_exposure(row({{0.1f, 0.2f, 0.3f}}), 1, ToneCurve::clip);
  EXPECT_EQ(shown.rgb, (std::vector<float>{0.2f, 0.4f, 0.6f}));
  EXPECT_EQ(with_exposure(shown, -1, ToneCurve::clip).rgb, (std::vector<float>{0.1f, 0.2f, 0.3f}));
}

TEST(Exposure, LightThatIsNoNumberIsBlackAndInfiniteLightIsWhite) {
  for (const ToneCurve tone : {ToneCurve::neutral, ToneCurve::clip}) {
    for (const double ev : {-kMaxExposure, 0.0, kMaxExposure}) {
      const Picture shown = with_exposure(row({{kNan, -1, -kInfinity}, {kInfinity, kInfinity, kInfinity}}), ev, tone);
      EXPECT_EQ(shown.rgb, (std::vector<float>{0, 0, 0, 1, 1, 1}));
    }
    const Picture shown = with_exposure(row({{kInfinity, kNan, 0.5f}}), 0, tone);
    for (const float value : shown.rgb) EXPECT_TRUE(value >= 0 && value <= 1) << value;
  }
}

TEST(AutoExposure, PutsOneInTwentyBeyondFourFifths) {
  std::vector<glm::vec3> colors;
  for (int i = 0; i < 1000; ++i) colors.emplace_back(std::pow(1.005f, float(i)), 1, 0);
  const Picture picture = row(colors);
  const double ev = auto_exposure(picture);
  EXPECT_EQ(ev, std::round(100 * ev) / 100);
  const Picture shown = with_exposure(picture, ev, ToneCurve::clip);
  int bright = 0;
  int nearly = 0;
  for (std::size_t i = 0; i < shown.rgb.size(); i += 3) {
    bright += shown.rgb[i] > 0.8f * 1.009f;
    nearly += shown.rgb[i] > 0.8f / 1.009f;
  }
  EXPECT_LE(bright, 50);
  EXPECT_GE(nearly, 50);
}

TEST(AutoExposure, BlackPictureHasNone) {
  EXPECT_EQ(auto_exposure(row(std::vector<glm::vec3>(100, glm::vec3(0)))), 0);
  EXPECT_EQ(auto_exposure({}), 0);
}

TEST(AutoExposure, LightThatIsNotFiniteDoesNotCount) {
  EXPECT_EQ(auto_exposure(row({{kNan, 1, 1}, {kInfinity, 0, 0}, {1, 1, -kInfinity}})), 0);
  const glm::vec3 grey(12.5f);
  EXPECT_EQ(auto_exposure(row({{kNan, 1, 1}, grey, {kInfinity, 0, 0}})), auto_exposure(row({grey})));
}

TEST(AutoExposure, BlackSkyAndAFewBrightLampsDoNotChangeIt) {
  std::vector<glm::vec3> colors(1000, glm::vec3(0.3f * 64));
  EXPECT_EQ(auto_exposure(row(colors)), -6);
  colors.resize(100'000, glm::vec3(0));
  for (std::size_t i = 0; i < 9; ++i) colors[i] = glm::vec3(60'000);
  EXPECT_EQ(auto_exposure(row(colors)), -6);
}

TEST(AutoExposure, MiddlePixelIsReadableUnlessTheBrightestWouldBeWhite) {
  std::vector<glm::vec3> colors(1000, glm::vec3(0.03f / 32));
  std::fill_n(colors.begin(), 60, glm::vec3(0.1f));
  EXPECT_EQ(auto_exposure(row(colors)), 5);
  std::fill_n(colors.begin(), 60, glm::vec3(1));
  EXPECT_EQ(auto_exposure(row(colors)), 2.32);
}

TEST(AutoExposure, LitPlaceInADarkPictureIsNotWhite) {
  for (const std::size_t lit : {1'100u, 4'000u}) {  // out of 100,000 pixels
    std::vector<glm::vec3> colors(100'000, glm::vec3(0.001f));
    for (std::size_t i = 0; i < lit; ++i) colors[i] = glm::vec3(128);
    const double ev = auto_exposure(row(colors));
    EXPECT_EQ(ev, -4.68) << lit;
    EXPECT_LT(neutral(glm::vec3(128) * float(std::exp2(ev))).r, 254.0f / 255) << lit;
  }
}

TEST(AutoExposure, OneBrightPixelAmongBlackIsShown) {
  std::vector<glm::vec3> colors(1000, glm::vec3(0));
  colors[17] = {4, 19.2f, 2};
  EXPECT_EQ(auto_exposure(row(colors)), -6);
}

TEST(AutoExposure, ExposureStaysWithinWhatAnExposureMayBe) {
  EXPECT_EQ(auto_exposure(row({glm::vec3(1e-30f)})), kMaxExposure);
  EXPECT_EQ(auto_exposure(row({glm::vec3(1e30f)})), -kMaxExposure);
}

}  // namespace

}  // namespace litfog::test
