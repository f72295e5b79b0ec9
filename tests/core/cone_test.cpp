// SPDX-License-Identifier: Apache-2.0
#include "litfog/cone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "litfog/formulas.h"
#include "reference/digits50.h"
#include "reference/double_limits.h"
#include "reference/near_numbers.h"
#include "reference/random_light.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

using std::numbers::pi;

TEST(PointLightCone, PointLightsConeIsOneEverywhere) {
  for (const double cos_angle : {-1.0, -0.5, 0.0, 0.5, 1.0}) EXPECT_EQ(cone_at(Cone{}, cos_angle), 1);
  EXPECT_EQ(cutoff_angle(Cone{}), pi);
}

TEST(CosineCone, CosineConeIsAPowerOfTheCosineInsideTheHalfAngle) {
  const Cone cone = Cone::cosine(0.5, 8);
  EXPECT_EQ(cone_at(cone, 1), 1);
  EXPECT_DOUBLE_EQ(cone_at(cone, std::cos(0.3)), std::pow(std::cos(0.3), 8));
  EXPECT_DOUBLE_EQ(cone_at(cone, std::cos(0.4999)), std::pow(std::cos(0.4999), 8));
  EXPECT_EQ(cutoff_angle(cone), 0.5);
}

TEST(CosineCone, CosineConeIsDarkFromTheHalfAngleOn) {
  const Cone cone = Cone::cosine(0.5, 0);
  EXPECT_EQ(cone_at(cone, std::cos(0.5)), 0);
  EXPECT_EQ(cone_at(cone, std::cos(0.501)), 0);
  EXPECT_EQ(cone_at(cone, 0), 0);
  EXPECT_EQ(cone_at(cone, -1), 0);
}

TEST(CosineCone, CosineConeOfExponentZeroIsAFlatBeam) {
  const Cone cone = Cone::cosine(0.5, 0);
  for (const double angle : {0.0, 0.1, 0.4, 0.499}) EXPECT_EQ(cone_at(cone, std::cos(angle)), 1);
}

TEST(SmoothstepCone, SmoothstepConeIsFullInsideAndDarkOutside) {
  const Cone cone = Cone::smoothstep(0.2, 0.6);
  EXPECT_EQ(cone_at(cone, 1), 1);
  EXPECT_EQ(cone_at(cone, std::cos(0.2)), 1);
  EXPECT_EQ(cone_at(cone, std::cos(0.6)), 0);
  EXPECT_EQ(cone_at(cone, std::cos(0.7)), 0);
  EXPECT_EQ(cone_at(cone, -1), 0);
  EXPECT_EQ(cutoff_angle(cone), 0.6);
}

TEST(SmoothstepCone, SmoothstepConeIsHermitesCubicBetweenItsAngles) {
  const Cone cone = Cone::smoothstep(0.2, 0.6);
  const double inner = std::cos(0.2);
  const double outer = std::cos(0.6);
  EXPECT_NEAR(cone_at(cone, (inner + outer) / 2), 0.5, 1e-15);
  EXPECT_NEAR(cone_at(cone, outer + 0.25 * (inner - outer)), 0.25 * 0.25 * (3 - 2 * 0.25), 1e-15);
}

TEST(Cone, ConeNeverRisesWithTheAngleAndNeverLeavesItsRange) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const double outer = random.uniform(1e-3, pi);
    const Cone cone = random.chance(0.5) ? Cone::cosine(random.uniform(1e-3, pi / 2), random.log_uniform(1e-3, 1e3))
                                         : Cone::smoothstep(random.uniform(0, outer * 0.999), outer);
    ASSERT_FALSE(find_error(cone));
    double last = 1;
    for (int step = 0; step <= 200; ++step) {
      const double fraction = cone_at(cone, 1 - step / 100.);
      ASSERT_TRUE(fraction >= 0 && fraction <= last) << "angle " << std::acos(1 - step / 100.) << ": " << fraction;
      last = fraction;
    }
  }
}

TEST(ConeProfiles, EveryProfileIsWhatItsFactsSay) {
  for (const ConeProfileFacts& facts : kConeProfiles) {
    const Cone cone = facts.first;
    SCOPED_TRACE(facts.name);
    EXPECT_FALSE(find_error(cone));
    EXPECT_EQ(cone.is_point_light(), facts.parameters.empty());
    EXPECT_EQ(cutoff_angle(cone), facts.cutoff ? cone.*facts.cutoff->member : pi);
    EXPECT_EQ(cone_at(cone, 1), 1);
    const auto at = [&cone](double angle) { return cone_at(cone, std::cos(angle)); };
    const double cutoff = cutoff_angle(cone);
    if (facts.cutoff) {
      EXPECT_EQ(at(cutoff + 1e-9), 0);
      EXPECT_LE(at(dim_angle(cone)), 0.5 + 1e-12);
      EXPECT_NEAR(at(cutoff - 1e-9), cutoff_level(cone), 1e-6);
    }
    for (const double level : {0.1, 0.5, 0.9}) {
      const double angle = angle_at_level(cone, level);
      EXPECT_TRUE(angle == cutoff || std::abs(at(angle) - level) < 1e-12) << level;
    }
    double flux = 0;
    constexpr int kSteps = 100'000;
    for (int i = 0; i < kSteps; ++i) flux += at((i + 0.5) * cutoff / kSteps) * std::sin((i + 0.5) * cutoff / kSteps);
    EXPECT_NEAR(flux * 2 * pi * cutoff / kSteps / flux_within(cone, pi), 1, 1e-8);
    for (const ConeParameter& parameter : facts.parameters) {
      Cone wrong = cone;
      wrong.*parameter.member = kNan;
      ASSERT_TRUE(find_error(wrong)) << parameter.field;
      EXPECT_STREQ(find_error(wrong)->rule, parameter.rule);
      wrong.*parameter.member = parameter.most + 1e-3;
      EXPECT_TRUE(find_error(wrong)) << parameter.field;
    }
  }
  EXPECT_EQ(formulas::litfog_cone_at(double(kConeProfiles.size()), 1.0, 0.0, 0.0), 0) << "dark: no profile's number";
}

TEST(Cone, AngleOrExponentOutOfRangeIsAnError) {
  const auto error = [](const Cone& cone) { return find_error(cone) ? to_string(*find_error(cone)) : "accepted"; };
  EXPECT_EQ(error(Cone::cosine(0, 1)), "cone.half_angle = 0: must be in (0, pi/2]");
  EXPECT_EQ(error(Cone::cosine(2, 1)), "cone.half_angle = 2: must be in (0, pi/2]");
  EXPECT_EQ(error(Cone::cosine(kNan, 1)), "cone.half_angle = nan: must be in (0, pi/2]");
  EXPECT_EQ(error(Cone::cosine(1, -1)), "cone.exponent = -1: must be finite and >= 0");
  EXPECT_EQ(error(Cone::cosine(1, kInfinity)), "cone.exponent = inf: must be finite and >= 0");
  EXPECT_EQ(error(Cone::cosine(1, kNan)), "cone.exponent = nan: must be finite and >= 0");
  EXPECT_EQ(error(Cone::smoothstep(0, 0)), "cone.outer = 0: must be in (0, pi]");
  EXPECT_EQ(error(Cone::smoothstep(0, 4)), "cone.outer = 4: must be in (0, pi]");
  EXPECT_EQ(error(Cone::smoothstep(0, kNan)), "cone.outer = nan: must be in (0, pi]");
  EXPECT_EQ(error(Cone::smoothstep(0.5, 0.5)), "cone.inner = 0.5: must be in [0, outer)");
  EXPECT_EQ(error(Cone::smoothstep(-0.5, 0.5)), "cone.inner = -0.5: must be in [0, outer)");
  EXPECT_EQ(error(Cone::smoothstep(kNan, 0.5)), "cone.inner = nan: must be in [0, outer)");
}

TEST(Cone, EndsOfTheRangesAreAccepted) {
  EXPECT_FALSE(find_error(Cone{}));
  EXPECT_FALSE(find_error(Cone::cosine(pi / 2, 0)));
  EXPECT_FALSE(find_error(Cone::cosine(1e-300, std::numeric_limits<double>::max())));
  EXPECT_FALSE(find_error(Cone::smoothstep(0, pi)));
}

TEST(Cone, AngleThatFloatsRoundBeyondALimitIsTheLimit) {
  const auto half = double(float(pi / 2));
  const auto whole = double(float(pi));
  ASSERT_GT(half, pi / 2);
  ASSERT_GT(whole, pi);
  const std::pair<Cone, Cone> pairs[] = {{Cone::cosine(half, 4), Cone::cosine(pi / 2, 4)},
                                         {Cone::cosine(half, 0), Cone::cosine(pi / 2, 0)},
                                         {Cone::smoothstep(0.5, whole), Cone::smoothstep(0.5, pi)}};
  for (const auto& [given, meant] : pairs) {
    ASSERT_FALSE(find_error(given));
    EXPECT_EQ(cutoff_angle(given), cutoff_angle(meant));
    for (const double cosine : {-1.0, -1e-8, 0.0, 1e-8, 0.5, 1.0})
      EXPECT_EQ(cone_at(given, cosine), cone_at(meant, cosine));
    for (const double level : {1e-9, 0.5}) EXPECT_EQ(angle_at_level(given, level), angle_at_level(meant, level));
    for (const double angle : {1.0, pi}) EXPECT_EQ(flux_within(given, angle), flux_within(meant, angle));
  }
  for (const Cone& beyond : {Cone::cosine(pi / 2 * (1 + 3e-7), 4), Cone::smoothstep(0.5, pi * (1 + 3e-7))}) {
    EXPECT_TRUE(find_error(beyond));
  }
  EXPECT_TRUE(find_error(Cone::smoothstep(pi, whole))) << "the inner angle's limit is open";
}

TEST(Cone, ConeIsNeverNanAtAnyAcceptedWidth) {
  for (const Cone& cone : {Cone::smoothstep(0, 1e-9), Cone::smoothstep(0, 1e-300), Cone::smoothstep(1, 1 + 1e-15),
                           Cone::smoothstep(std::nextafter(pi, 0), pi), Cone::cosine(1e-300, 1e300),
                           Cone::cosine(pi / 2, std::numeric_limits<double>::max())}) {
    ASSERT_FALSE(find_error(cone));
    for (const double cos_angle : {-1.0, -std::cos(1e-9), 0.0, std::cos(1.0), std::cos(1e-9), 1 - 0x1p-53, 1.0}) {
      const double fraction = cone_at(cone, cos_angle);
      EXPECT_TRUE(fraction >= 0 && fraction <= 1)
          << "inner " << cone.inner << ", outer " << cone.outer << ", cosine " << cos_angle << ": " << fraction;
    }
  }
}

/// Cones as wide and as narrow as lights come.
Cone draw_cone(Random& random) {
  if (random.chance(0.5)) return Cone::cosine(random.log_uniform(1e-3, pi / 2), random.log_uniform(1e-3, 1e5));
  const double outer = random.log_uniform(1e-3, pi);
  return Cone::smoothstep(random.chance(0.1) ? 0 : random.uniform(0, 0.999 * outer), outer);
}

std::string describe(const Cone& cone, double argument) {
  char text[160];
  std::snprintf(text, sizeof text, "half angle %a, exponent %a, inner %a, outer %a; %a", cone.half_angle, cone.exponent,
                cone.inner, cone.outer, argument);
  return text;
}

/// The definitions in 50 digits, for any angle from the axis.
Digits50 fraction_at(const Cone& cone, const Digits50& angle) {
  if (cone.profile == ConeProfile::cosine) return pow(cos(angle), Digits50(cone.exponent));
  const Digits50 inner = cos(Digits50(cone.inner));
  const Digits50 outer = cos(Digits50(cone.outer));
  const Digits50 t = (cos(angle) - outer) / (inner - outer);
  return t >= 1 ? Digits50(1) : t <= 0 ? Digits50(0) : t * t * (3 - 2 * t);
}

TEST(CosineCone, CosineConeIsExactToAnUlpInsideItsEdge) {
  WorstError error("cone_at, cosine", "half angle 1e-3..pi/2, exponent 1e-3..1e5", kCosineConeMaxUlp);
  Random random(13);
  for (int i = 0; i < 20000; ++i) {
    const Cone cone = Cone::cosine(random.log_uniform(1e-3, pi / 2), random.log_uniform(1e-3, 1e5));
    const double edge = std::cos(cone.half_angle);
    const double cosine = random.uniform(edge, 1);
    if (!(cosine > std::nextafter(edge, 2.0))) continue;
    error.add(ulp_error(cone_at(cone, cosine), Digits50(pow(Digits50(cosine), Digits50(cone.exponent)))),
              [&] { return describe(cone, cosine); });
  }
  error.check();
}

TEST(SmoothstepCone, SmoothstepConeIsExactToItsBoundTimesTheWidthOfItsEdge) {
  WorstError error("cone_at, smoothstep", "outer 1e-3..pi", kSmoothstepConeMaxErrorTimesWidth, "times width");
  Random random(14);
  for (int i = 0; i < 20000; ++i) {
    const double outer = random.log_uniform(1e-3, pi);
    const Cone cone = Cone::smoothstep(random.chance(0.1) ? 0 : outer * (1 - random.log_uniform(1e-4, 1)), outer);
    const Digits50 inner_cosine = cos(Digits50(cone.inner)), outer_cosine = cos(Digits50(cone.outer));
    const Digits50 width = inner_cosine - outer_cosine;
    const double cosine = random.uniform(std::cos(cone.outer), std::cos(cone.inner));
    const Digits50 t = (cosine - outer_cosine) / width;
    const Digits50 reference = t >= 1 ? Digits50(1) : t <= 0 ? Digits50(0) : Digits50(t * t * (3 - 2 * t));
    error.add(double(abs(cone_at(cone, cosine) - reference) * width), [&] { return describe(cone, cosine); });
  }
  error.check();
}

TEST(Cone, AngleAtALevelIsWhereTheConeFallsToIt) {
  Random random(11);
  WorstError error("angle_at_level", "level 1e-3..0.999", kAngleAtLevelMaxError, "relative");
  for (int i = 0; i < 300; ++i) {
    const Cone cone = draw_cone(random);
    const double level = random.log_uniform(1e-3, 0.999);
    const double angle = angle_at_level(cone, level);
    if (cone.profile == ConeProfile::cosine && angle == cone.half_angle) {
      EXPECT_GE(fraction_at(cone, angle), level * (1 - 1e-9)) << "ends only where it is still brighter";
      continue;
    }
    Digits50 low = 0;
    Digits50 high = cone.profile == ConeProfile::cosine ? pi / 2 : cone.outer;
    for (int step = 0; step < 90; ++step) {
      const Digits50 middle = (low + high) / 2;
      (fraction_at(cone, middle) > level ? low : high) = middle;
    }
    error.add(relative_error(angle, low), [&] { return describe(cone, level); });
  }
  error.check();
}

RC_GTEST_PROP(Cone, BoundsHoldOfAnglesAtLevelsNextToZeroAndOne, ()) {
  const double level = *near_one_of({0, 1e-300, 1e-9, 0.5, 1 - 1e-9, 1 - 1e-15, 1});
  RC_PRE(level > 0 && level < 1);
  const double outer = *near_one_of({1e-3, pi / 2, pi}), inner = *rc::gen::element(0., 0.5 * outer, 0.999 * outer);
  const Cone smoothstep = Cone::smoothstep(inner, std::min(outer, pi));
  // With w = 1 - t and level = cos^2(a), w^2 (3 - 2 w) = 1 - level has the root w = 1/2 - cos(2 a / 3 + pi / 3).
  const Digits50 whole = boost::math::constants::pi<Digits50>();
  const Digits50 faded = Digits50(0.5) - cos((2 * acos(sqrt(Digits50(level))) + whole) / 3);
  const Digits50 full = cos(Digits50(inner));
  const Digits50 expected = acos(Digits50(full - faded * (full - cos(Digits50(smoothstep.outer)))));
  RC_ASSERT(relative_error(angle_at_level(smoothstep, level), expected) <= kAngleAtLevelMaxError);
  const double exponent = *near_one_of({0.5, 1, 8, 1000});
  const Digits50 cosine = acos(Digits50(pow(Digits50(level), 1 / Digits50(exponent))));
  RC_ASSERT(relative_error(angle_at_level(Cone::cosine(pi / 2, exponent), level), std::min<Digits50>(cosine, pi / 2)) <=
            kAngleAtLevelMaxError);
}

TEST(Cone, AngleAtALevelAboveTheEdgeIsTheCutOff) {
  EXPECT_EQ(angle_at_level(Cone::cosine(0.5, 0), 0.5), 0.5);
  EXPECT_EQ(angle_at_level(Cone::cosine(0.5, -0.0), 0.5), 0.5);
  EXPECT_EQ(angle_at_level(Cone::cosine(0.5, 1), 0.5), 0.5);
  EXPECT_DOUBLE_EQ(angle_at_level(Cone::cosine(1.5, 1), 0.5), pi / 3);
  EXPECT_EQ(angle_at_level(Cone{}, 0.5), pi);
}

TEST(Cone, FluxIsTheIntegralOverTheSphere) {
  using Quadrature = boost::math::quadrature::gauss_kronrod<Digits50, 61>;
  Random random(12);
  WorstError error("flux_within", "any angle", kFluxMaxError, "relative");
  for (int i = 0; i < 100; ++i) {
    const Cone cone = draw_cone(random);
    const double end = random.chance(0.5) ? pi : random.uniform(0, cutoff_angle(cone));
    const auto density = [&cone](const Digits50& angle) { return fraction_at(cone, angle) * sin(angle); };
    const Digits50 last = std::min(end, cutoff_angle(cone));
    const Digits50 full = std::min<Digits50>(cone.inner, last);  // a smoothstep's; the integrand is smooth beyond
    const Digits50 sphere = 2 * boost::math::constants::pi<Digits50>();
    const Digits50 reference =
        sphere * (1 - cos(full) + (last > full ? Quadrature::integrate(density, full, last, 12, 1e-18) : Digits50(0)));
    error.add(relative_error(flux_within(cone, end), reference), [&] { return describe(cone, end); });
  }
  error.check();
}

/// Right angles and others, and where a cone begins to fade and ends.
double draw_angle(const Cone& cone) {
  return std::clamp(*near_one_of({0, pi / 6, pi / 4, pi / 3, pi / 2, 3 * pi / 4, pi, cone.inner, cone.outer,
                                  cone.half_angle, (cone.inner + cone.outer) / 2}),
                    0.0, pi);
}

RC_GTEST_PROP(Cone, BoundsHoldAtAnglesWhereAConeBeginsOrEnds, ()) {
  Cone cone;
  if (*rc::gen::arbitrary<bool>()) {
    cone = Cone::cosine(std::min(draw_angle({}), pi / 2), *near_one_of({0, 1, 2, 8, 1000}));
  } else {
    cone.outer = draw_angle({});
    cone = Cone::smoothstep(*near_one_of({0, cone.outer / 2, 0.99 * cone.outer}), cone.outer);
  }
  RC_PRE(!find_error(cone));
  const double angle = draw_angle(cone), cosine = std::cos(angle);
  const double fraction = cone_at(cone, cosine);
  if (cone.profile == ConeProfile::smoothstep) {
    const Digits50 width = cos(Digits50(cone.inner)) - cos(Digits50(cone.outer));
    RC_PRE(width > 1e-30);
    RC_ASSERT(abs(fraction - fraction_at(cone, acos(Digits50(cosine)))) * width <= kSmoothstepConeMaxErrorTimesWidth);
  } else if (cosine > std::nextafter(std::cos(cone.half_angle), 2.0)) {
    RC_ASSERT(ulp_error(fraction, Digits50(pow(Digits50(cosine), Digits50(cone.exponent)))) <= kCosineConeMaxUlp);
  } else if (cosine < std::nextafter(std::cos(cone.half_angle), -2.0)) {
    RC_ASSERT(fraction == 0);
  }
  // Angles are taken as they are, not by their cosines: the flux out to one is that of the definition.
  const Digits50 last = std::min(angle, cutoff_angle(cone));
  Digits50 flux;
  if (cone.profile == ConeProfile::cosine) {
    const Digits50 power = Digits50(cone.exponent) + 1;
    flux = (1 - pow(cos(last), power)) / power;
  } else {
    const Digits50 outer = cos(Digits50(cone.outer)), width = cos(Digits50(cone.inner)) - outer;
    const Digits50 full = std::min<Digits50>(cone.inner, last);
    const auto integral = [&](const Digits50& x) {  // of t^2 (3 - 2 t)
      const Digits50 t = (x - outer) / width;
      return width * t * t * t * (1 - t / 2);
    };
    flux = 1 - cos(full) + (last > full ? integral(cos(full)) - integral(cos(last)) : Digits50(0));
  }
  flux *= 2 * boost::math::constants::pi<Digits50>();
  RC_ASSERT(relative_error(flux_within(cone, angle), flux) <= kFluxMaxError);
}

TEST(Cone, FluxHasItsClosedForms) {
  EXPECT_DOUBLE_EQ(flux_within(Cone{}, pi), 4 * pi);
  EXPECT_DOUBLE_EQ(flux_within(Cone::cosine(pi / 2, 1), pi), pi);      // a Lambertian patch
  EXPECT_DOUBLE_EQ(flux_within(Cone::cosine(pi / 3, 0), pi), pi);      // a flat spherical cap
  EXPECT_DOUBLE_EQ(flux_within(Cone::smoothstep(0, pi), pi), 2 * pi);  // even about 90 degrees
  EXPECT_DOUBLE_EQ(flux_within(Cone::smoothstep(pi / 3, pi / 2), pi / 3), pi);
}

}  // namespace
}  // namespace litfog::test
