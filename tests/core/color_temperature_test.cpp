// SPDX-License-Identifier: Apache-2.0
#include "litfog/color_temperature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/value_errors.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

struct Published {
  const char* source;
  double kelvin, x, y;
};

// The black bodies: Wyszecki and Stiles 1982, "Color Science", table 1(3.11). A and D: CIE 15:2004, table T.3.
constexpr Published kPublished[]{{"black body", 2000, 0.52669, 0.41331}, {"A", 2855.54, 0.44758, 0.40745},
                                 {"black body", 3000, 0.43693, 0.40407}, {"black body", 4000, 0.38045, 0.37675},
                                 {"D50", 5002.8, 0.34567, 0.35851},      {"D55", 5502.1, 0.33243, 0.34744},
                                 {"D65", 6503.6, 0.31272, 0.32903},      {"D75", 7503.8, 0.29903, 0.31488}};

TEST(ColorTemperature, ChromaticitiesAreThePublishedOnes) {
  WorstError error("chromaticity", "black bodies and CIE illuminants", kChromaticityMaxError, "");
  for (const auto& [source, kelvin, x, y] : kPublished) {
    const glm::dvec2 xy = chromaticity_of_temperature(kelvin);
    error.add(std::max(std::abs(xy.x - x), std::abs(xy.y - y)), [&, s = source] { return std::string(s); });
  }
  error.check();
}

TEST(ColorTemperature, ColorsAreContinuousAndGrowBluer) {
  const auto blueness = [](double kelvin) {
    const glm::dvec3 color = color_of_temperature(kelvin);
    return color.b - color.r;
  };
  for (double kelvin = kMinColorTemperature; kelvin < kMaxColorTemperature; kelvin *= 1.001) {
    const double next = std::min(kelvin * 1.001, kMaxColorTemperature);
    EXPECT_GE(blueness(next), blueness(kelvin)) << kelvin;
    EXPECT_LT(blueness(next) - blueness(kelvin), 0.003) << kelvin;
  }
}

TEST(ColorTemperature, DaylightOfTheDisplaysWhiteIsWhite) {
  const glm::dvec3 white = color_of_temperature(6504);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(white[i], 1, 0.002) << i;
  EXPECT_EQ(color_of_temperature(1000).b, 0);
  EXPECT_EQ(color_of_temperature(1000).r, 1);
  EXPECT_GT(color_of_temperature(1950).b, 0);
}

TEST(ColorTemperature, LuminanceIsThatOfLinearSrgb) {
  EXPECT_DOUBLE_EQ(luminance(glm::dvec3(1)), 1);
  EXPECT_DOUBLE_EQ(luminance({10, 0, 1}), 2.126 + 0.0722);
}

TEST(ColorTemperature, TemperatureBeyondTheFormulasIsAnError) {
  for (const double kelvin : {0.0, 999.0, 25001.0, -5000.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(color_of_temperature(kelvin), std::invalid_argument) << kelvin;
  }
  EXPECT_EQ(error_of([] { color_of_temperature(std::nan("")); }), "kelvin = nan: must be in [1000, 25000]");
}

}  // namespace
}  // namespace litfog::test
