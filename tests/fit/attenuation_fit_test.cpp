// SPDX-License-Identifier: Apache-2.0
#include "litfog/fit/attenuation_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/value_errors.h"
#include "fit/falloff.h"
#include "fit/random_target.h"
#include "litfog/light.h"
#include "reference/double_limits.h"
#include "reference/falloff_reference.h"
#include "reference/random_light.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

using Samples = std::vector<AttenuationSample>;

std::string describe(const AttenuationTarget& target) {
  char text[128];
  std::snprintf(text, sizeof text, "threshold %.17g, extent %.17g, constant %.17g%s, samples", target.threshold,
                target.extent.value_or(kNan), target.constant.value_or(kNan), target.is_robust ? ", robust" : "");
  std::string result = text;
  for (const auto& [range, attenuation, weight] : target.samples) {
    std::snprintf(text, sizeof text, " (%.17g, %.17g, %.17g)", range, attenuation, weight);
    result += text;
  }
  return result;
}

/// What a table is drawn from.
struct Table {
  Attenuation light;
  double first = 1;  ///< metres
  double last = 100;
  int count = 20;
  double noise = 0;     ///< standard deviation of ln attenuation
  double outliers = 0;  ///< fraction of the samples that are wrong by a factor of 2 to 20
  bool is_weighted = false;
};

Samples draw(const Table& table, Random& random) {
  Samples samples;
  double last_range = -1;
  for (int i = 0; i < table.count; ++i) {
    const double fraction = (i + (i > 0 && i + 1 < table.count ? random.uniform(-0.3, 0.3) : 0)) / (table.count - 1);
    const double range = table.first * std::pow(table.last / table.first, fraction);
    if (!(range > last_range)) continue;
    last_range = range;
    double log_error = 0;
    for (int k = 0; k < 12; ++k) log_error += table.noise * random.uniform(-0.5, 0.5);
    if (random.chance(table.outliers)) log_error += random.pick(std::array{-1, 1}) * random.uniform(0.7, 3);
    const double attenuation = std::min(1.0, attenuation_at(table.light, range) * std::exp(log_error));
    samples.push_back({range, attenuation, table.is_weighted ? random.log_uniform(0.01, 100) : 1});
  }
  return samples;
}

/// A light whose terms all matter within a range.
Attenuation draw_light(Random& random, double range, bool is_clamped) {
  return {is_clamped ? random.uniform(0.1, 0.9) : random.uniform(1, 3), random.log_uniform(0.5, 10) / range,
          random.log_uniform(1, 40) / range / range};
}

struct Problem {
  std::string family;
  AttenuationTarget target;
};

/// A hundred fits of ten kinds.
std::vector<Problem> certified_problems() {
  std::vector<Problem> problems;
  Random random(4);
  const auto add = [&](const std::string& family, const Table& table, const auto& change) {
    Problem problem{family, {.samples = draw(table, random)}};
    change(problem.target, table.light);
    problems.push_back(problem);
  };
  const auto as_is = [](AttenuationTarget&, const Attenuation&) {};
  for (int i = 0; i < 10; ++i) {
    const double far = random.log_uniform(5, 2000);
    const Attenuation light = draw_light(random, far, i % 3 == 2);
    const bool is_weighted = i % 2 == 1;
    const auto with_extent = [&](AttenuationTarget& target, const Attenuation& a) {
      target.extent = compute_extent(a, target.threshold) * random.uniform(0.9, 1.1);
      if (i % 2 == 1) target.constant = a.constant;
    };
    const auto with_constant = [&](AttenuationTarget& target, const Attenuation& a) {
      target.constant = i % 2 == 0 ? 1 : a.constant;
    };
    add("exact", {light, far / 50, far, 12 + i, 0, 0, is_weighted}, as_is);
    add("noise 1 %", {light, far / 50, far, 12 + i, 0.01, 0, is_weighted}, as_is);
    add("noise 20 %", {light, far / 50, far, 12 + i, 0.2, 0, is_weighted}, as_is);
    add("outliers", {light, far / 50, far, 20, 0.02, 0.15, is_weighted}, as_is);
    add("outliers, robust", {light, far / 50, far, 20, 0.02, 0.15, is_weighted},
        [](AttenuationTarget& target, const Attenuation&) { target.is_robust = true; });
    add("three points", {light, far / 10, far, 3, i < 5 ? 0 : 0.1, 0, is_weighted}, as_is);
    add("extent", {light, far / 50, far, 12, 0.05, 0, is_weighted}, with_extent);
    add("constant given", {light, far / 50, far, 12, 0.05, 0, is_weighted}, with_constant);
    const Attenuation plain = i < 5 ? Attenuation{random.uniform(1.2, 5), 0, 0}                             // flat
                                    : Attenuation{1, 3 / far, random.log_uniform(1e-9, 1e-3) / far / far};  // linear
    add(i < 5 ? "flat" : "nearly linear", {plain, far / 50, far, 15, 0.01, 0, is_weighted}, as_is);
    const double unit = i % 2 == 0 ? random.log_uniform(1e-6, 1e-4) : random.log_uniform(1e6, 1e9);
    add("huge and tiny ranges", {draw_light(random, unit, false), unit / 100, unit, 15, 0.03, 0, is_weighted}, as_is);
  }
  return problems;
}

TEST(AttenuationFit, HundredFitsHaveNineDigitsOfOptimaCertifiedAtFiftyDigits) {
  Random random(5);
  WorstError coefficients("C, L, Q", "100 certified tables", 1e-9, "relative");
  WorstError kkt("KKT residual", "100 certified tables", 1e-15, "");
  int unidentified = 0;
  const std::vector<Problem> problems = certified_problems();
  EXPECT_EQ(problems.size(), 100u);
  for (const Problem& problem : problems) {
    const auto& [family, target] = problem;
    const auto describe_problem = [&problem] { return problem.family + ": " + describe(problem.target); };
    const AttenuationFit fit = fit_attenuation(target);
    const FalloffReferenceSearch search(target, fit.loss_scale);
    const FalloffReference reference = search.certify(search.explore(random, 20));
    EXPECT_NE(fit.status, AttenuationFitStatus::unproven) << describe_problem();
    kkt.add(fit.kkt_residual, describe_problem);
    EXPECT_TRUE(reference.is_certified) << describe_problem();
    EXPECT_LE(fit.objective, double(reference.objective) * (1 + 1e-12) + 1e-26) << describe_problem();
    double worst = 0;
    const double found[] = {fit.attenuation.constant, fit.attenuation.linear, fit.attenuation.quadratic};
    for (std::size_t j = 0; j < 3; ++j) {
      const double error = relative_error(found[j], reference.coefficients[j]);
      if (!(error <= worst)) worst = error;  // NaN, too
    }
    if (worst > 1e-9 && !fit.covariance) {
      ++unidentified;
    } else {
      coefficients.add(worst, describe_problem);
    }
  }
  coefficients.check();
  kkt.check();
  EXPECT_LE(unidentified, 1);
}

TEST(AttenuationFit, NoSearchFromManyStartsFindsABetterFit) {
  Random random(6);
  WorstError excess("objective", "above the best of 8 random descents a face", 1e-7, "relative");
  WorstError boxes("boxes", "examined for a proof", scaled_count(3000), "");  // some proofs are long
  for (int i = 0; i < scaled_count(200); ++i) {
    const double far = random.log_uniform(1, 5000);
    Attenuation light = draw_light(random, far, random.chance(0.5));
    if (random.chance(0.2)) light.constant = 0;
    if (random.chance(0.2)) light.linear = 0;
    const Table table{.light = light,
                      .first = far * random.log_uniform(1e-6, 0.1),
                      .last = far,
                      .count = int(random.uniform(2, 25)),
                      .noise = random.pick(std::array{0.0, 0.02, 0.2, 1.0}),
                      .outliers = random.pick(std::array{0.0, 0.2}),
                      .is_weighted = random.chance(0.5)};
    AttenuationTarget target{.samples = draw(table, random)};
    if (random.chance(0.4)) target.extent = far * random.log_uniform(0.3, 3);
    if (random.chance(0.4)) target.constant = random.pick(std::array{0.0, 0.5, 1.0, 1.5});
    target.is_robust = random.chance(0.2);
    const AttenuationFit fit = fit_attenuation(target);
    EXPECT_NE(fit.status, AttenuationFitStatus::unproven) << describe(target);
    EXPECT_FALSE(find_error(fit.attenuation)) << describe(target);
    boxes.add(double(fit.boxes), [&] { return describe(target); });
    const FalloffReferenceSearch search(target, fit.loss_scale);
    const double best = search.objective(search.explore(random, 8));
    double weights = 0;
    for (const auto& sample : target.samples) weights += sample.weight;
    // The search lets the constant reach 1 / threshold.
    const bool ends_at_largest_constant = target.extent && fit.attenuation.constant > (1 - 0x1p-19) / target.threshold;
    if (ends_at_largest_constant) continue;
    excess.add(std::max(0.0, fit.objective - best) / std::max(best, 1e-13 * weights), [&] { return describe(target); });
  }
  excess.check();
  boxes.check();
}

TEST(AttenuationFit, SamplesAnyNumberOfExtentsAwayHaveTheirBestFit) {
  Random random(14);
  int optimal = 0;
  for (int i = 0; i < scaled_count(300); ++i) {
    AttenuationTarget target{.threshold = random.pick(std::array{1e-6, 0.01, 0.05, 0.5}),
                             .extent = random.log_uniform(1e-8, 1e8),
                             .is_robust = random.chance(0.2)};
    if (random.chance(0.25)) target.constant = 0.9 / target.threshold * random.log_uniform(1e-3, 1);
    double range = random.log_uniform(0.01, 10), weights = 0;
    for (int k = int(random.uniform(1, 6)); k > 0; --k, range *= random.uniform(1.1, 3)) {
      target.samples.push_back({range, random.chance(0.2) ? 1 : random.log_uniform(1e-3, 1)});
      weights += target.samples.back().weight;
    }
    const AttenuationFit fit = fit_attenuation(target);
    if (fit.status != AttenuationFitStatus::optimal) continue;
    ++optimal;
    const FalloffReferenceSearch search(target, fit.loss_scale);
    EXPECT_GE(search.least_on_grid(), fit.objective * (1 - 1e-7) - 1e-20 * weights) << describe(target);
  }
  EXPECT_GT(optimal, scaled_count(100));
}

// A constant attenuation meets the dark sample. The search begins at a fit that may miss it by so much that bounds for
// the other samples overflow.
TEST(AttenuationFit, DarkSampleAtTheLampIsMetWhateverItsWeight) {
  Random random(15);
  int optimal = 0;
  for (int i = 0; i < scaled_count(300); ++i) {
    const double dark = random.log_uniform(1e-100, 1e-2);
    AttenuationTarget target{.samples = {{0, dark, random.log_uniform(1, 1e21)}}, .is_robust = random.chance(0.3)};
    double range = random.log_uniform(1e-3, 1e3);
    for (int k = int(random.uniform(1, 4)); k > 0; --k, range *= random.uniform(1.01, 3)) {
      target.samples.push_back({range, random.uniform(0.5, 1), random.log_uniform(1e-6, 1)});
    }
    const AttenuationFit fit = fit_attenuation(target);
    if (fit.status != AttenuationFitStatus::optimal) continue;
    ++optimal;
    const FalloffReferenceSearch search(target, fit.loss_scale);
    EXPECT_GE(search.least_on_grid(), fit.objective * (1 - 1e-7)) << describe(target);
  }
  EXPECT_GT(optimal, scaled_count(200));
}

TEST(AttenuationFit, EveryExtentIsMetExactly) {
  Random random(7);
  WorstError error("extent", "1e-29..1e29 m, t 1e-6..1 - 1e-15", 1e-12, "relative");
  for (int i = 0; i < scaled_count(3000); ++i) {
    const std::array thresholds{0.05, random.log_uniform(1e-6, 0.99), 1 - random.log_uniform(1e-15, 0.1)};
    AttenuationTarget target{.threshold = random.pick(thresholds), .extent = random.log_uniform(1e-29, 1e29)};
    const double top = 1 / target.threshold;
    if (random.chance(0.5)) {
      target.constant = top * random.pick(std::array{0.0, random.uniform(0, 1), 1 - random.log_uniform(1e-5, 1)});
    }
    target.family =
        random.pick(std::array{AttenuationFamily::quadratic, AttenuationFamily::linear, AttenuationFamily::mixed});
    if (i % 10 == 0) {
      for (int k = 1; k < 6; ++k) {
        target.samples.push_back({*target.extent * 0.2 * k, random.uniform(target.threshold, 1)});
      }
    }
    const AttenuationFit fit = fit_attenuation(target);
    error.add(std::abs(compute_extent(fit.attenuation, target.threshold) / *target.extent - 1),
              [&] { return describe(target); });
  }
  error.check();
}

TEST(AttenuationFit, ExtentAloneHasItsClosedForms) {
  const auto fit = [](AttenuationFamily family, std::optional<double> constant, double extent = 6) {
    return fit_attenuation({.threshold = 0.25, .extent = extent, .constant = constant, .family = family}).attenuation;
  };
  EXPECT_EQ(fit(AttenuationFamily::quadratic, {}), (Attenuation{1, 0, 3 / 36.}));
  EXPECT_EQ(fit(AttenuationFamily::linear, {}), (Attenuation{1, 0.5, 0}));
  EXPECT_EQ(fit(AttenuationFamily::mixed, {}), (Attenuation{1, 0.25, 1.5 / 36}));
  EXPECT_EQ(fit(AttenuationFamily::quadratic, 0), (Attenuation{0, 0, 4 / 36.}));
  EXPECT_EQ(fit(AttenuationFamily::linear, 2.5), (Attenuation{2.5, 0.25, 0}));
  EXPECT_EQ(fit(AttenuationFamily::mixed, {}, 0.5), (Attenuation{1, 3, 6}));  // the term of Q is made exact, not L's
}

TEST(AttenuationFit, LightOfAnEndHasItsCandelaAndItsIlluminanceThere) {
  Random random(40);
  WorstError error("candela(light)", "1e-3..1e8 cd, 1e-8..1e3 lx, t 1e-6..0.99", kLightEndMaxError, "relative");
  for (int i = 0; i < scaled_count(3000); ++i) {
    const double peak = random.log_uniform(1e-3, 1e8), lux = random.log_uniform(1e-8, 1e3);
    const double threshold = random.chance(0.5) ? kDefaultThreshold : random.log_uniform(1e-6, 0.99);
    const auto [size, extent] = compute_end(peak, lux, threshold);
    const AttenuationTarget target{.threshold = threshold, .extent = extent};
    Light light;
    light.color = {size, 0, 2 * size};
    light.attenuation = fit_attenuation(target).attenuation;
    error.add(std::abs(candela(light).r / peak - 1), [&] { return describe(target); });
    EXPECT_NEAR(kWhiteLux * size * attenuation_at(light.attenuation, extent) / lux, 1, 1e-13);
  }
  error.check();
  EXPECT_EQ(compute_end(100, 1, 0.05).size, 1) << "of the lights of data/lights";
}

TEST(AttenuationFit, ExtentAndAPointHaveTheirClosedForm) {
  // C = 1 and a = 1/2 at 2 of 6: 2 L + 4 Q = 1, 6 L + 36 Q = 3.
  const AttenuationFit fit = fit_attenuation({.threshold = 0.25, .extent = 6, .constant = 1, .samples = {{2, 0.5}}});
  EXPECT_EQ(fit.status, AttenuationFitStatus::optimal) << fit.sentence;
  EXPECT_NEAR(fit.attenuation.linear, 0.5, 1e-15);
  EXPECT_NEAR(fit.attenuation.quadratic, 0, 1e-16);
  EXPECT_NEAR(fit.objective, 0, 1e-30);
}

TEST(AttenuationFit, FitsOfTheOgreTableReachItsStatedRanges) {
  // The OGRE wiki's rows, "-Point Light Attenuation": range, L, Q; C = 1. What they are at their range lies 11 % apart.
  const double rows[][3] = {{3250, .0014, .000007}, {600, .007, .0002}, {325, .014, .0007}, {200, .022, .0019},
                            {160, .027, .0028},     {100, .045, .0075}, {65, .07, .017},    {50, .09, .032},
                            {32, .14, .07},         {20, .22, .20},     {13, .35, .44},     {7, .7, 1.8}};
  WorstError error("attenuation", "at the stated range, 12 OGRE rows at 1.25 %", 1e-12, "");
  double largest_change = 0;
  for (const auto& [range, linear, quadratic] : rows) {
    const Attenuation row{1, linear, quadratic};
    AttenuationTarget target{.threshold = 0.0125, .extent = range, .constant = 1};
    for (int i = 1; i < 10; ++i) target.samples.push_back({range * i / 10, attenuation_at(row, range * i / 10)});
    const AttenuationFit fit = fit_attenuation(target);
    EXPECT_NE(fit.status, AttenuationFitStatus::unproven);
    error.add(std::abs(attenuation_at(fit.attenuation, range) - 0.0125), [&, r = range] { return std::to_string(r); });
    largest_change = std::max(largest_change, std::abs(fit.largest_error));
  }
  error.check();
  EXPECT_LT(largest_change, 1.25 / 1.06 - 1) << "more than the rows are off at their range";
}

TEST(AttenuationFit, FitOfAnExactTableIsTheLightThatItWasDrawnFrom) {
  Random random(8);
  WorstError error("C, L, Q", "from 20 exact samples", 1e-11, "relative");
  for (int i = 0; i < 1000; ++i) {
    const double far = random.log_uniform(1e-6, 1e9);
    const Attenuation light = draw_light(random, far, i % 4 == 0);
    const AttenuationTarget target{.samples = draw({light, far / 100, far, 20}, random)};
    const Attenuation found = fit_attenuation(target).attenuation;
    if (light.constant < 1 && target.samples[8].attenuation == 1) continue;  // the clamp has hidden the near half
    for (const auto& [a, b] : {std::pair(found.constant, light.constant),
                               {found.linear, light.linear},
                               {found.quadratic, light.quadratic}}) {
      error.add(std::abs(a / b - 1), [&] { return describe(target); });
    }
  }
  error.check();
}

TEST(AttenuationFit, CoefficientsThatAreZeroAreFound) {
  for (const Attenuation light :
       {Attenuation{0, 2, 0.5}, {0, 1, 0}, {0, 0, 0.3}, {2, 0, 0.25}, {1.5, 0.25, 0}, {3, 0, 0}}) {
    Samples samples;
    for (int i = 2; i < 9; ++i) samples.push_back({double(i), attenuation_at(light, i)});
    const AttenuationFit fit = fit_attenuation({.samples = samples});
    EXPECT_NEAR(fit.attenuation.constant, light.constant, 1e-12);
    EXPECT_NEAR(fit.attenuation.linear, light.linear, 1e-12);
    EXPECT_NEAR(fit.attenuation.quadratic, light.quadratic, 1e-12);
    EXPECT_LT(fit.rms_error, 1e-14);
  }
}

TEST(AttenuationFit, FitDoesNotDependOnUnitsOrOnTheSumOfWeights) {
  Random random(9);
  const Table table{.light = draw_light(random, 50, false), .last = 50, .count = 12, .noise = 0.1, .is_weighted = true};
  const AttenuationTarget target{.samples = draw(table, random)};
  AttenuationTarget scaled = target;
  for (auto& sample : scaled.samples) {
    sample.range *= 0x1p40;
    sample.weight *= 0x1p-60;
  }
  const Attenuation a = fit_attenuation(target).attenuation, b = fit_attenuation(scaled).attenuation;
  EXPECT_EQ(a, (Attenuation{b.constant, b.linear * 0x1p40, b.quadratic * 0x1p80}));
}

TEST(AttenuationFit, SamplesWithoutWeightAreLeftOut) {
  AttenuationTarget target{.samples = {{1, 0.5}, {2, 0.3}, {3, 0.2}, {4, 0.1}}};
  const AttenuationFit without = fit_attenuation(target);
  target.samples.insert(target.samples.begin() + 2, {2.5, 0.9, 0});
  const AttenuationFit with = fit_attenuation(target);
  EXPECT_EQ(with.attenuation, without.attenuation);
  EXPECT_EQ(with.rms_error, without.rms_error);
  ASSERT_EQ(with.residuals.size(), 5u);
  EXPECT_NEAR(with.residuals[2], std::log(attenuation_at(with.attenuation, 2.5) / 0.9), 1e-15);
}

TEST(AttenuationFit, ResidualsAreOfLnAttenuationAndErrorsSignedFractionsOfIt) {
  const AttenuationTarget target{.samples = {{1, 0.5, 2}, {2, 0.5, 3}, {3, 0.1, 1}, {5, 0.12, 1}}};
  const AttenuationFit fit = fit_attenuation(target);
  double objective = 0, squares = 0, largest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [range, attenuation, weight] = target.samples[i];
    const double residual = std::log(attenuation_at(fit.attenuation, range)) - std::log(attenuation);
    EXPECT_NEAR(fit.residuals[i], residual, 1e-15);
    const double error = attenuation_at(fit.attenuation, range) / attenuation - 1;
    objective += weight * residual * residual;
    squares += weight * error * error;
    if (std::abs(error) > std::abs(largest)) largest = error;
  }
  EXPECT_NEAR(fit.objective, objective, 1e-14);
  EXPECT_NEAR(fit.rms_error, std::sqrt(squares / 7), 1e-14);
  EXPECT_NEAR(fit.largest_error, largest, 1e-15);
  AttenuationTarget with_outlier{.is_robust = true};
  for (int i = 1; i <= 12; ++i) with_outlier.samples.push_back({double(i), i == 6 ? 0.8 : 1 / (1 + 0.1 * i * i)});
  EXPECT_NEAR(fit_attenuation(with_outlier).largest_error, 1 / 4.6 / 0.8 - 1, 0.01) << "too dark: negative";
  EXPECT_GE(fit.milliseconds, 0);
  EXPECT_GT(fit.iterations, 0u);
}

TEST(AttenuationFit, SentenceStatesTheErrors) {
  // The best that does not rise is flat, at the root of 0.5 * 0.51: 0.995 % above the one, 0.985 % below the other.
  EXPECT_EQ(fit_attenuation({.samples = {{1, 0.5}, {2, 0.51}}}).sentence,
            "no better attenuation exists: off by 0.99 % (rms), by 0.995 % at one sample");
  EXPECT_EQ(fit_attenuation({.samples = {{1, 0.5}, {2, 0.25}}}).sentence,
            "no better attenuation exists: off by 0 % (rms), by 0 % at one sample");
}

TEST(AttenuationFit, KktResidualIsTheLargestSlopeThatNoBoundHolds) {
  const Falloff falloff{.samples = {{0.5, 0.4L, 1}, {1, 0.9L, 0.5}, {2, 1.5L, 0.25}, {3, 2.5L, 1}}};
  for (const Coefficients& q : {Coefficients{1, 0.5, 0.3},
                                {1.5, 0.9, 0.6},
                                {0.9, 0.2, 0.6},
                                {1.1, 0, 0.3},
                                {2, 0, 0.3},
                                {0, 2.5, 0},
                                {0, 3, 0}}) {
    double worst = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      Coefficients more = q, less = q;
      more[j] += 1e-6;
      less[j] -= 1e-6;
      const double slope = (falloff.objective(more) - falloff.objective(less)) / 2e-6;
      double scale = 0;
      for (const auto& [x, y, weight] : falloff.samples) scale += 2 * weight * std::pow(x, j) / denominator(q, x);
      worst = std::max(worst, (q[j] == 0 ? -slope : std::abs(slope)) / scale);
    }
    EXPECT_NEAR(kkt_residual(falloff, q), worst, 1e-8) << q[0] << ", " << q[1] << ", " << q[2];
  }
}

TEST(AttenuationFit, FitNamesTheConstraintsThatHoldIt) {
  const auto active = [](const AttenuationTarget& target) {
    std::string names;
    for (const auto constraint : fit_attenuation(target).active) names += std::string(name_of(constraint)) + ";";
    return names;
  };
  EXPECT_EQ(active({.extent = 10}), "extent;linear = 0;");
  EXPECT_EQ(active({.extent = 10, .constant = 1, .family = AttenuationFamily::linear}),
            "extent;constant given;quadratic = 0;");
  EXPECT_EQ(active({.extent = 10, .constant = 0}), "extent;constant given;linear = 0;") << "given, not found";
  EXPECT_EQ(active({.samples = {{1, 0.5}, {2, 0.25}, {4, 0.125}}}), "constant = 0;quadratic = 0;");
  EXPECT_EQ(active({.samples = {{1, 0.5}, {2, 0.3}, {4, 0.1}, {5, 0.07}}}).find("extent"), std::string::npos);
}

TEST(AttenuationFit, OutliersDoNotPullARobustFit) {
  Random random(10);
  WorstError robust_error("robust fit", "3 of 20 or 21 samples 2.5 to 10 times too dark", 0.06, "of ln a");
  double worst_plain = 0;
  for (int i = 0; i < 100; ++i) {
    const Attenuation light = draw_light(random, 60, false);
    AttenuationTarget target{.samples = draw({light, 2, 60, 20 + i % 2, 0.01}, random), .is_robust = true};
    for (const std::size_t k : {4u, 9u, 15u}) target.samples[k].attenuation *= random.uniform(0.1, 0.4);
    const auto off = [&](const AttenuationFit& fit) {
      double largest = 0;
      for (double r = 2; r <= 60; r += 2) {
        largest = std::max(largest, std::abs(std::log(attenuation_at(fit.attenuation, r) / attenuation_at(light, r))));
      }
      return largest;
    };
    const AttenuationFit robust = fit_attenuation(target);
    robust_error.add(off(robust), [&] { return describe(target); });
    EXPECT_GT(robust.loss_scale, 0.005) << "1.345 standard deviations of the good samples, as they happen to be";
    EXPECT_LT(robust.loss_scale, 0.04);
    target.is_robust = false;
    worst_plain = std::max(worst_plain, off(fit_attenuation(target)));
  }
  robust_error.check();
  EXPECT_GT(worst_plain, 5 * robust_error.worst());
}

TEST(AttenuationFit, LossScaleIsThatOfTheLargerResidualsAboutTheLeastAbsoluteOnes) {
  for (const std::size_t count : {7u, 8u}) {
    AttenuationTarget target{.extent = 100, .constant = 1, .is_robust = true};
    for (std::size_t i = 1; i <= count; ++i) {
      const double range = 10. * double(i), off = 0.02 * (double(i * i * 5 % 17) - 8);
      target.samples.push_back({range, std::exp(off) / (1 + 0.02 * range + 0.0017 * range * range)});
    }
    double least = kInfinity;
    std::vector<double> amounts;
    for (double linear = 0; linear <= 0.19; linear += 1e-5) {  // L alone is free
      std::vector<double> each;
      double sum = 0;
      for (const auto& [range, attenuation, weight] : target.samples) {
        const double d = 1 + linear * range + (19 - 100 * linear) / 1e4 * range * range;
        sum += each.emplace_back(std::abs(std::log(d * attenuation)));
      }
      if (sum < least) {
        least = sum;
        amounts = each;
      }
    }
    std::sort(amounts.begin(), amounts.end());
    const double median = count == 7 ? (amounts[3] + amounts[4]) / 2 : amounts[4];  // of all but the smallest
    EXPECT_NEAR(fit_attenuation(target).loss_scale / (1.345 * 1.4826 * median), 1, 0.02) << count;
  }
  AttenuationTarget exact{.is_robust = true};
  for (const double range : {1., 2., 4., 5., 8.}) exact.samples.push_back({range, 1 / (1 + range + range * range)});
  EXPECT_EQ(fit_attenuation(exact).loss_scale, 1e-6);
}

TEST(AttenuationFit, CovarianceIsThatOfRepeatedTables) {
  Random random(11);
  const Attenuation light{1.5, 0.05, 0.003};
  constexpr int kTables = 4000;
  const double drawn[] = {light.constant, light.linear, light.quadratic};
  std::array<double, 9> product{}, reported{};
  for (int i = 0; i < kTables; ++i) {
    const AttenuationFit fit = fit_attenuation({.samples = draw({light, 1, 60, 15, 0.01}, random)});
    ASSERT_TRUE(fit.covariance);
    const double found[] = {fit.attenuation.constant, fit.attenuation.linear, fit.attenuation.quadratic};
    for (std::size_t j = 0; j < 9; ++j) {
      product[j] += (found[j / 3] - drawn[j / 3]) * (found[j % 3] - drawn[j % 3]) / kTables;
      reported[j] += (*fit.covariance)[j] / kTables;
    }
  }
  // Sampling error of a variance from 4000 tables: 2.2 %; of the mean of the reported, less.
  for (std::size_t j = 0; j < 9; ++j) EXPECT_NEAR(reported[j] / product[j], 1, 0.1) << j;
}

/// Derivative of the root of a robust loss of a residual z.
double root_slope(double z, double scale) {
  if (std::isinf(scale)) return 1;
  const auto root = [scale](double x) { return std::sqrt(2 * (std::hypot(1, x / scale) - 1)) * scale; };
  return (root(std::abs(z) * (1 + 1e-5)) - root(std::abs(z) * (1 - 1e-5))) / (2e-5 * std::abs(z));
}

TEST(AttenuationFit, CovarianceOfOneFreeCoefficientHasItsClosedForm) {
  // With Q = (19 - 100 L) / 100^2, ln D changes by (r - r^2 / 100) / D a unit of L.
  AttenuationTarget target{.extent = 100, .constant = 1};
  for (int i = 1; i <= 8; ++i) {
    const double range = 10 * i, d = 1 + 0.02 * range + 0.0017 * range * range;
    target.samples.push_back({range, (i % 2 == 0 ? 1.1 : 0.95) / d, double(i)});
  }
  for (const bool is_robust : {false, true}) {
    target.is_robust = is_robust;
    const AttenuationFit fit = fit_attenuation(target);
    EXPECT_GT(std::min(fit.attenuation.linear, fit.attenuation.quadratic), 0);
    double slopes = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      const auto& [range, attenuation, weight] = target.samples[i];
      const double slope = (range - range * range / 100) * attenuation_at(fit.attenuation, range);
      slopes += weight * std::pow(slope * root_slope(fit.residuals[i], fit.loss_scale), 2);
    }
    const double variance = fit.objective / 7 / slopes;
    const std::array<double, 9> expected{0, 0, 0, 0, variance, -variance / 100, 0, -variance / 100, variance / 1e4};
    ASSERT_TRUE(fit.covariance);
    for (std::size_t j = 0; j < 9; ++j) EXPECT_NEAR((*fit.covariance)[j], expected[j], 1e-8 * std::abs(expected[j]));
  }
}

TEST(AttenuationFit, CoefficientHeldAtZeroHasNoCovariance) {
  AttenuationTarget target{.constant = 1};
  double slopes = 0;
  for (int i = 1; i <= 8; ++i) {  // with a slope below 0 at the lamp, which L = 0 does not have
    const double range = 10 * i;
    target.samples.push_back({range, 1 / (1 - 0.02 * range + 0.0022 * range * range + (i == 1 ? 0.1 : 0))});
  }
  const AttenuationFit fit = fit_attenuation(target);
  EXPECT_EQ(fit.attenuation.linear, 0);
  for (const auto& [range, attenuation, weight] : target.samples) {
    slopes += std::pow(range * range * attenuation_at(fit.attenuation, range), 2);
  }
  const double variance = fit.objective / 7 / slopes;
  ASSERT_TRUE(fit.covariance);
  for (std::size_t j = 0; j < 8; ++j) EXPECT_EQ((*fit.covariance)[j], 0) << j;
  EXPECT_NEAR((*fit.covariance)[8], variance, 1e-10 * variance);
}

TEST(AttenuationFit, ConstantAtItsLargestIsHeld) {
  const AttenuationFit fit =
      fit_attenuation({.extent = 100, .samples = {{20, 0.04998}, {40, 0.04997}, {60, 0.04999}, {80, 0.04996}}});
  EXPECT_EQ(fit.status, AttenuationFitStatus::optimal);
  EXPECT_NEAR(fit.attenuation.constant, (1 - 0x1p-20) / 0.05, 1e-13);
  EXPECT_LT(fit.kkt_residual, 1e-15);
  ASSERT_TRUE(fit.covariance);
  for (const std::size_t j : {0u, 1u, 2u, 3u, 6u}) EXPECT_EQ((*fit.covariance)[j], 0) << j;
}

TEST(AttenuationFit, CovarianceIsAbsentWhereTheSamplesDoNotIdentifyTheCoefficients) {
  EXPECT_FALSE(fit_attenuation({.samples = {{1, 0.5}, {2, 0.3}}}).covariance) << "two samples, three coefficients";
  EXPECT_FALSE(fit_attenuation({.samples = {{1, 0.6}, {2, 0.45}, {4, 0.3}}}).covariance) << "no sample to spare";
  EXPECT_FALSE(fit_attenuation({.samples = {{1, 1}, {2, 1}, {3, 1}, {4, 1}}}).covariance) << "all clamped";
  EXPECT_FALSE(fit_attenuation({.samples = {{1, 1}, {2, 1}, {3, 0.5}, {4, 0.3}}}).covariance) << "half clamped";
  EXPECT_TRUE(fit_attenuation({.samples = {{1, 0.6}, {2, 0.45}, {4, 0.3}, {5, 0.2}}}).covariance);
}

TEST(AttenuationFit, ConstantOneIsPreferredAmongEqualOptima) {
  const AttenuationFit two = fit_attenuation({.samples = {{1, 0.5}, {2, 0.25}}});
  EXPECT_EQ(two.attenuation.constant, 1);
  EXPECT_LT(two.rms_error, 1e-15);
  EXPECT_EQ(fit_attenuation({.samples = {{1, 1}, {2, 1}, {3, 1}}}).attenuation, (Attenuation{1, 0, 0}));
  // A sample at the extent tells nothing. With C = 1, 50 L + 2500 Q = 5 and 100 L + 10000 Q = 19.
  const Attenuation at_extent = fit_attenuation({.extent = 100, .samples = {{50, 1 / 6.}, {100, 0.05}}}).attenuation;
  EXPECT_EQ(at_extent.constant, 1);
  EXPECT_NEAR(at_extent.linear, 0.01, 1e-12);
  EXPECT_NEAR(at_extent.quadratic, 0.0018, 1e-14);
  // None with C = 1 meets these.
  EXPECT_LT(fit_attenuation({.samples = {{1, 0.9}, {2, 0.3}}}).rms_error, 1e-15);
}

TEST(AttenuationFit, TableOfOnesIsMetByTheClamp) {
  const AttenuationFit fit = fit_attenuation({.constant = 0, .samples = {{1, 1}, {2, 1}}});
  EXPECT_FALSE(find_error(fit.attenuation));
  EXPECT_EQ(fit.objective, 0);
  EXPECT_EQ(fit_attenuation({.constant = 0, .samples = {{0, 1}, {7, 1}}}).attenuation, (Attenuation{0, 1 / 7., 0}));
}

TEST(AttenuationFit, InfeasibleConstantIsAnsweredWithThoseThatTheExtentLeaves) {
  const AttenuationFit fit = fit_attenuation({.extent = 100, .constant = 25});
  EXPECT_EQ(fit.status, AttenuationFitStatus::infeasible);
  EXPECT_TRUE(
      fit.sentence.starts_with("constant 25 cannot be reached with an extent of 100 m at threshold 0.05: from 0 to "
                               "19.99998"))
      << fit.sentence;
  EXPECT_NEAR(compute_extent(fit.attenuation, 0.05), 100, 1e-10) << "the nearest that has the extent";
}

TEST(AttenuationFit, InfeasibleConstantIsSaidOfATableToo) {
  const AttenuationFit fit = fit_attenuation({.extent = 100, .constant = 25, .samples = {{100, 0.05}}});
  EXPECT_EQ(fit.status, AttenuationFitStatus::infeasible);
  EXPECT_TRUE(fit.sentence.starts_with("constant 25 cannot be reached with an extent of 100 m")) << fit.sentence;
  const double largest = (1 - 0x1p-20) / 0.05;
  EXPECT_EQ(fit_attenuation({.extent = 100, .constant = largest}).status, AttenuationFitStatus::optimal);
}

TEST(AttenuationFit, DescentThatKeepsReleasingAZeroEnds) {  // found by fuzzing
  const AttenuationFit fit = fit_attenuation({.threshold = 7.3846346333570912e-23,
                                              .constant = 1.3241371730719977e-155,
                                              .samples = {{0, 0.050599792930055169, 3.4518041449244e+58},
                                                          {1.2589254117941714e-30, 0.1963171108719009, 7.2e-17},
                                                          {3.9826937178995515e-30, 1, 4.4312112616156167e-11},
                                                          {1.1797509749272338e-14, 1, 1.162283048636004e+39},
                                                          {3.5210076723444488e-08, 0.028856595538672095, 8.2e+68},
                                                          {0.00028712556965185515, 0.088078308975014646, 2.3e-07}}});
  EXPECT_EQ(fit.status, AttenuationFitStatus::infeasible);
  EXPECT_TRUE(fit.sentence.starts_with("attenuation 0.0505998 at 0 m cannot be reached")) << fit.sentence;
}

TEST(AttenuationFit, InfeasibleSampleIsAnsweredWithTheRangesThatReachIt) {
  const auto sentence = [](const AttenuationTarget& target) {
    const AttenuationFit fit = fit_attenuation(target);
    return fit.status == AttenuationFitStatus::infeasible ? fit.sentence : "feasible: " + fit.sentence;
  };
  EXPECT_EQ(sentence({.extent = 100, .samples = {{40, 0.5}}}),
            "attenuation 0.5 at 40 m cannot be reached with an extent of 100 m: between 0 and 31.62 m can");
  EXPECT_EQ(sentence({.extent = 100, .samples = {{40, 0.4}}}),
            "attenuation 0.4 at 40 m cannot be reached with an extent of 100 m: between 0 and 35.35 m can");
  EXPECT_EQ(
      sentence({.extent = 100, .constant = 1, .samples = {{40, 0.5}}}),
      "attenuation 0.5 at 40 m cannot be reached with an extent of 100 m and constant 1: between 5.264 and 22.94 m "
      "can");
  EXPECT_EQ(
      sentence({.extent = 100, .constant = 1, .samples = {{4, 0.5}}}),
      "attenuation 0.5 at 4 m cannot be reached with an extent of 100 m and constant 1: between 5.264 and 22.94 m "
      "can");
  EXPECT_EQ(sentence({.extent = 100, .samples = {{120, 0.01}}}),
            "attenuation 0.01 at 120 m cannot be reached with an extent of 100 m: from 223.7 m on can");
  EXPECT_EQ(sentence({.extent = 100, .constant = 1, .samples = {{90, 0.05}}}),
            "attenuation 0.05 at 90 m cannot be reached with an extent of 100 m and constant 1: only 100 m can");
  EXPECT_EQ(sentence({.extent = 100, .constant = 4, .samples = {{10, 0.5}}}),
            "attenuation 0.5 cannot be reached with constant 4: at most 0.25 can");
  EXPECT_EQ(sentence({.constant = 4, .samples = {{10, 0.5}, {20, 0.1}}}),
            "attenuation 0.5 cannot be reached with constant 4: at most 0.25 can");
  EXPECT_EQ(sentence({.constant = 2, .samples = {{0, 0.25}, {20, 0.1}}}),
            "attenuation 0.25 at 0 m cannot be reached with constant 2: 0.5 can");
  EXPECT_EQ(sentence({.constant = 0.5, .samples = {{0, 0.25}, {20, 0.1}}}),
            "attenuation 0.25 at 0 m cannot be reached with constant 0.5: 1 can");
  EXPECT_EQ(sentence({.extent = 100, .constant = 0.5, .samples = {{40, 1}}}),
            "attenuation 1 at 40 m cannot be reached with an extent of 100 m and constant 0.5: between 0 and 16.01 m "
            "can");
  EXPECT_EQ(sentence({.extent = 100, .constant = 4, .samples = {{40, 0.25}}}),
            "attenuation 0.25 at 40 m cannot be reached with an extent of 100 m and constant 4: only 0 m can");
  EXPECT_EQ(sentence({.extent = 100, .samples = {{10, 0.9}, {40, 0.5}}}),
            "attenuation 0.5 at 40 m cannot be reached with an extent of 100 m: between 0 and 31.62 m can");
  EXPECT_TRUE(sentence({.extent = 100, .samples = {{30, 0.5}}}).starts_with("feasible: "));
  EXPECT_TRUE(sentence({.extent = 100, .constant = 0.5, .samples = {{1, 1}}}).starts_with("feasible: ")) << "clamped";
  EXPECT_TRUE(sentence({.extent = 100, .samples = {{30, 0.5}, {60, 0.9, 0}}}).starts_with("feasible: ")) << "left out";
}

TEST(AttenuationFit, SampleOutOfReachByATenthOfAPercentIsNoContradiction) {
  const auto status = [](double factor) {  // 0.2 is the most at half the extent
    return fit_attenuation({.extent = 100, .samples = {{50, 0.2 * factor}}}).status;
  };
  EXPECT_EQ(status(1.0008), AttenuationFitStatus::optimal);
  EXPECT_EQ(status(1.0012), AttenuationFitStatus::infeasible);
}

TEST(AttenuationFit, InfeasibleSentenceHasNoDigitsOfRounding) {
  const auto sentence = [](const AttenuationTarget& target) { return fit_attenuation(target).sentence; };
  const double derived = std::sqrt(12345.678);  // an extent of an illuminance
  EXPECT_EQ(sentence({.extent = derived, .constant = 20.1}),
            "constant 20.1 cannot be reached with an extent of 111.111 m at threshold 0.05: from 0 to 19.99998 can");
  EXPECT_EQ(sentence({.threshold = 0.07, .extent = 450.125, .constant = 14.3}),
            "constant 14.3 cannot be reached with an extent of 450.125 m at threshold 0.07: from 0 to 14.2857 can");
  EXPECT_EQ(sentence({.extent = 200000, .constant = 0.1 + 0.2, .samples = {{300000, 0.5}}}),
            "attenuation 0.5 at 300000 m cannot be reached with an extent of 200000 m and constant 0.3: between "
            "17260 and 58750 m can");
  EXPECT_EQ(sentence({.constant = 3, .samples = {{0, 0.25}, {20, 0.1}}}),
            "attenuation 0.25 at 0 m cannot be reached with constant 3: 0.333333 can");
  EXPECT_EQ(sentence({.extent = 0.1 + 0.2, .constant = 1, .samples = {{0.2, 0.05}}}),
            "attenuation 0.05 at 0.2 m cannot be reached with an extent of 0.3 m and constant 1: only 0.3 m can");
}

TEST(AttenuationFit, InfeasibleTableIsAnsweredInASentence) {
  AttenuationTarget target{.extent = 100};
  for (int range = 1; range < 100; ++range) target.samples.push_back({double(range), 1 / (1 + 1e-4 * range * range)});
  const AttenuationFit fit = fit_attenuation(target);
  EXPECT_EQ(fit.status, AttenuationFitStatus::infeasible);
  EXPECT_EQ(std::ranges::count(fit.sentence, ';'), 3) << fit.sentence;
  EXPECT_TRUE(fit.sentence.ends_with("; 74 more of the 99 samples cannot be reached")) << "those from 23 m on";
  for (const char* farthest : {" at 97 m cannot", " at 98 m cannot", " at 99 m cannot"}) {
    EXPECT_NE(fit.sentence.find(farthest), std::string::npos) << fit.sentence;
  }
}

// Tables of D = 20 (r / 100 m)^2, the brightest that the extent leaves, and brighter. Their errors against the best
// attenuation without an extent are their scatter.
TEST(AttenuationFit, SampleOutOfReachByThreeTimesTheScatterIsNoContradiction) {
  const auto status = [](int count, const auto& log_error) {
    AttenuationTarget target{.extent = 100};
    for (int i = 0; i < count; ++i) {
      const double x = 0.3 + 0.6 * i / (count - 1);
      target.samples.push_back({100 * x, std::exp(log_error(i)) / (20 * x * x)});
    }
    return fit_attenuation(target).status;
  };
  const auto brighter = [](double bias) { return [bias](int i) { return bias + (i % 2 == 0 ? 0.01 : -0.01); }; };
  EXPECT_EQ(status(12, brighter(0.022)), AttenuationFitStatus::optimal);
  EXPECT_EQ(status(12, brighter(0.03)), AttenuationFitStatus::infeasible) << "four times";
  const auto one_brighter = [](int i) { return i == 10 ? 0.2 : 0; };
  EXPECT_EQ(status(40, one_brighter), AttenuationFitStatus::optimal) << "by less than three times its own error";
}

TEST(AttenuationFit, InfeasibleTargetHasItsBestFit) {
  const AttenuationFit fit = fit_attenuation({.extent = 100, .samples = {{40, 0.5}}});
  EXPECT_NEAR(fit.attenuation.quadratic, 20e-4, 1e-17) << "Q alone is brightest";
  EXPECT_EQ(fit.attenuation.constant, 0);
  EXPECT_EQ(fit.attenuation.linear, 0);
  EXPECT_NEAR(fit.residuals[0], std::log(1 / 3.2 / 0.5), 1e-14);
}

TEST(AttenuationFit, PointIsMetWithinTheStatedRangesAndNotOutside) {
  Random random(12);
  int tried = 0;
  while (tried < 300) {
    AttenuationTarget target{.threshold = random.log_uniform(0.01, 0.3), .extent = random.log_uniform(1, 1000)};
    if (random.chance(0.5)) target.constant = random.uniform(0, 0.9) / target.threshold;
    const double attenuation = random.chance(0.2) ? random.uniform(0.001, 0.3) : random.uniform(target.threshold, 1);
    target.samples = {{*target.extent * random.log_uniform(0.01, 10), attenuation}};
    const std::string sentence = fit_attenuation(target).sentence;
    const auto between = sentence.find(": between ");
    if (between == std::string::npos) continue;
    ++tried;
    double low = 0, high = 0;
    ASSERT_EQ(std::sscanf(sentence.c_str() + between, ": between %lf and %lf m can", &low, &high), 2) << sentence;
    for (const double range : {low, high, low + random.uniform(0, 1) * (high - low)}) {
      target.samples[0].range = range;
      EXPECT_LT(fit_attenuation(target).rms_error, 1e-9) << sentence << ", but not " << range;
    }
    target.samples[0].range = high * 1.01;
    EXPECT_GT(fit_attenuation(target).rms_error, 1e-7) << sentence << ", but 1 % beyond as well";
    target.samples[0].range = low * 0.99;
    if (low > 0) {
      EXPECT_GT(fit_attenuation(target).rms_error, 1e-7) << sentence << ", but 1 % before as well";
    }
  }
}

TEST(AttenuationTarget, LimitsMayBeExceededByTheRoundingOfFloats) {
  const auto error = [](const AttenuationTarget& target) { return error_of([&] { fit_attenuation(target); }); };
  constexpr double kAbove = 1 + 5e-8, kBelow = 1 - 5e-8;
  EXPECT_EQ(error({.threshold = 1e-100 * kBelow, .extent = 1e30 * kAbove}), "no error");
  EXPECT_EQ(error({.extent = 1, .constant = 1e100 * kAbove}), "no error");
  EXPECT_EQ(error({.samples = {{1, kAbove}, {1e30 * kAbove, 1e-100 * kBelow, 1e100 * kAbove}}}), "no error");
  EXPECT_EQ(fit_attenuation({.samples = {{1, kAbove}, {2, kAbove}}}).rms_error, 0) << "counts as 1";
  const Attenuation farthest = fit_attenuation({.extent = 1e30 * kAbove}).attenuation;
  EXPECT_NEAR(compute_extent(farthest, kDefaultThreshold) / 1e30, 1, 1e-12) << "counts as 1e30";
}

TEST(AttenuationTarget, ErrorNamesSampleFieldValueAndRule) {
  const auto error = [](const AttenuationTarget& target) { return error_of([&] { fit_attenuation(target); }); };
  const auto table = [&](AttenuationSample third) { return error({.samples = {{1, 0.9}, {2, 0.5}, third}}); };
  EXPECT_EQ(table({3, 0}), "samples[2].attenuation = 0: must be in [1e-100, 1]");
  EXPECT_EQ(table({3, -0.5}), "samples[2].attenuation = -0.5: must be in [1e-100, 1]");
  EXPECT_EQ(table({3, 1.5}), "samples[2].attenuation = 1.5: must be in [1e-100, 1]");
  EXPECT_EQ(table({3, kNan}), "samples[2].attenuation = nan: must be in [1e-100, 1]");
  EXPECT_EQ(table({2, 0.4}), "samples[2].range = 2: must be greater than the range before it");
  EXPECT_EQ(table({1.5, 0.4}), "samples[2].range = 1.5: must be greater than the range before it");
  EXPECT_EQ(table({-1, 0.4}), "samples[2].range = -1: must be 0, or in [1e-30, 1e30]");
  EXPECT_EQ(table({kInfinity, 0.4}), "samples[2].range = inf: must be 0, or in [1e-30, 1e30]");
  EXPECT_EQ(table({kNan, 0.4}), "samples[2].range = nan: must be 0, or in [1e-30, 1e30]");
  EXPECT_EQ(table({3, 0.4, -1}), "samples[2].weight = -1: must be 0, or in [1e-100, 1e100]");
  EXPECT_EQ(table({3, 0.4, kNan}), "samples[2].weight = nan: must be 0, or in [1e-100, 1e100]");
  EXPECT_EQ(error({.threshold = 0, .extent = 1}), "threshold = 0: must be in [1e-100, 1)");
  EXPECT_EQ(error({.threshold = 1, .extent = 1}), "threshold = 1: must be in [1e-100, 1)");
  EXPECT_EQ(error({.threshold = kNan, .extent = 1}), "threshold = nan: must be in [1e-100, 1)");
  EXPECT_EQ(error({.extent = 0}), "extent = 0: must be in [1e-30, 1e30]");
  EXPECT_EQ(error({.extent = kInfinity}), "extent = inf: must be in [1e-30, 1e30]");
  EXPECT_EQ(error({.extent = 1, .constant = -1}), "constant = -1: must be in [0, 1e100]");
  EXPECT_EQ(error({}), "samples = 0: must be two or more of weight > 0 where there is no extent");
  EXPECT_EQ(error({.samples = {{1, 0.5}}}), "samples = 1: must be two or more of weight > 0 where there is no extent");
  EXPECT_EQ(error({.samples = {{1, 0.5}, {2, 0.3, 0}}}),
            "samples = 1: must be two or more of weight > 0 where there is no extent");
  EXPECT_EQ(error({.extent = 1, .samples = {{1, 0.5, 0}}}),
            "samples = 0: must be one or more of weight > 0 where there are any");
  const auto found = find_error(AttenuationTarget{.samples = {{1, 0.9}, {2, 0}}});
  ASSERT_TRUE(found && found->sample);
  EXPECT_EQ(*found->sample, 1u);
}

}  // namespace
}  // namespace litfog::test
