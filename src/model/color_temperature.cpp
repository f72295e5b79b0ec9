// SPDX-License-Identifier: Apache-2.0
#include "litfog/color_temperature.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>

#include "float_limit.h"
#include "require.h"

namespace litfog {
namespace {

constexpr double kLastBlackBody = 4000;  // kelvin
constexpr double kFirstDaylight = 5000;

glm::dvec2 black_body(double t) {
  const double u = (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) /
                   (1 + 8.42420235e-4 * t + 7.08145163e-7 * t * t);  // CIE 1960
  const double v =
      (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) / (1 - 2.89741816e-5 * t + 1.61456053e-7 * t * t);
  return glm::dvec2(3 * u, 2 * v) / (2 * u - 8 * v + 4);
}

glm::dvec2 daylight(double t) {
  const double r = 1000 / t;
  const double x = t <= 7000 ? 0.244063 + r * (0.09911 + r * (2.9678 - r * 4.6070))
                             : 0.237040 + r * (0.24748 + r * (1.9018 - r * 2.0064));
  return {x, -0.275 + x * (2.870 - 3.000 * x)};
}

/// Tristimulus values of luminance 1.
glm::dvec3 tristimulus(const glm::dvec2& xy) { return {xy.x / xy.y, 1, (1 - xy.x - xy.y) / xy.y}; }

}  // namespace

glm::dvec2 chromaticity_of_temperature(double kelvin) {
  static_assert(kMinColorTemperature == 1000 && kMaxColorTemperature == 25000);
  kelvin = snapped(kelvin, kMinColorTemperature, kMaxColorTemperature);
  if (!(kelvin >= kMinColorTemperature && kelvin <= kMaxColorTemperature)) {
    require(ValueError{"kelvin", kelvin, "must be in [1000, 25000]"});
  }
  if (kelvin <= kLastBlackBody) return black_body(kelvin);
  if (kelvin >= kFirstDaylight) return daylight(kelvin);
  const double fraction = (kelvin - kLastBlackBody) / (kFirstDaylight - kLastBlackBody);
  const glm::dvec3 mixed = glm::mix(tristimulus(black_body(kelvin)), tristimulus(daylight(kelvin)), fraction);
  return glm::dvec2(mixed) / (mixed.x + mixed.y + mixed.z);
}

glm::dvec3 color_of_temperature(double kelvin) {
  constexpr glm::dmat3 kRgbFromXyz{{3.2406, -0.9689, 0.0557}, {-1.5372, 1.8758, -0.2040}, {-0.4986, 0.0415, 1.0570}};
  const glm::dvec3 rgb = glm::max(kRgbFromXyz * tristimulus(chromaticity_of_temperature(kelvin)), 0.0);
  return rgb / std::max({rgb.r, rgb.g, rgb.b});
}

}  // namespace litfog
