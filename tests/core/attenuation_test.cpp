// SPDX-License-Identifier: Apache-2.0
#include "litfog/attenuation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/value_errors.h"
#include "reference/double_limits.h"
#include "reference/near_numbers.h"
#include "reference/random_light.h"
#include "reference/reference_solver.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

std::string describe(const Attenuation& a, double threshold) { return to_string(SolveCase{a, Fog{}, threshold}); }

/// Extents and knees of lights drawn by `draw`, against 50 digits.
template <typename Draw>
void check_extent_and_knee(const char* range, int count, const Draw& draw) {
  WorstError extent_error("extent", range, kExtentMaxUlp<double>);
  WorstError knee_error("knee", range, kKneeMaxUlp);
  Random random(20040101);
  for (int i = 0; i < count; ++i) {
    const auto [a, threshold] = draw(random);
    const auto text = [&, a = a, t = threshold] { return describe(a, t); };
    extent_error.add(ulp_error(compute_extent(a, threshold), reference_extent(a, threshold)), text);
    knee_error.add(ulp_error(compute_knee(a), reference_knee(a)), text);
  }
  extent_error.check();
  knee_error.check();
}

struct Drawn {
  Attenuation attenuation;
  double threshold;
};

TEST(Extent, ExtentIsExactToTwoUlpOverOrdinaryLights) {
  check_extent_and_knee("C 1e-3..10, L 1e-6..10, Q 1e-9..10", 20000, [](Random& random) {
    const double linear = random.chance(0.1) ? 0 : random.log_uniform(1e-6, 10);
    const double quadratic = linear > 0 && random.chance(0.1) ? 0 : random.log_uniform(1e-9, 10);
    return Drawn{{random.chance(0.1) ? 0 : random.log_uniform(1e-3, 10), linear, quadratic},
                 random.log_uniform(1e-3, 0.5)};
  });
}

TEST(Extent, ExtentIsExactToTwoUlpOverSixtyDecades) {
  check_extent_and_knee("C, L, Q 1e-30..1e30, t 1e-30..1", 20000, [](Random& random) {
    const auto draw = [&] { return random.log_uniform(1e-30, 1e30); };
    return Drawn{{draw(), draw(), draw()}, random.log_uniform(1e-30, 0.99)};
  });
}

TEST(Extent, ExtentIsExactToTwoUlpOverAllDoubles) {
  check_extent_and_knee("C, L, Q all doubles, t all below 1", 20000, [](Random& random) {
    const auto draw = [&] { return random.any_positive<double>(); };
    const double linear = random.chance(0.1) ? 0 : draw();
    const double quadratic = linear > 0 && random.chance(0.1) ? 0 : draw();
    double threshold = draw();
    while (!(threshold < 1)) threshold = draw();
    return Drawn{{random.chance(0.3) ? 0 : draw(), linear, quadratic}, threshold};
  });
}

TEST(Extent, ExtentIsExactToTwoUlpWhereTheLightIsBarelyAboveItsThreshold) {
  check_extent_and_knee("C a few ulp..1e-6 below 1/t (and below 1)", 20000, [](Random& random) {
    const double threshold =
        random.chance(0.3) ? random.pick(std::array{0.05, 1 / 255., 0.5, 0.1}) : random.log_uniform(1e-6, 0.999);
    const double limit = random.chance(0.3) ? 1 : 1 / threshold;
    const double constant =
        random.chance(0.5) ? limit * (1 - random.log_uniform(1e-16, 1e-6)) : std::nextafter(limit, 0.0);
    const double linear = random.chance(0.2) ? 0 : random.log_uniform(1e-12, 1e3);
    return Drawn{{constant, linear, linear > 0 && random.chance(0.2) ? 0 : random.log_uniform(1e-12, 1e3)}, threshold};
  });
}

TEST(Extent, ExtentIsExactToTwoUlpNextToTheEndsOfTheThreshold) {
  check_extent_and_knee("t next to 0 and to 1", 20000, [](Random& random) {
    const double threshold = random.pick(std::array{kDenormMin, std::numeric_limits<double>::min(), 1e-300, 1e-100,
                                                    1 - 0x1p-53, 1 - 0x1p-52, 1 - 1e-9, 0.5, std::nextafter(0.5, 0.0)});
    return Drawn{
        {random.chance(0.3) ? random.pick(std::array{0.0, 1.0, 1 - 0x1p-53, 1 + 0x1p-52}) : random.log_uniform(1e-3, 2),
         random.log_uniform(1e-9, 1e3), random.log_uniform(1e-9, 1e3)},
        threshold};
  });
}

TEST(Extent, ExtentIsFiniteAndRightWhereSinglePrecisionLosesTheTextbookRoot) {
  for (const float quadratic : {1e-8f, 1e-9f}) {
    const float textbook = (-1 + std::sqrt(1 - 4 * quadratic * (1 - 1 / 0.05f))) / (2 * quadratic);
    const Digits50 reference = reference_extent({1, 1, quadratic}, double(0.05f));
    EXPECT_GT(relative_error(textbook, reference), 0.05) << "no longer the case that it was written for";
    EXPECT_LE(ulp_error(compute_extent(AttenuationF{1, 1, quadratic}, 0.05f), reference), kExtentMaxUlp<float>)
        << quadratic;
  }
}

TEST(Extent, ExtentInSinglePrecisionIsExactToOneUlp) {
  WorstError error("extent, float", "C, L, Q all floats, t all below 1", kExtentMaxUlp<float>);
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const auto draw = [&] { return random.any_positive<float>(); };
    const AttenuationF a{random.chance(0.5) ? float(random.log_uniform(1e-3, 10)) : draw(), draw(), draw()};
    float threshold = draw();
    while (!(threshold < 1)) threshold = draw();
    const Attenuation wide{a.constant, a.linear, a.quadratic};
    error.add(ulp_error(compute_extent(a, threshold), reference_extent(wide, double(threshold))),
              [&] { return describe(wide, threshold); });
  }
  error.check();
}

TEST(Extent, ExtentIsZeroWhereTheLightStartsAtOrBelowItsThreshold) {
  EXPECT_EQ(compute_extent(Attenuation{20, 1, 1}, 0.05), 0);  // 0.05 is above 1/20 by a quarter ulp
  EXPECT_EQ(compute_extent(Attenuation{4, 1, 1}, 0.25), 0);
  EXPECT_EQ(compute_extent(Attenuation{4, 0, 0}, 0.25), 0);
  EXPECT_EQ(compute_extent(Attenuation{5, 1, 1}, 0.25), 0);
  EXPECT_EQ(compute_extent(Attenuation{kMax, 0, kDenormMin}, 0.5), 0);
  EXPECT_EQ(compute_extent(AttenuationF{4, 1, 1}, 0.25f), 0);
}

TEST(Extent, ConstantAttenuationAboveTheThresholdHasInfiniteExtent) {
  EXPECT_EQ(compute_extent(Attenuation{1, 0, 0}, 0.05), kInfinity);
  EXPECT_EQ(compute_extent(Attenuation{std::nextafter(4.0, 0.0), 0, 0}, 0.25), kInfinity);
  EXPECT_EQ(compute_extent(Attenuation{kDenormMin, 0, 0}, kDenormMin), kInfinity);
  EXPECT_EQ(compute_extent(AttenuationF{1, 0, 0}, 0.05f), std::numeric_limits<float>::infinity());
}

TEST(Extent, ExtentHasTheClosedFormsOfOneTerm) {
  EXPECT_DOUBLE_EQ(compute_extent(Attenuation{0, 0.5, 0}, 0.25), 8);
  EXPECT_DOUBLE_EQ(compute_extent(Attenuation{1, 0.5, 0}, 0.25), 6);
  EXPECT_DOUBLE_EQ(compute_extent(Attenuation{0, 0, 0.25}, 0.0625), 8);
  EXPECT_DOUBLE_EQ(compute_extent(Attenuation{3, 0, 0.25}, 0.25), 2);
}

TEST(Extent, AttenuationAtTheExtentIsTheThreshold) {
  Random random(11);
  for (int i = 0; i < 10000; ++i) {
    const Attenuation a{random.log_uniform(1e-3, 3), random.log_uniform(1e-6, 10), random.log_uniform(1e-9, 10)};
    const double threshold = random.log_uniform(1e-3, 0.3);
    EXPECT_LE(relative_error(attenuation_at(a, compute_extent(a, threshold)), threshold), 8e-16)
        << describe(a, threshold);
  }
}

TEST(Knee, KneeIsZeroFromConstantOneOn) {
  EXPECT_EQ(compute_knee({1, 1, 1}), 0);
  EXPECT_EQ(compute_knee({1, 0, 0}), 0);
  EXPECT_EQ(compute_knee({kMax, 1, 1}), 0);
}

TEST(Knee, KneeOfConstantAttenuationBelowOneIsInfinite) {
  EXPECT_EQ(compute_knee({0.5, 0, 0}), kInfinity);
  EXPECT_EQ(compute_knee({std::nextafter(1.0, 0.0), 0, 0}), kInfinity);
}

TEST(Knee, KneeIsWhereTheClampEnds) {
  const Attenuation a{0.5, 0.25, 0};
  EXPECT_EQ(compute_knee(a), 2);
  EXPECT_EQ(attenuation_at(a, 2), 1);
  EXPECT_EQ(attenuation_at(a, 1), 1);
  EXPECT_LT(attenuation_at(a, std::nextafter(2.0, 3.0) + 1e-15), 1);
}

TEST(AttenuationAt, AttenuationIsTheClampedQuotient) {
  EXPECT_EQ(attenuation_at({1, 0, 0}, 5), 1);
  EXPECT_EQ(attenuation_at({2, 0, 0}, 5), 0.5);
  EXPECT_EQ(attenuation_at({1, 2, 3}, 0), 1);
  EXPECT_EQ(attenuation_at({1, 2, 3}, 1), 1 / 6.);
  EXPECT_EQ(attenuation_at({0.25, 0, 0}, 1), 1);
  EXPECT_EQ(attenuation_at({0, 0, 0.25}, 0), 1) << "1/0, clamped";
}

TEST(AttenuationAt, AttenuationIsExactToItsRoundings) {
  WorstError ordinary("attenuation_at", "C 0..10, L 1e-6..10, Q 1e-9..10, r 1e-3..1e5", kAttenuationMaxUlp);
  WorstError wide("attenuation_at", "C, L, Q, r 0 or 1e-100..1e100", kAttenuationMaxUlp);
  Random random(2008);
  const auto add = [](WorstError& error, const Attenuation& a, double range) {
    error.add(ulp_error(attenuation_at(a, range), reference_attenuation(a, range)),
              [&] { return describe(a, 0.05) + ", range " + std::to_string(range); });
  };
  for (int i = 0; i < 20000; ++i) {
    const double constant = random.chance(0.1) ? 0 : random.log_uniform(1e-3, 10);
    add(ordinary, {constant, random.log_uniform(1e-6, 10), random.log_uniform(1e-9, 10)},
        random.log_uniform(1e-3, 1e5));
    const auto draw = [&] { return random.chance(0.1) ? 0 : random.log_uniform(1e-100, 1e100); };
    const Attenuation a{draw(), draw(), draw()};
    if (!find_error(a)) add(wide, a, draw());
  }
  ordinary.check();
  wide.check();
}

RC_GTEST_PROP(AttenuationAt, BoundsHoldAtTheKneeTheExtentAndTheirLimits, ()) {
  const double constant = *near_one_of({0, 0.5, 1, 2, 19.9});
  const double linear = *near_one_of({0, 1e-6, 0.1, 1, 1e6});
  const Attenuation a{constant, linear, *near_one_of({0, 1e-9, 0.01, 1, 1e9})};
  const double threshold = *near_one_of({0.5, 1, 0.05, 1 / 19.9, 1 / (constant + linear), 1e-3, 0});
  RC_PRE(!find_error(a) && !find_threshold_error(threshold));
  const double knee = compute_knee(a), extent = compute_extent(a, threshold);
  const bool is_constant = linear == 0 && a.quadratic == 0;
  if (constant >= 1) {
    RC_ASSERT(knee == 0);
  } else if (is_constant) {
    RC_ASSERT(knee == kInfinity);
  } else {
    RC_ASSERT(ulp_error(knee, reference_knee(a)) <= kKneeMaxUlp);
  }
  if (Digits50(constant) * threshold >= 1) {
    RC_ASSERT(extent == 0);
  } else if (is_constant) {
    RC_ASSERT(extent == kInfinity);
  } else {
    RC_ASSERT(ulp_error(extent, reference_extent(a, threshold)) <= kExtentMaxUlp<double>);
  }
  const double range = std::max(*near_one_of({knee, extent, 1, constant}), 0.0);
  RC_PRE(range == 0 || (range > 1e-100 && range < 1e100));
  const double value = attenuation_at(a, range);
  RC_ASSERT(value >= 0 && value <= 1);
  RC_ASSERT(ulp_error(value, reference_attenuation(a, range)) <= kAttenuationMaxUlp);
}

TEST(AttenuationAt, AttenuationHasItsLimitAtInfinity) {
  EXPECT_EQ(attenuation_at({1, 0, 0}, kInfinity), 1);
  EXPECT_EQ(attenuation_at({4, 0, 0}, kInfinity), 0.25);
  EXPECT_EQ(attenuation_at({0.5, 0, 0}, kInfinity), 1);
  EXPECT_EQ(attenuation_at({1, kDenormMin, 0}, kInfinity), 0);
  EXPECT_EQ(attenuation_at({1, 0, kDenormMin}, kInfinity), 0);
}

TEST(AttenuationAt, AttenuationIsNeverNanAndNeverLeavesItsRange) {
  const double values[] = {0, kDenormMin, 1e-300, 1e-5, 0.5, 1, 1e5, 1e300, kMax};
  for (const double constant : values) {
    for (const double linear : values) {
      for (const double quadratic : values) {
        const Attenuation a{constant, linear, quadratic};
        if (find_error(a)) continue;
        double last = 1;
        for (const double range : {0.0, kDenormMin, 1e-300, 1e-5, 1.0, 1e5, 1e300, kMax, kInfinity}) {
          const double value = attenuation_at(a, range);
          EXPECT_TRUE(value >= 0 && value <= last) << describe(a, 0.05) << ", range " << range << ": " << value;
          last = value;
        }
      }
    }
  }
}

TEST(AttenuationCheck, ErrorNamesFieldValueAndRule) {
  const auto error = [](const Attenuation& a) { return find_error(a) ? to_string(*find_error(a)) : "accepted"; };
  EXPECT_EQ(error({-1, 0, 0}), "attenuation.constant = -1: must be finite and >= 0");
  EXPECT_EQ(error({kInfinity, 0, 0}), "attenuation.constant = inf: must be finite and >= 0");
  EXPECT_EQ(error({kNan, 0, 0}), "attenuation.constant = nan: must be finite and >= 0");
  EXPECT_EQ(error({1, -0.125, 0}), "attenuation.linear = -0.125: must be finite and >= 0");
  EXPECT_EQ(error({1, kInfinity, 0}), "attenuation.linear = inf: must be finite and >= 0");
  EXPECT_EQ(error({1, kNan, 0}), "attenuation.linear = nan: must be finite and >= 0");
  EXPECT_EQ(error({1, 1, -5e-324}), "attenuation.quadratic = -5e-324: must be finite and >= 0");
  EXPECT_EQ(error({1, 1, kInfinity}), "attenuation.quadratic = inf: must be finite and >= 0");
  EXPECT_EQ(error({1, 1, kNan}), "attenuation.quadratic = nan: must be finite and >= 0");
  EXPECT_EQ(error({0, 0, 0}), "attenuation.constant = 0: must be > 0 where linear and quadratic are 0");
  EXPECT_EQ(error({0, 0, kDenormMin}), "accepted");
  EXPECT_EQ(error({kMax, kMax, kMax}), "accepted");
}

TEST(AttenuationCheck, ThresholdOutsideTheOpenUnitIntervalIsAnError) {
  const auto error = [](double t) {
    return find_threshold_error(t) ? to_string(*find_threshold_error(t)) : "accepted";
  };
  EXPECT_EQ(error(0), "threshold = 0: must be in (0, 1)");
  EXPECT_EQ(error(1), "threshold = 1: must be in (0, 1)");
  EXPECT_EQ(error(-0.05), "threshold = -0.05: must be in (0, 1)");
  EXPECT_EQ(error(kInfinity), "threshold = inf: must be in (0, 1)");
  EXPECT_EQ(error(kNan), "threshold = nan: must be in (0, 1)");
  EXPECT_EQ(error(kDenormMin), "accepted");
  EXPECT_EQ(error(1 - 0x1p-53), "accepted");
  EXPECT_EQ(error(kDefaultThreshold), "accepted");
}

TEST(AttenuationCheck, ExtentAndKneeThrowTheError) {
  EXPECT_EQ(error_of([] {
              compute_extent(Attenuation{1, -1, 0}, 0.05);
            }),
            "attenuation.linear = -1: must be finite and >= 0");
  EXPECT_EQ(error_of([] { compute_extent(Attenuation{1, 1, 0}, 1); }), "threshold = 1: must be in (0, 1)");
  EXPECT_EQ(error_of([] { compute_extent(AttenuationF{1, 1, 0}, -0.5f); }), "threshold = -0.5: must be in (0, 1)");
  EXPECT_EQ(error_of([] {
              compute_knee({0, 0, 0});
            }),
            "attenuation.constant = 0: must be > 0 where linear and quadratic are 0");
}

}  // namespace
}  // namespace litfog::test
