// SPDX-License-Identifier: Apache-2.0
#include "litfog/density_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

#include "model/density_profile_text.h"
#include "reference/digits50.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"
#include "reference/ulp.h"
#include "value_errors.h"

namespace litfog::test {
namespace {

DensityProfile profile_of(std::initializer_list<DensityKnot> knots) {
  return make_density_profile(std::span(knots.begin(), knots.size()));
}
DensityProfile profile_of_layers(std::initializer_list<FogLayer> layers) {
  return make_density_profile(std::span(layers.begin(), layers.size()));
}

DensityProfile random_profile(Random& random) {
  std::vector<DensityKnot> knots;
  double height = random.uniform(-100, 1000);
  for (int count = random.below(int(kMaxDensityKnots) + 1); count > 0; --count) {
    knots.push_back({height, random.chance(0.3) ? 0 : random.log_uniform(1e-6, 10)});
    height += random.log_uniform(1e-4, 1e4);
  }
  return make_density_profile(knots);
}

Digits50 exact_density(const DensityProfile& profile, const Digits50& height) {
  if (profile.count == 0) return 0;
  const auto knots = profile.used();
  if (height <= knots.front().height) return knots.front().density;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const auto [from, low] = knots[i - 1];
    const auto [to, high] = knots[i];
    if (height <= to) {
      return Digits50(low) + (Digits50(high) - Digits50(low)) * (height - from) / (Digits50(to) - Digits50(from));
    }
  }
  return knots.back().density;
}

/// The mean along a ray by quadrature in 50 digits, from knot to knot by two Gaussian nodes.
Digits50 exact_mean(const DensityProfile& profile, double height_a, double height_b) {
  const Digits50 low = std::min(height_a, height_b), high = std::max(height_a, height_b);
  if (low == high) return exact_density(profile, low);
  std::vector<Digits50> cuts{low, high};
  for (const DensityKnot& knot : profile.used()) {
    if (knot.height > low && knot.height < high) cuts.insert(cuts.end() - 1, knot.height);
  }
  Digits50 sum = 0;
  const Digits50 node = 1 / sqrt(Digits50(3));
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const Digits50 half = (cuts[i] - cuts[i - 1]) / 2, middle = (cuts[i] + cuts[i - 1]) / 2;
    sum += half * (exact_density(profile, middle - half * node) + exact_density(profile, middle + half * node));
  }
  return sum / (high - low);
}

std::string describe(const DensityProfile& profile, double height_a, double height_b) {
  std::string text = std::to_string(height_a) + " to " + std::to_string(height_b) + ", knots";
  for (const auto& [height, density] : profile.used()) {
    text += " " + std::to_string(height) + ":" + std::to_string(density);
  }
  return text;
}

TEST(DensityProfile, MeanDensityHasItsStatedErrorOfAMicrometreToAHundredKilometres) {
  Random random(411);
  WorstError error("mean_density", "rise 0, 1e-6..1e5 m, 0 to 8 knots", kMeanDensityMaxError, "relative");
  for (int i = 0; i < 30'000; ++i) {
    const DensityProfile profile = random_profile(random);
    // An end on a knot's height to the last bit, or next to it, is the hardest.
    double a = random.uniform(-200, 5000);
    if (profile.count > 0 && random.chance(0.5)) a = random.pick(profile.used()).height;
    if (random.chance(0.2)) a = std::nextafter(a, random.chance(0.5) ? 1e9 : -1e9);
    double b = a;
    if (random.chance(0.9)) b += random.log_uniform(1e-6, 1e5) * (random.chance(0.5) ? 1 : -1);
    if (profile.count > 0 && random.chance(0.2)) b = random.pick(profile.used()).height;
    error.add(relative_error(mean_density(profile, a, b), exact_mean(profile, a, b)),
              [&] { return describe(profile, a, b); });
    ASSERT_EQ(mean_density(profile, a, b), mean_density(profile, b, a));
    ASSERT_EQ(optical_depth(profile, a, b, 7), 7 * mean_density(profile, a, b));
  }
  error.check();
}

TEST(DensityProfile, DensityAtAKnotIsTheKnotsToTheLastBit) {
  Random random(412);
  for (int i = 0; i < 1000; ++i) {
    const DensityProfile profile = random_profile(random);
    for (const auto& [height, density] : profile.used()) {
      EXPECT_EQ(profile_density_at(profile, height), density);
      EXPECT_EQ(mean_density(profile, height, height), density);
    }
  }
}

TEST(DensityProfile, MeanDensityIsContinuousWhereARayBecomesLevel) {
  const DensityProfile profile = profile_of({{0, 0.02}, {100, 0.02}, {120, 0}});
  for (const double height : {50.0, 100.0, 110.0, 120.0, 300.0}) {
    const double level = mean_density(profile, height, height);
    for (const double rise : {1e-13, 1e-9, 1e-6}) {
      EXPECT_NEAR(mean_density(profile, height, height + rise), level, 0.001 * rise + 1e-16) << height;
      EXPECT_NEAR(mean_density(profile, height, height - rise), level, 0.001 * rise + 1e-16) << height;
    }
  }
}

TEST(DensityProfile, ProfileWithoutKnotsIsNoFog) {
  EXPECT_EQ(profile_density_at({}, 3), 0);
  EXPECT_EQ(optical_depth({}, 3, 7, 100), 0);
  EXPECT_EQ(optical_depth_to_sky({}, 3, 0), 0);
  EXPECT_EQ(largest_density({}), 0);
}

TEST(DensityProfile, OneKnotIsUniformFog) {
  const DensityProfile profile = profile_of({{50, 0.01}});
  for (const double height : {-kInfinity, 0.0, 50.0, 90.0, kInfinity}) {
    EXPECT_EQ(profile_density_at(profile, height), 0.01) << height;
  }
  EXPECT_DOUBLE_EQ(optical_depth(profile, 3, 90, 200), 2);
}

TEST(DensityProfile, RaysToTheSkyEndAtTheOutermostKnotOrNowhere) {
  const DensityProfile layer = profile_of({{100, 0}, {110, 0.02}, {200, 0.02}, {220, 0}});
  const double column = 0.02 * (5 + 90 + 10);
  EXPECT_DOUBLE_EQ(optical_depth_to_sky(layer, 0, 1), column);
  EXPECT_DOUBLE_EQ(optical_depth_to_sky(layer, 0, 0.25), 4 * column);
  EXPECT_DOUBLE_EQ(optical_depth_to_sky(layer, 500, -0.5), 2 * column);
  EXPECT_DOUBLE_EQ(optical_depth_to_sky(layer, 150, 1), 0.02 * 60);
  EXPECT_EQ(optical_depth_to_sky(layer, 220, 1), 0);
  EXPECT_EQ(optical_depth_to_sky(layer, 500, 1), 0);
  EXPECT_EQ(optical_depth_to_sky(layer, 100, -1), 0);
  EXPECT_EQ(optical_depth_to_sky(layer, 500, 0), 0);
  EXPECT_EQ(optical_depth_to_sky(layer, 150, 0), kInfinity);
  const DensityProfile ground = profile_of({{100, 0.02}, {120, 0}});
  EXPECT_EQ(optical_depth_to_sky(ground, 300, -1e-6), kInfinity);
  EXPECT_DOUBLE_EQ(optical_depth_to_sky(ground, 0, 1), 2.2);
}

TEST(DensityProfile, ExtremesBoundTheDensityBetweenTwoHeights) {
  Random random(413);
  for (int i = 0; i < 2000; ++i) {
    const DensityProfile profile = random_profile(random);
    const double a = random.uniform(-200, 5000), b = a + random.log_uniform(1e-3, 1e4);
    for (int k = 0; k < 10; ++k) {
      const double density = profile_density_at(profile, random.uniform(a, b));
      ASSERT_LE(density, largest_density(profile, a, b) * (1 + 1e-15));
      ASSERT_GE(density, smallest_density(profile, a, b) * (1 - 1e-15));
    }
    ASSERT_GE(largest_density(profile), largest_density(profile, a, b));
    ASSERT_LE(smallest_density(profile), smallest_density(profile, a, b));
  }
}

TEST(DensityProfile, NoLineToARangeOfHeightsIsThinnerThanTheLeastMean) {
  Random random(414);
  for (int i = 0; i < 2000; ++i) {
    const DensityProfile profile = random_profile(random);
    const double height = random.uniform(-200, 5000);
    const double low = random.uniform(-200, 5000), high = low + random.log_uniform(1e-3, 1e4);
    const double least = least_mean_density(profile, height, low, high);
    double sampled = kInfinity;
    constexpr int kSamples = 4000;
    for (int k = 0; k <= kSamples; ++k) {
      sampled = std::min(sampled, mean_density(profile, height, std::lerp(low, high, double(k) / kSamples)));
    }
    ASSERT_LE(least, sampled * (1 + 1e-14)) << i;
    // Between two samples the mean changes by no more than its slope, at most the largest density over the distance.
    const double apart = (high - low) / kSamples;
    const double nearest = std::max({low - height, height - high, 0.0});
    ASSERT_GE(least, sampled - largest_density(profile) * apart / std::max(nearest, apart)) << i;
    const double everywhere = least_mean_density(profile, height, -kInfinity, kInfinity);
    ASSERT_LE(everywhere, least * (1 + 1e-14)) << i;
    ASSERT_GE(everywhere, smallest_density(profile) * (1 - 1e-14)) << i;
  }
}

TEST(DensityProfile, LayerIsFullBetweenBaseAndTopAndItsTransitionBandsLieOutside) {
  const DensityProfile profile =
      profile_of_layers({FogLayer{.base = 200, .top = 300, .transition = 40, .visibility = 150}});
  const double full = Fog::from_visibility(FogMode::exp, 150).density;
  const std::array<DensityKnot, 4> expected{{{160, 0}, {200, full}, {300, full}, {340, 0}}};
  ASSERT_EQ(profile.count, 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(profile.knots[i], expected[i]) << i;
  EXPECT_DOUBLE_EQ(profile_density_at(profile, 180), full / 2);
}

TEST(DensityProfile, LayersAddUp) {
  const std::array<FogLayer, 2> layers{{{.top = 100, .transition = 20, .visibility = 400},
                                        {.base = 90, .top = 500, .transition = 30, .visibility = 1000}}};
  const DensityProfile both = make_density_profile(layers);
  const DensityProfile ground = make_density_profile(std::span(layers).first(1));
  const DensityProfile cloud = make_density_profile(std::span(layers).last(1));
  EXPECT_EQ(both.count, 6u);
  for (double height = -10; height < 600; height += 0.7) {
    EXPECT_NEAR(profile_density_at(both, height),
                profile_density_at(ground, height) + profile_density_at(cloud, height), 1e-16)
        << height;
  }
}

TEST(DensityProfile, LayerWithoutTransitionIsARampOfAHundredthOfAMetre) {
  const DensityProfile profile = profile_of_layers({FogLayer{.top = 100, .visibility = 300}});
  ASSERT_EQ(profile.count, 2u);
  EXPECT_EQ(profile.knots[0].height, 100);
  EXPECT_EQ(profile.knots[1].height, 100 + kSharpestTransition);
  EXPECT_EQ(profile.knots[1].density, 0);
}

TEST(DensityProfile, LayersOfNoFogNeedNoKnots) {
  EXPECT_EQ(profile_of_layers({FogLayer{.base = 0, .top = 10}}), DensityProfile{});
  EXPECT_EQ(profile_of_layers({FogLayer{.visibility = 100}}).count, 1u);  // fog everywhere
}

TEST(DensityProfile, ScaleMultipliesTheDensities) {
  const DensityProfile profile = profile_of({{0, 0.02}, {100, 0.01}});
  EXPECT_EQ(profile_density_at(scaled(profile, 0.5), 0), 0.01);
  EXPECT_EQ(scaled(profile, 0).knots[1].density, 0);
}

TEST(DensityProfile, KnotsThatRoundToOneHeightAreAStepInFloats) {
  const DensityProfileF profile = to_floats(profile_of({{1e6, 0.02}, {std::nextafter(1e6, 2e6), 0}, {1.5e6, 0}}));
  ASSERT_EQ(profile.knots[0].height, profile.knots[1].height);
  DensityProfileText<float> text{profile};
  for (const float height : {9.9e5f, 1e6f, 1.1e6f}) {
    EXPECT_EQ(text.litfog_profile_density(height), height < 1e6f ? 0.02f : 0) << height;
    EXPECT_EQ(text.litfog_mean_density(height, height + 1), height < 1e6f ? 0.02f : 0) << height;
  }
  EXPECT_FLOAT_EQ(text.litfog_mean_density(1e6f - 10, 1e6f + 10), 0.01f);
}

TEST(DensityProfile, DensestKnotHasFiniteDepthsInFloats) {
  const DensityProfileF profile = to_floats(profile_of({{-1e7, 1e300}, {1e7, 1e300}}));
  EXPECT_TRUE(std::isfinite(DensityProfileText<float>{profile}.litfog_mean_density(-1.6e7f, 1.6e7f)));
}

TEST(DensityProfile, DensestKnotsHaveAMeanBetweenThem) {
  const DensityProfile profile = profile_of({{-16777216, 1e300}, {0, 9e299}, {16777216, 1e300}});
  EXPECT_DOUBLE_EQ(mean_density(profile, -16777216, 16777216) / 1e300, 0.95);
}

TEST(DensityProfile, WrongKnotsAreErrorsThatNameThem) {
  EXPECT_EQ(error_of([] {
              profile_of({{0, 1}, {0, 2}});
            }),
            "profile.knots[1].height = 0: must be above the knot before");
  EXPECT_EQ(error_of([] {
              profile_of({{0, 1}, {kNan, 2}});
            }),
            "profile.knots[1].height = nan: must be at most 16777216 in magnitude");
  EXPECT_EQ(error_of([] { profile_of({DensityKnot{0, -1}}); }), "profile.knots[0].density = -1: must be in [0, 1e300]");
  EXPECT_EQ(error_of([] {
              profile_of({DensityKnot{0, kInfinity}});
            }),
            "profile.knots[0].density = inf: must be in [0, 1e300]");
  EXPECT_EQ(error_of([] { make_density_profile(std::vector<DensityKnot>(9)); }),
            "profile.count = 9: must be at most 8");
}

TEST(DensityProfile, WrongLayersAreErrorsThatNameTheMember) {
  EXPECT_EQ(error_of([] { profile_of_layers({FogLayer{.base = 10, .top = 10, .visibility = 1}}); }),
            "top = 10: must be above the base");
  EXPECT_EQ(error_of([] { profile_of_layers({FogLayer{.base = kNan, .top = 10, .visibility = 1}}); }),
            "base = nan: must be at most 16777216 in magnitude");
  EXPECT_EQ(error_of([] { profile_of_layers({FogLayer{.base = 10, .top = 2e7, .visibility = 1}}); }),
            "top = 2e+07: must be at most 16777216 in magnitude");
  EXPECT_EQ(error_of([] { profile_of_layers({FogLayer{.top = 10, .transition = -1, .visibility = 1}}); }),
            "transition = -1: must be finite and >= 0");
  for (const double visibility : {0.0, 1e-300, kNan}) {
    EXPECT_TRUE(error_of([&] {
                  profile_of_layers({FogLayer{.top = 10, .visibility = visibility}});
                }).ends_with(visibility > 0 ? ": must be >= 1e-290" : ": must be > 0"));
  }
  EXPECT_EQ(error_of([] { profile_of_layers({FogLayer{.base = -16777216, .visibility = 1}}); }),
            "base = -16777216: must be at most 16777216 in magnitude with its transition band");
  EXPECT_EQ(error_of([] { profile_of_layers({FogLayer{.top = 10, .transition = 1e308, .visibility = 1}}); }),
            "top = 10: must be at most 16777216 in magnitude with its transition band");
  const std::vector<FogLayer> three{{.base = 0, .top = 1, .transition = 1, .visibility = 1},
                                    {.base = 10, .top = 11, .transition = 1, .visibility = 1},
                                    {.base = 20, .top = 21, .transition = 1, .visibility = 1}};
  EXPECT_EQ(error_of([&] { make_density_profile(three); }), "profile.count = 12: must be at most 8");
  EXPECT_EQ(error_of([] { make_density_profile(std::vector<FogLayer>{}, 1); }), "contrast = 1: must be in (0, 1)");
}

TEST(DensityProfile, LayersWithinTheirLimitsAreKnotsWithinTheirs) {
  const FogLayer densest{.top = 16777200, .transition = 16, .visibility = kLeastLayerVisibility};
  for (const double contrast : {kContrastMor, std::numeric_limits<double>::min()}) {
    const DensityProfile profile = make_density_profile(std::vector(10'000, densest), contrast);
    EXPECT_EQ(profile.knots[1].height, 16777216);
    EXPECT_GT(largest_density(profile), 1e290);
  }
}

}  // namespace
}  // namespace litfog::test
