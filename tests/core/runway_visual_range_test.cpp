// SPDX-License-Identifier: Apache-2.0
#include "litfog/runway_visual_range.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/lambert_w.hpp>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/value_errors.h"
#include "reference/double_limits.h"
#include "reference/near_numbers.h"
#include "reference/random_light.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

std::string describe(FogMode mode, double value, const RunwayLights& lights) {
  char text[128];
  std::snprintf(text, sizeof text, "%s fog, %a, %a cd, %a lx", name_of(mode), value, lights.candela,
                lights.illuminance_threshold);
  return text;
}

Digits50 reference_density(FogMode mode, double metres, const RunwayLights& lights) {
  const Digits50 range = metres;
  const Digits50 lamps = Digits50(lights.candela) / Digits50(lights.illuminance_threshold) / range / range;
  const Digits50 depth = log(std::max(lamps, Digits50(1 / Digits50(kContrastMor))));
  return (mode == FogMode::exp ? depth : Digits50(sqrt(depth))) / range;
}

/// The larger of Koschmieder's range and Allard's, which Lambert's W states.
double reference_range(const Fog& fog, const RunwayLights& lights) {
  const Digits50 d = fog.density;
  const Digits50 brightness = Digits50(lights.candela) / Digits50(lights.illuminance_threshold);
  const Digits50 markings = -log(Digits50(kContrastMor));
  if (fog.mode == FogMode::exp) {
    return double(std::max<Digits50>(2 * boost::math::lambert_w0(Digits50(d * sqrt(brightness) / 2)), markings) / d);
  }
  return double(sqrt(std::max<Digits50>(boost::math::lambert_w0(Digits50(d * d * brightness)), markings)) / d);
}

/// Runway visual ranges and lights drawn by `draw`, there and back.
template <typename Draw>
void check_both_ways(const char* name, const Draw& draw) {
  WorstError density_error("runway density", name, kRunwayDensityMaxError, "relative");
  WorstError round_trip_error("runway range there and back", name, kRunwayRoundTripMaxError, "relative");
  Random random(7);
  for (const FogMode mode : kModes) {
    for (int i = 0; i < 10000; ++i) {
      const auto [metres, lights] = draw(random);
      const Fog fog = fog_from_runway_visual_range(mode, metres, lights);
      EXPECT_EQ(fog.mode, mode);
      const auto text = [&, m = metres, &l = lights] { return describe(mode, m, l); };
      density_error.add(relative_error(fog.density, reference_density(mode, metres, lights)), text);
      round_trip_error.add(relative_error(runway_visual_range(fog, lights), metres), text);
    }
  }
  density_error.check();
  round_trip_error.check();
}

TEST(RunwayVisualRange, DensityIsExactAndComesBackAsItsRange) {
  check_both_ways("R 1..3000 m, 100..1e5 cd, 8e-7..1e-3 lx", [](Random& random) {
    const RunwayLights lights{random.log_uniform(100, 1e5), random.log_uniform(8e-7, 1e-3)};
    const double reach = std::sqrt(lights.candela / lights.illuminance_threshold);
    return std::pair{random.log_uniform(1, std::min(reach * (1 - 1e-12), 3000.0)), lights};
  });
  check_both_ways("no lamps, R 1e-3..1e6 m", [](Random& random) {
    return std::pair{random.log_uniform(1e-3, 1e6), RunwayLights{.candela = 0}};
  });
  check_both_ways("extreme values", [](Random& random) {
    const RunwayLights lights{random.log_uniform(1e-200, 1e200), random.log_uniform(1e-200, 1e200)};
    const double reach = std::sqrt(lights.candela) / std::sqrt(lights.illuminance_threshold);
    return std::pair{reach * random.log_uniform(1e-100, 1 - 1e-12), lights};
  });
}

RC_GTEST_PROP(RunwayVisualRange, BoundsHoldWhereLampsAreLastSeenAndWhereMarkingsAreAsFar, ()) {
  const RunwayLights lights{*near_one_of({100, 1000, 2500, 10'000}), *near_one_of({8e-7, 1e-5, 1e-4, 1e-3})};
  const double reach = std::sqrt(lights.candela / lights.illuminance_threshold);
  const double metres = *near_one_of({reach, reach * std::sqrt(kContrastMor), 550});
  RC_PRE(metres < reach * (1 + 1e-7));
  const FogMode mode = *rc::gen::element(FogMode::exp, FogMode::exp2);
  const Fog fog = fog_from_runway_visual_range(mode, metres, lights);
  RC_ASSERT(relative_error(fog.density, reference_density(mode, metres, lights)) <= kRunwayDensityMaxError);
  RC_ASSERT(relative_error(runway_visual_range(fog, lights), metres) <= kRunwayRoundTripMaxError);
}

TEST(RunwayVisualRange, RangeIsThatOfLambertsW) {
  WorstError error("runway range", "d 1e-4..1, 100..1e5 cd, 8e-7..1e-3 lx", kRunwayRoundTripMaxError, "relative");
  Random random(8);
  for (const FogMode mode : kModes) {
    for (int i = 0; i < 3000; ++i) {
      const RunwayLights lights{random.log_uniform(100, 1e5), random.log_uniform(8e-7, 1e-3)};
      const Fog fog{mode, random.log_uniform(1e-4, 1)};
      error.add(relative_error(runway_visual_range(fog, lights), reference_range(fog, lights)),
                [&] { return describe(mode, fog.density, lights); });
    }
  }
  error.check();
}

TEST(RunwayVisualRange, LampsAndMarkingsAreNoFartherThanTheRangeAndOneOfThemIsAsFar) {
  Random random(9);
  for (const FogMode mode : kModes) {
    for (int i = 0; i < 1000; ++i) {
      const RunwayLights lights{random.log_uniform(100, 1e5), random.log_uniform(8e-7, 1e-3)};
      const double reach = std::sqrt(lights.candela / lights.illuminance_threshold);
      const double metres = random.log_uniform(1, reach);
      const double transmitted = fog_factor_at(fog_from_runway_visual_range(mode, metres, lights), metres);
      const double lamp = lights.candela * transmitted / (metres * metres) / lights.illuminance_threshold;
      EXPECT_NEAR(std::max(lamp, transmitted / kContrastMor), 1, 1e-11) << describe(mode, metres, lights);
    }
  }
}

TEST(RunwayVisualRange, RangeOf550MetresAtNightIsAVisibilityOf155) {
  const auto mor = [](double metres, double lux) {
    return visibility(fog_from_runway_visual_range(FogMode::exp, metres, {10'000, lux}));
  };
  EXPECT_NEAR(mor(550, 8e-7), 155, 0.5);
  EXPECT_NEAR(mor(550, 1e-4), 284, 0.5);
  EXPECT_EQ(RunwayLights{}, (RunwayLights{10'000, 8e-7}));
  // In sunlight the lamps are lost against the fog before the markings are.
  EXPECT_NEAR(mor(2000, 1e-3), 2000, 1e-9);
}

/// How litfog's RVR in exp fog of a visibility stands to a published one: their quotient.
double over_published(double visibility_m, double published_m, const RunwayLights& lights) {
  return runway_visual_range(Fog::from_visibility(FogMode::exp, visibility_m), lights) / published_m;
}

TEST(RunwayVisualRange, StandsToARegulatorsConversionFactorsAsThePagesSay) {
  // UK Regulation (EU) 965/2012, AMC10 CAT.OP.MPA.110, table 8: RVR = factor * reported visibility, for 800 m and more.
  // It states no candela: those of lights of less than high intensity are litfog's guess.
  constexpr RunwayLights kHighByDay{10'000, 1e-4}, kHighAtNight{10'000, 8e-7}, kOtherByDay{1000, 1e-4},
      kOtherAtNight{1000, 8e-7}, kNone{0, 1e-4};
  struct Row {
    const char* name;
    double factor;
    RunwayLights lights;
    double least, most;  // of litfog's RVR over the regulator's, for RVR of 800 m up to a visibility of 1500 m
  };
  for (const auto& [name, factor, lights, least, most] : {Row{"high intensity by day", 1.5, kHighByDay, 0.77, 1.09},
                                                          {"high intensity at night", 2, kHighAtNight, 1.15, 1.52},
                                                          {"other lights by day", 1, kOtherByDay, 1, 1},
                                                          {"other lights at night", 1.5, kOtherAtNight, 1.15, 1.52},
                                                          {"no lights by day", 1, kNone, 1, 1}}) {
    constexpr double kLeastRange = 800, kMostVisibility = 1500, kSame = 1e-14;
    double smallest = kInfinity, largest = 0;
    for (double metres = kLeastRange / factor; metres <= kMostVisibility; ++metres) {
      const double quotient = over_published(metres, factor * metres, lights);
      smallest = std::min(smallest, quotient);
      largest = std::max(largest, quotient);
    }
    std::printf("%s: litfog's RVR is %.2f to %.2f of the regulator's\n", name, smallest, largest);
    EXPECT_GE(smallest, least * (1 - kSame)) << name;
    EXPECT_LE(largest, most * (1 + kSame)) << name;
    EXPECT_LE(smallest, least * 1.02) << name;  // the pages' figures are no wider than they must be
    EXPECT_GE(largest, most * 0.98) << name;
  }
}

TEST(RunwayVisualRange, RangesOfABrightDayAreTheFaasComparableValues) {
  constexpr double kFoot = 0.3048, kMile = 1609.344;  // metres
  // Feet of RVR and statute miles of visibility: 14 CFR 91.175(h), FAA Aeronautical Information Manual, 5-4-20.
  constexpr std::pair<double, double> kRows[] = {{1600, 0.25},  {2400, 0.5}, {3200, 0.625}, {4000, 0.75},
                                                 {4500, 0.875}, {5000, 1},   {6000, 1.25}};
  for (const auto& [feet, miles] : kRows) {
    const double quotient = over_published(miles * kMile, feet * kFoot, {10'000, 1e-3});
    EXPECT_TRUE(quotient > 0.98 && quotient < 1.11) << feet << ": " << quotient;
  }
}

TEST(RunwayVisualRange, NominalRangeOfASeaLightIsThatOfItsDefinition) {
  // By night in fog that leaves 0.74 a nautical mile, a visibility of ten, seen from 0.2 microlux, that is 0.686 cd at
  // a nautical mile (IES, "nominal range of a light signal"). 0.74 is rounded: it is 0.7 % off at most.
  constexpr double kNauticalMile = 1852, kLeft = 0.74, kLeftError = 0.007;
  const Fog fog = Fog::from_visibility(FogMode::exp, 10 * kNauticalMile);
  for (const double miles : {1, 2, 5, 10, 20}) {
    const auto range = [&](double left) {
      return runway_visual_range(fog, {0.686 * miles * miles / std::pow(left, miles), 0.2e-6}) / kNauticalMile;
    };
    if (miles < 10) {  // where markings are seen farther
      EXPECT_EQ(range(kLeft), 10) << miles;
      continue;
    }
    EXPECT_LE(range(kLeft * (1 + kLeftError)), miles);
    EXPECT_GE(range(kLeft * (1 - kLeftError)), miles);
  }
}

TEST(RunwayVisualRange, ThickerFogAndDimmerLampsShortenIt) {
  for (const FogMode mode : kModes) {
    double last = kInfinity;
    for (double density = 1e-5; density < 1e3; density *= 1.01) {
      const double metres = runway_visual_range({mode, density});
      EXPECT_LT(metres, last) << density;
      EXPECT_LE(runway_visual_range({mode, density}, {.candela = 5000}), metres) << density;
      EXPECT_GE(metres, visibility({mode, density}) * (1 - 1e-15)) << density;
      last = metres;
    }
  }
}

TEST(RunwayVisualRange, ZeroIsTotalFogAndInfinityClearAir) {
  for (const FogMode mode : kModes) {
    for (const double candela : {0.0, 10'000.0}) {
      const RunwayLights lights{.candela = candela};
      EXPECT_EQ(fog_from_runway_visual_range(mode, 0, lights).density, kInfinity);
      EXPECT_EQ(fog_from_runway_visual_range(mode, -0.0, lights).density, kInfinity);
      EXPECT_EQ(fog_from_runway_visual_range(mode, kInfinity, lights).density, 0);
      EXPECT_EQ(runway_visual_range({mode, kInfinity}, lights), 0);
      EXPECT_EQ(runway_visual_range({mode, 0}, lights), kInfinity);
      EXPECT_EQ(runway_visual_range({mode, -0.0}, lights), kInfinity);
    }
    EXPECT_EQ(runway_visual_range({mode, 0.01}, {.candela = 0}), visibility({mode, 0.01}));
  }
}

TEST(RunwayVisualRange, RangeThatNoLampReachesIsAnError) {
  const RunwayLights dim{.candela = 100, .illuminance_threshold = 1e-4};  // seen for 1 km in clear air
  EXPECT_GT(fog_from_runway_visual_range(FogMode::exp, 1000, dim).density, 0);
  EXPECT_EQ(error_of([&] { fog_from_runway_visual_range(FogMode::exp, 1001, dim); }),
            "runway_visual_range = 1001: must be at most sqrt(candela / illuminance_threshold), where the lamps are "
            "last seen in clear air");
}

TEST(RunwayVisualRange, WrongRangeLampThresholdOrFogIsAnError) {
  const auto error = [](double metres, const RunwayLights& lights) {
    return error_of([&] { fog_from_runway_visual_range(FogMode::exp, metres, lights); });
  };
  EXPECT_EQ(error(-1, {}), "runway_visual_range = -1: must be >= 0");
  EXPECT_EQ(error(kNan, {}), "runway_visual_range = nan: must be >= 0");
  for (const double candela : {-1.0, kInfinity, kNan}) {
    const RunwayLights lights{.candela = candela};
    EXPECT_NE(error(550, lights).find("candela = "), std::string::npos);
    EXPECT_NE(error(550, lights).find(": must be finite and >= 0"), std::string::npos);
    EXPECT_EQ(error_of([&] { runway_visual_range({}, lights); }), error(550, lights));
  }
  for (const double threshold : {-1.0, 0.0, kInfinity, kNan}) {
    const RunwayLights lights{.illuminance_threshold = threshold};
    EXPECT_NE(error(550, lights).find("illuminance_threshold = "), std::string::npos);
    EXPECT_NE(error(550, lights).find(": must be finite and > 0"), std::string::npos);
    EXPECT_EQ(error_of([&] { runway_visual_range({}, lights); }), error(550, lights));
  }
  EXPECT_EQ(error_of([] { runway_visual_range({FogMode::exp, -1}); }), "fog.density = -1: must be >= 0");
}

}  // namespace
}  // namespace litfog::test
