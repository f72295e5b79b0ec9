// SPDX-License-Identifier: Apache-2.0
#include "litfog/light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <stdexcept>
#include <string>

#include "litfog/attenuation.h"
#include "litfog/visual_threshold.h"
#include "reference/digits50.h"
#include "reference/double_limits.h"
#include "reference/near_numbers.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

/// The error of a light that differs from the accepted default by one change.
template <typename Checked = Light, typename Change>
std::string error_after(const Change& change) {
  Checked light;
  change(light);
  const auto error = find_error(light);
  return error ? to_string(*error) : "accepted";
}

TEST(Light, DefaultLightIsAccepted) { EXPECT_FALSE(find_error(Light{})); }

TEST(Light, ColorThatIsNoLightIsAnError) {
  EXPECT_EQ(error_after([](Light& l) { l.color.r = -1; }), "color.r = -1: must be finite and >= 0");
  EXPECT_EQ(error_after([](Light& l) { l.color.g = kNan; }), "color.g = nan: must be finite and >= 0");
  EXPECT_EQ(error_after([](Light& l) { l.color.b = kInfinity; }), "color.b = inf: must be finite and >= 0");
}

TEST(Light, BlackAndOverbrightColorsAreAccepted) {
  EXPECT_EQ(error_after([](Light& l) { l.color = {0, 0, 0}; }), "accepted");
  EXPECT_EQ(error_after([](Light& l) { l.color = {1e6, 1, 0}; }), "accepted");
}

TEST(Light, NegativeOrInfiniteDensityScaleIsAnError) {
  EXPECT_EQ(error_after([](Light& l) { l.density_scale = -0.4; }), "density_scale = -0.4: must be finite and >= 0");
  EXPECT_EQ(error_after([](Light& l) { l.density_scale = kInfinity; }), "density_scale = inf: must be finite and >= 0");
  EXPECT_EQ(error_after([](Light& l) { l.density_scale = kNan; }), "density_scale = nan: must be finite and >= 0");
  EXPECT_EQ(error_after([](Light& l) { l.density_scale = 0; }), "accepted");
}

TEST(Light, FlashThatNoLampHasOrNoColourHoldsIsAnError) {
  Flash flash{1, 1, {{{0, 0.1, 1e6}}}};
  EXPECT_EQ(error_after([&](Light& l) { l.flash = flash; }), "accepted");
  EXPECT_EQ(error_after([&](Light& l) {
              l.flash = flash;
              l.color.g = 1e305;
            }),
            "color = inf: must be finite in each flash");
  EXPECT_TRUE(error_after([&](Light& l) {
                l.attenuation.quadratic = 1;
                l.source_radius = 0.1;
                l.color.r = 1e301;
                l.flash = flash;
              }).starts_with("source_radius = 0.1: must leave color"));
  flash.period = 0;
  EXPECT_EQ(error_after([&](Light& l) { l.flash = flash; }), "flash.period = 0: must be in (0, 3600]");
}

TEST(Light, SourceRadiusThatNoLawCanHaveIsAnError) {
  const auto error = [](double radius, const Attenuation& attenuation, double red = 1, double threshold = 0.05) {
    return error_after([&](Light& l) {
      l.threshold = threshold;
      l.attenuation = attenuation;
      l.source_radius = radius;
      l.color.r = red;
    });
  };
  EXPECT_EQ(error(-1, {1, 0, 1}), "source_radius = -1: must be finite and >= 0");
  EXPECT_EQ(error(kNan, {1, 0, 1}), "source_radius = nan: must be finite and >= 0");
  EXPECT_EQ(error(kInfinity, {1, 0, 1}), "source_radius = inf: must be finite and >= 0");
  EXPECT_EQ(error(0.1, {1, 1, 0}), "source_radius = 0.1: must be 0 where attenuation.quadratic is 0");
  EXPECT_EQ(error(2, {1, 0, 0.25}), "accepted");
  EXPECT_EQ(error(2.1, {1, 0, 0.25}), "source_radius = 2.1: must be <= sqrt(attenuation.constant / quadratic)");
  EXPECT_EQ(error(0.1, {0, 0, 1}), "source_radius = 0.1: must be <= sqrt(attenuation.constant / quadratic)");
  const char* const kOutOfRange = ": must leave color / (attenuation.quadratic source_radius^2) finite";
  EXPECT_EQ(error(1e-9, {1, 0, 1e-3}, 1e300), std::string("source_radius = 1e-09") + kOutOfRange);
  EXPECT_EQ(error(1e-200, {1, 0, 1}), std::string("source_radius = 1e-200") + kOutOfRange);
  EXPECT_EQ(error(1e-5, {1, 0, 1}, 1, 1e-297), "accepted");
  EXPECT_EQ(error(1e-5, {1, 0, 1}, 1, 1e-298), std::string("source_radius = 1e-05") + kOutOfRange);
  EXPECT_EQ(error(0, {1, 1, 0}), "accepted");
}

TEST(Photometric, LawIsTheDiscsBesideTheLampAndTheLightsFarAway) {
  Random random(40);
  for (int i = 0; i < 10'000; ++i) {
    Light light;
    light.color = {random.log_uniform(1e-3, 1e3), 1, 0};
    light.attenuation = {random.log_uniform(1e-2, 1e2), random.chance(0.5) ? 0 : random.log_uniform(1e-6, 10),
                         random.log_uniform(1e-6, 1e2)};
    light.threshold = random.uniform(1e-3, 0.9);
    const auto [c, l, q] = light.attenuation;
    light.source_radius = random.uniform(0.001, 0.999) * std::sqrt(c / q);
    const Light near = photometric(light);
    ASSERT_FALSE(find_error(near));
    const long double radius = light.source_radius;
    const bool is_dark = light.threshold * q * radius * radius >= 1;
    for (const double range : {0., 1e-3, 0.1, 1., 30., 1e4}) {
      const long double r = range;
      const long double stated = light.color.r / (q * radius * radius + l * r + q * r * r);
      EXPECT_NEAR(near.color.r * attenuation_at(near.attenuation, range), is_dark ? 0 : double(stated),
                  double(3e-15L * stated));
    }
    if (is_dark) continue;
    EXPECT_NEAR(near.threshold * near.color.r / (light.threshold * light.color.r), 1, 2 * kPhotometricMaxError);
    EXPECT_NEAR(candela(near).r / candela(light).r, 1, 2 * kPhotometricMaxError);
    EXPECT_EQ(photometric(near).color, near.color) << "it has no source radius";
  }
  Light light;
  light.color = {3, 2, 1};
  EXPECT_EQ(photometric(light).color, light.color);
  EXPECT_EQ(candela(light).r, kInfinity);
  light.source_radius = -1;
  EXPECT_THROW(photometric(light), std::invalid_argument);
}

RC_GTEST_PROP(Photometric, BoundsHoldAtTheLargestSourceRadiusAndTheBrightestThreshold, ()) {
  Light light;
  light.attenuation = {*near_one_of({1e-3, 0.5, 1, 19.9}), *near_one_of({0, 0.1, 1}), *near_one_of({1e-6, 0.01, 1, 3})};
  const auto [c, l, q] = light.attenuation;
  RC_PRE(!find_error(light) && (l == 0 || l > 1e-100));
  const double largest = std::sqrt(c / q);
  light.source_radius = *near_one_of({largest, 0.1, 1});
  const Digits50 source = Digits50(q) * light.source_radius * light.source_radius;
  light.threshold = *near_one_of({0.05, 0.5, 1 / double(source)});
  RC_PRE(!find_threshold_error(light.threshold));
  if (light.source_radius > largest * (1 + 1e-6)) {
    RC_ASSERT_THROWS_AS(photometric(light), std::invalid_argument);
    return;
  }
  const Light near = photometric(light);
  RC_ASSERT(!find_error(near));
  const Digits50 threshold = light.threshold * source;
  RC_PRE(abs(threshold - 1) > kPhotometricMaxError);  // whose rounding decides
  RC_ASSERT(near.attenuation.constant == 1);
  RC_ASSERT(relative_error(near.attenuation.linear, Digits50(l / source)) <= kPhotometricMaxError);
  RC_ASSERT(relative_error(near.attenuation.quadratic, Digits50(q / source)) <= kPhotometricMaxError);
  const bool is_dark = threshold > 1;
  RC_ASSERT(relative_error(near.color.r, is_dark ? Digits50(0) : Digits50(1 / source)) <= kPhotometricMaxError);
  RC_ASSERT(is_dark || relative_error(near.threshold, threshold) <= kPhotometricMaxError);
}

TEST(Light, ErrorOfAPartIsTheLightsError) {
  EXPECT_EQ(error_after([](Light& l) {
              l.attenuation = {0, 0, 0};
            }),
            "attenuation.constant = 0: must be > 0 where linear and quadratic are 0");
  EXPECT_EQ(error_after([](Light& l) { l.threshold = 1; }), "threshold = 1: must be in (0, 1)");
  EXPECT_EQ(error_after([](Light& l) { l.cone = Cone::cosine(3, 1); }), "cone.half_angle = 3: must be in (0, pi/2]");
  EXPECT_EQ(error_after([](Light& l) { l.cone = Cone::smoothstep(1, 0.5); }), "cone.inner = 1: must be in [0, outer)");
}

TEST(VisualThreshold, ThresholdIsTheFormulasAndRisesWithTheBackground) {
  EXPECT_NEAR(illuminance_threshold(1) / std::pow(10, -6.66), 1, 1e-12);
  EXPECT_NEAR(illuminance_threshold(1000) / std::pow(10, 1.71 + 0.45 - 6.66), 1, 1e-12);
  double before = illuminance_threshold(0);
  EXPECT_EQ(illuminance_threshold(1e-7), before);
  for (double background = 1e-5; background <= kMaxBackground; background *= 2) {
    const double threshold = illuminance_threshold(background);
    EXPECT_GT(threshold, before) << background;
    before = threshold;
  }
}

// The steps change where the background's luminance is, as commonly given, 50, 1000 and 12,000 cd/m2.
TEST(VisualThreshold, FormulaPassesMidwayBetweenThePilotsSteps) {
  for (const auto& [background, step] : {std::pair{50., 1u}, {1000., 2u}, {12'000., 3u}}) {
    const double below = kVisualThresholds[step].illuminance;
    const double above = kVisualThresholds[step + 1].illuminance;
    EXPECT_NEAR(illuminance_threshold(background) / std::sqrt(below * above), 1, 0.02) << background;
  }
}

template <typename Change>
std::string placed_error_after(const Change& change) {
  return error_after<PlacedLight>(change);
}

TEST(PlacedLight, DefaultPlacedLightIsAccepted) { EXPECT_FALSE(find_error(PlacedLight{})); }

TEST(PlacedLight, PositionBeyondTheUseOfFloatIsAnError) {
  const std::string rule = ": must be at most 16777216 in magnitude";
  EXPECT_EQ(kMaxPosition, 16777216);
  EXPECT_EQ(placed_error_after([](PlacedLight& p) { p.position.x = kNan; }), "position.x = nan" + rule);
  EXPECT_EQ(placed_error_after([](PlacedLight& p) { p.position.x = 1e300; }), "position.x = 1e+300" + rule);
  EXPECT_EQ(placed_error_after([](PlacedLight& p) { p.position.y = -kInfinity; }), "position.y = -inf" + rule);
  EXPECT_EQ(placed_error_after([](PlacedLight& p) { p.position.z = -16777219; }), "position.z = -16777219" + rule);
  EXPECT_EQ(placed_error_after([](PlacedLight& p) { p.position = {kMaxPosition, -kMaxPosition, -0.0}; }), "accepted");
}

TEST(PlacedLight, DirectionThatIsNoUnitVectorIsAnError) {
  const std::string rule = ": length must be 1 within 1e-6";
  const auto error_of = [](const glm::dvec3& direction) {
    return placed_error_after([&](PlacedLight& p) { p.direction = direction; });
  };
  EXPECT_EQ(kDirectionTolerance, 1e-6);
  EXPECT_EQ(error_of({0, 0, -0.5}), "direction = 0.5" + rule);
  EXPECT_EQ(error_of({0, 0, 0}), "direction = 0" + rule);
  EXPECT_EQ(error_of({0, kNan, 1}), "direction = nan" + rule);
  EXPECT_EQ(error_of({-kInfinity, 0, 0}), "direction = inf" + rule);
  EXPECT_EQ(error_of({1e200, 0, 0}), "direction = inf" + rule);
  EXPECT_EQ(error_of({0, 0, 1 + 2e-6}), "direction = 1.000002" + rule);
  EXPECT_EQ(error_of({0, 0, 1 - 0.9e-6}), "accepted");
}

TEST(PlacedLight, DirectionNormalisedInFloatIsAccepted) {
  Random random(61);
  for (int i = 0; i < 10000; ++i) {
    const glm::vec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.01, 1));
    ASSERT_EQ(placed_error_after([&](PlacedLight& p) { p.direction = glm::dvec3(glm::normalize(v)); }), "accepted");
  }
}

TEST(PlacedLight, ErrorOfTheLightIsThePlacedLightsError) {
  EXPECT_EQ(placed_error_after([](PlacedLight& p) { p.light.threshold = 1; }), "threshold = 1: must be in (0, 1)");
}

}  // namespace
}  // namespace litfog::test
