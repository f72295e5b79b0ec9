// SPDX-License-Identifier: Apache-2.0
#include "litfog/phase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <string>

#include "model/phase_text.h"
#include "reference/digits50.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

using boost::math::quadrature::gauss_kronrod;

Digits50 exact_phase(double g, double cosine) {
  const Digits50 exact_g = g;
  const Digits50 base = 1 + exact_g * exact_g - 2 * exact_g * Digits50(cosine);
  return (1 - exact_g * exact_g) / (base * sqrt(base));
}

TEST(Phase, LightIsSpreadOverAllAnglesWithTheAsymmetryAsItsMeanCosine) {
  for (const double g : {-0.9, -0.3, 0.0, 0.5, 0.95}) {
    const Phase phase{g};
    const auto mean = [&](auto function) {
      return gauss_kronrod<double, 61>::integrate(
                 [&](double cosine) { return function(cosine) * phase_at(phase, cosine); }, -1, 1, 15, 1e-13) /
             2;
    };
    EXPECT_NEAR(mean([](double) { return 1; }), 1, 1e-12) << g;
    EXPECT_NEAR(mean([](double cosine) { return cosine; }), g, 1e-12) << g;
    EXPECT_EQ(is_isotropic(phase), g == 0) << g;
  }
}

TEST(Phase, LargestValueBetweenTwoCosinesHasItsStatedError) {
  Random random(91);
  WorstError error("largest_phase", "|g| < 1", kLargestPhaseMaxError, "relative");
  for (int i = 0; i < 20'000; ++i) {
    const double size = random.chance(0.5) ? random.uniform(0, 1) : 1 - random.log_uniform(1e-12, 1);
    const Phase phase{random.chance(0.5) ? -size : size};
    const auto draw = [&] {
      const double off = random.chance(0.3) ? 0 : random.log_uniform(1e-15, 2);
      return random.chance(0.5) ? 1 - off : off - 1;
    };
    const double a = draw(), b = draw();
    const double lowest = std::min(a, b), highest = std::max(a, b);
    const Digits50 expected = std::max(exact_phase(phase.asymmetry, lowest), exact_phase(phase.asymmetry, highest));
    error.add(relative_error(largest_phase(phase, lowest, highest), expected),
              [&] { return std::to_string(phase.asymmetry); });
    ASSERT_LE(exact_phase(phase.asymmetry, lowest + random.uniform(0, 1) * (highest - lowest)), expected);
  }
  error.check();
  EXPECT_EQ(largest_phase({}), 1);
  for (const double g : {0.5, -0.5}) EXPECT_EQ(largest_phase({g}), 6) << g;
}

TEST(Phase, DepthsMakeUpForTheLargestValueOnEitherSide) {
  for (int i = -900; i <= 900; ++i) {
    const Phase phase{i / 1000.};
    EXPECT_GE(phase_text::litfog_forward_depths(phase), std::log(largest_phase(phase, 0, 1))) << phase.asymmetry;
    EXPECT_GE(phase_text::litfog_backward_depths(phase), std::log(largest_phase(phase, -1, 0))) << phase.asymmetry;
  }
}

TEST(Phase, AsymmetryInFloatsStaysBelowOne) {
  EXPECT_EQ(to_floats({0.3}).asymmetry, 0.3f);
  EXPECT_LT(to_floats({0.99999999}).asymmetry, 1);
  EXPECT_GT(to_floats({-0.99999999}).asymmetry, -1);
}

TEST(Phase, WrongAsymmetryIsAnError) {
  for (const double g : {-1.0, 1.0, kNan}) {
    const auto error = find_error(Phase{g});
    ASSERT_TRUE(error) << g;
    EXPECT_STREQ(error->field, "asymmetry");
    EXPECT_STREQ(error->rule, "must be in (-1, 1)");
  }
  EXPECT_FALSE(find_error(Phase{0.999}));
}

}  // namespace
}  // namespace litfog::test
