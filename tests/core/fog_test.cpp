// SPDX-License-Identifier: Apache-2.0
#include "litfog/fog.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "core/value_errors.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"
#include "reference/reference_solver.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

constexpr std::array kPresets{kContrastMor, kContrastKoschmieder, kContrastFlightgear};

std::string describe(FogMode mode, double first, double second) {
  char text[96];
  std::snprintf(text, sizeof text, "%s fog, %a, %a", name_of(mode), first, second);
  return text;
}

Digits50 reference_density(FogMode mode, double metres, double contrast) {
  const Digits50 depth = -log(Digits50(contrast));
  return (mode == FogMode::exp ? depth : Digits50(sqrt(depth))) / Digits50(metres);
}

/// Densities of `count` visibilities and contrasts drawn by `draw`.
template <typename Real, typename Draw>
void check_from_visibility(const char* range, const Draw& draw) {
  WorstError error(sizeof(Real) == 8 ? "from_visibility" : "from_visibility, float", range, kDensityMaxUlp);
  Random random(5);
  for (const FogMode mode : kModes) {
    for (int i = 0; i < 5000; ++i) {
      const auto [metres, contrast] = draw(random);
      error.add(ulp_error(BasicFog<Real>::from_visibility(mode, metres, contrast).density,
                          reference_density(mode, double(metres), double(contrast))),
                [&, m = metres, c = contrast] { return describe(mode, double(m), double(c)); });
    }
  }
  error.check();
}

TEST(FogMode, NameIsTheOneOfTheFormula) {
  EXPECT_STREQ(name_of(FogMode::exp), "exp");
  EXPECT_STREQ(name_of(FogMode::exp2), "exp2");
}

TEST(FogFromVisibility, DensityIsExactToThreeUlp) {
  check_from_visibility<double>("V 1e-3..1e6, presets", [](Random& random) {
    return std::pair{random.log_uniform(1e-3, 1e6), random.pick(kPresets)};
  });
  check_from_visibility<double>("all V, contrasts 1e-300..1 - 2^-53", [](Random& random) {
    const double contrast = random.chance(0.2)   ? random.pick(std::array{kDenormMin, 1 - 0x1p-53, 1 - 0x1p-52})
                            : random.chance(0.5) ? 1 - random.log_uniform(1e-15, 0.5)
                                                 : random.log_uniform(1e-300, 0.5);
    return std::pair{random.any_positive<double>(), contrast};
  });
}

TEST(FogFromVisibility, DensityInSinglePrecisionIsExactToThreeUlp) {
  check_from_visibility<float>("V 1e-3..1e6, presets", [](Random& random) {
    return std::pair{float(random.log_uniform(1e-3, 1e6)), float(random.pick(kPresets))};
  });
  check_from_visibility<float>("all V, contrasts 1e-37..1 - 2^-24", [](Random& random) {
    const float contrast = random.chance(0.2) ? 1 - 0x1p-24f : float(random.log_uniform(1e-37, 0.999));
    return std::pair{random.any_positive<float>(), contrast};
  });
}

TEST(FogFromVisibility, FogFactorAtTheVisibilityIsTheContrast) {
  for (const FogMode mode : kModes) {
    for (const double contrast : kPresets) {
      for (const double metres : {0.5, 200.0, 50000.0}) {
        EXPECT_NEAR(fog_factor_at(Fog::from_visibility(mode, metres, contrast), metres), contrast,
                    8e-16 * contrast * 5);
      }
    }
  }
}

TEST(Visibility, VisibilityIsExactToThreeUlp) {
  WorstError error("visibility", "d 1e-6..1e3, presets", kVisibilityMaxUlp);
  Random random(6);
  for (const FogMode mode : kModes) {
    for (int i = 0; i < 5000; ++i) {
      const double density = random.log_uniform(1e-6, 1e3);
      const double contrast = random.pick(kPresets);
      error.add(ulp_error(visibility({mode, density}, contrast), reference_density(mode, density, contrast)),
                [&] { return describe(mode, density, contrast); });
    }
    EXPECT_EQ(visibility({mode, 0}), kInfinity);
    EXPECT_EQ(visibility({mode, -0.0}), kInfinity);
    EXPECT_EQ(visibility({mode, kInfinity}), 0);
  }
  error.check();
}

TEST(Visibility, WrongFogOrContrastIsAnError) {
  EXPECT_EQ(error_of([] { visibility({FogMode::exp, -1}); }), "fog.density = -1: must be >= 0");
  EXPECT_EQ(error_of([] { visibility({}, 1); }), "contrast = 1: must be in (0, 1)");
}

TEST(FogFromVisibility, DefaultContrastIsThatOfTheMeteorologicalOpticalRange) {
  for (const FogMode mode : kModes) {
    EXPECT_EQ(Fog::from_visibility(mode, 300), Fog::from_visibility(mode, 300, 0.05));
    EXPECT_EQ(FogF::from_visibility(mode, 300), FogF::from_visibility(mode, 300, 0.05f));
  }
  EXPECT_EQ(kContrastMor, 0.05);
  EXPECT_EQ(kContrastKoschmieder, 0.02);
  EXPECT_EQ(kContrastFlightgear, 0.01);
}

TEST(FogFromVisibility, FogKeepsItsMode) {
  for (const FogMode mode : kModes) EXPECT_EQ(Fog::from_visibility(mode, 10).mode, mode);
}

TEST(FogFromVisibility, InfiniteVisibilityIsClearAirAndZeroIsTotalFog) {
  for (const FogMode mode : kModes) {
    EXPECT_EQ(Fog::from_visibility(mode, kInfinity).density, 0);
    EXPECT_EQ(Fog::from_visibility(mode, 0).density, kInfinity);
    EXPECT_EQ(Fog::from_visibility(mode, -0.0).density, kInfinity);
    EXPECT_EQ(FogF::from_visibility(mode, std::numeric_limits<float>::infinity()).density, 0);
    EXPECT_EQ(FogF::from_visibility(mode, 0).density, std::numeric_limits<float>::infinity());
  }
}

TEST(FogFromVisibility, VisibilityOrContrastOutOfRangeIsAnError) {
  const auto error = [](double metres, double contrast) {
    return error_of([&] { Fog::from_visibility(FogMode::exp, metres, contrast); });
  };
  EXPECT_EQ(error(-1, 0.05), "visibility = -1: must be >= 0");
  EXPECT_EQ(error(-kInfinity, 0.05), "visibility = -inf: must be >= 0");
  EXPECT_EQ(error(kNan, 0.05), "visibility = nan: must be >= 0");
  EXPECT_EQ(error(100, 0), "contrast = 0: must be in (0, 1)");
  EXPECT_EQ(error(100, 1), "contrast = 1: must be in (0, 1)");
  EXPECT_EQ(error(100, -0.5), "contrast = -0.5: must be in (0, 1)");
  EXPECT_EQ(error(100, kNan), "contrast = nan: must be in (0, 1)");
  EXPECT_EQ(error_of([] { FogF::from_visibility(FogMode::exp2, -2.5f); }), "visibility = -2.5: must be >= 0");
}

TEST(FogCheck, NegativeDensityIsAnError) {
  const auto error = [](double d) {
    return find_error(Fog{FogMode::exp, d}) ? to_string(*find_error(Fog{FogMode::exp, d})) : "";
  };
  EXPECT_EQ(error(-0.5), "fog.density = -0.5: must be >= 0");
  EXPECT_EQ(error(-kInfinity), "fog.density = -inf: must be >= 0");
  EXPECT_EQ(error(kNan), "fog.density = nan: must be >= 0");
  for (const double d : {0.0, -0.0, kDenormMin, 1.0, kMax, kInfinity}) EXPECT_EQ(error(d), "");
}

/// Opacities and fog factors of densities and ranges drawn by `draw`.
template <typename Draw>
void check_opacity(const char* range, const Draw& draw) {
  for (const FogMode mode : kModes) {
    WorstError error(mode == FogMode::exp ? "opacity, exp" : "opacity, exp2", range, kOpacityMaxUlp);
    WorstError factor_error(mode == FogMode::exp ? "fog factor, exp" : "fog factor, exp2", range, kFogFactorMaxError,
                            "absolute");
    Random random(9);
    for (int i = 0; i < 10000; ++i) {
      const auto [density, metres] = draw(random);
      const Digits50 opacity = reference_opacity(mode, density, metres);
      const auto text = [&, d = density, m = metres] { return describe(mode, d, m); };
      error.add(ulp_error(opacity_at({mode, density}, metres), opacity), text);
      const Digits50 factor_difference = fog_factor_at({mode, density}, metres) - (1 - opacity);
      factor_error.add(double(abs(factor_difference)), text);
    }
    error.check();
    factor_error.check();
  }
}

TEST(Opacity, OpacityIsExactToFourUlpAndTheFogFactorToAnEpsilon) {
  check_opacity("d 1e-6..10, r 1e-3..1e5", [](Random& random) {
    return std::pair{random.log_uniform(1e-6, 10), random.log_uniform(1e-3, 1e5)};
  });
  check_opacity("d r 1e-3..50", [](Random& random) {
    const double density = random.log_uniform(1e-3, 1e3);
    return std::pair{density, random.log_uniform(1e-3, 50) / density};
  });
  check_opacity("d, r 1e-30..1e30", [](Random& random) {
    return std::pair{random.log_uniform(1e-30, 1e30), random.log_uniform(1e-30, 1e30)};
  });
  check_opacity("all d, all r", [](Random& random) {
    return std::pair{random.any_positive<double>(), random.any_positive<double>()};
  });
}

TEST(Opacity, OpacityOfThinFogIsTheOpticalDepth) {
  EXPECT_EQ(opacity_at({FogMode::exp, 1e-20}, 1), 1e-20);
  EXPECT_EQ(opacity_at({FogMode::exp, 0x1p-60}, 1), 0x1p-60);
  EXPECT_EQ(opacity_at({FogMode::exp2, 0x1p-40}, 1), 0x1p-80);
  EXPECT_EQ(opacity_at({FogMode::exp, kDenormMin}, 1), kDenormMin);
}

TEST(Opacity, OpacityIsZeroInClearAirAndOneInTotalFogBeyondRangeZero) {
  for (const FogMode mode : kModes) {
    for (const double range : {0.0, kDenormMin, 1.0, kMax, kInfinity}) {
      EXPECT_EQ(opacity_at({mode, 0}, range), 0);
      EXPECT_EQ(fog_factor_at({mode, 0}, range), 1);
      EXPECT_EQ(opacity_at({mode, kInfinity}, range), range == 0 ? 0 : 1);
      EXPECT_EQ(fog_factor_at({mode, kInfinity}, range), range == 0 ? 1 : 0);
    }
    EXPECT_EQ(opacity_at({mode, 1e-3}, 0), 0);
    EXPECT_EQ(opacity_at({mode, kDenormMin}, kInfinity), 1);
    EXPECT_EQ(fog_factor_at({mode, kDenormMin}, kInfinity), 0);
  }
}

TEST(Opacity, OpacityAndFogFactorAddUpToOne) {
  Random random(3);
  for (int i = 0; i < 10000; ++i) {
    const Fog fog{random.pick(kModes), random.log_uniform(1e-6, 10)};
    const double range = random.log_uniform(1e-3, 1e5);
    EXPECT_NEAR(opacity_at(fog, range) + fog_factor_at(fog, range), 1, 0x1p-51)
        << describe(fog.mode, fog.density, range);
  }
}

TEST(Opacity, OpacityNeverFallsNorLeavesItsRangeOnSpecialValues) {
  const std::array values{0.0, kDenormMin, 1e-308, 1e-160, 1e-30, 1e-5, 1.0, 1e5, 1e30, 1e160, kMax, kInfinity};
  for (const FogMode mode : kModes) {
    for (const double density : values) {
      double last = 0;
      for (const double range : values) {
        const double value = opacity_at({mode, density}, range);
        EXPECT_TRUE(value >= last && value <= 1) << describe(mode, density, range) << ": " << value;
        last = value;
        const double factor = fog_factor_at({mode, density}, range);
        EXPECT_TRUE(factor >= 0 && factor <= 1) << describe(mode, density, range) << ": " << factor;
      }
    }
  }
}

TEST(ScaledFog, ScaledFogHasItsDensityTimesTheScaleAndItsMode) {
  for (const FogMode mode : kModes) {
    EXPECT_EQ(scaled({mode, 0.25}, 0.5), (Fog{mode, 0.125}));
    EXPECT_EQ(scaled({mode, 0.25}, 1), (Fog{mode, 0.25}));
    EXPECT_EQ(scaled({mode, 0.25}, 0), (Fog{mode, 0}));
  }
}

TEST(ScaledFog, ClearAirStaysClearAndTotalFogTotalUnlessTheScaleIsZero) {
  EXPECT_EQ(scaled({FogMode::exp, 0}, kMax).density, 0);
  EXPECT_EQ(scaled({FogMode::exp, kInfinity}, kDenormMin).density, kInfinity);
  EXPECT_EQ(scaled({FogMode::exp, kInfinity}, 0).density, 0);
}

TEST(ScaledFog, NegativeOrInfiniteScaleOrWrongFogIsAnError) {
  EXPECT_EQ(error_of([] { scaled(Fog{}, -1); }), "density_scale = -1: must be finite and >= 0");
  EXPECT_EQ(error_of([] { scaled(Fog{}, kInfinity); }), "density_scale = inf: must be finite and >= 0");
  EXPECT_EQ(error_of([] { scaled(Fog{}, kNan); }), "density_scale = nan: must be finite and >= 0");
  EXPECT_EQ(error_of([] { scaled({FogMode::exp, -3}, 1); }), "fog.density = -3: must be >= 0");
}

}  // namespace
}  // namespace litfog::test
