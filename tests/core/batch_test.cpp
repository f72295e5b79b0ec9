// SPDX-License-Identifier: Apache-2.0
#include "litfog/batch.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "core/simd_targets.h"
#include "litfog/solve.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"
#include "reference/reference_solver.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

/// Lights in columns, and the results of a batch over them.
template <typename T>
struct Columns {
  std::vector<T> constant, linear, quadratic, threshold, density;
  std::vector<T> intensity, peak_range, extent;
  std::vector<BatchStatus> status;
  std::size_t invalid = 0;

  void add(double c, double l, double q, double t, double d) {
    constant.push_back(T(c));
    linear.push_back(T(l));
    quadratic.push_back(T(q));
    threshold.push_back(T(t));
    density.push_back(T(d));
  }
  std::size_t size() const { return constant.size(); }
  BasicBatchLights<T> lights() const { return {constant, linear, quadratic, threshold, density}; }
  void solve(FogMode mode) {
    for (auto* column : {&intensity, &peak_range, &extent}) column->assign(size(), T(-1));
    status.assign(size(), BatchStatus::not_converged);
    invalid = solve_fog_intensities(
        mode, lights(), {.intensity = intensity, .peak_range = peak_range, .extent = extent, .status = status});
  }
  /// The scalar solution of a light, in double: at most 2 ulp of double from the truth (solve_test.cpp).
  FogIntensity scalar(FogMode mode, std::size_t i) const {
    return solve_fog_intensity(Attenuation{double(constant[i]), double(linear[i]), double(quadratic[i])},
                               Fog{mode, double(density[i])}, double(threshold[i]));
  }
  std::string describe(std::size_t i) const {
    char text[200];
    std::snprintf(text, sizeof text, "C %.9g L %.9g Q %.9g t %.9g d %.9g", double(constant[i]), double(linear[i]),
                  double(quadratic[i]), double(threshold[i]), double(density[i]));
    return text;
  }
};

constexpr std::uint64_t kSeed = 20261121;

/// Ordinary lights: extent 5 to 5000 m, visibility 50 m to 10 km; C below, at and above 1 and 0; each family.
template <typename T>
Columns<T> ordinary_lights(std::size_t count) {
  Columns<T> columns;
  Random random(kSeed);
  for (std::size_t i = 0; i < count; ++i) {
    const int kind = random.below(10);
    const double c = kind == 0 ? 0 : kind < 4 ? random.log_uniform(1e-4, 1) : kind < 7 ? 1 : random.log_uniform(1, 15);
    const double t = random.below(3) ? 0.05 : random.log_uniform(0.001, 0.06);
    const double excess = std::max(1 / t - c, 0.01);
    const double e = random.log_uniform(5, 5000);
    const double mix = random.pick(std::array{0.0, 1.0, random.uniform(0, 1), random.log_uniform(1e-6, 1)});
    columns.add(c, mix * excess / e, (1 - mix) * excess / (e * e), t, 3 / random.log_uniform(50, 10'000));
  }
  return columns;
}

/// Lights over a wide range of exponents, beyond what the vector arithmetic takes.
template <typename T>
Columns<T> wide_lights(std::size_t count) {
  Columns<T> columns;
  Random random(kSeed);
  for (std::size_t i = 0; i < count; ++i) {
    const auto coefficient = [&] { return random.below(5) ? random.log_uniform(1e-18, 1e18) : 0.0; };
    const double c = random.below(4) ? random.log_uniform(1e-9, 1e3) : coefficient();
    columns.add(c, coefficient(), coefficient(), random.log_uniform(1e-9, 0.999), random.log_uniform(1e-12, 1e12));
    if (columns.constant.back() + columns.linear.back() + columns.quadratic.back() == 0) columns.constant.back() = 1;
  }
  return columns;
}

/// Holds a batch to its bounds against the scalar solution, which may itself err by 2 ulp of double.
template <typename T>
void expect_accurate(const std::string& name, Columns<T> columns) {
  for (const FogMode mode : kModes) {
    columns.solve(mode);
    EXPECT_EQ(columns.invalid, 0u);
    const std::string range = name + ", " + (sizeof(T) == 4 ? "float, " : "double, ") + name_of(mode);
    WorstError intensity("batch intensity", range, kBatchIntensityMaxUlp);
    WorstError extent("batch extent", range, 1);  // the same formula: nearer to the scalar's than to the truth
    WorstError peak_range("batch peak_range", range, kBatchPeakRangeMaxError<T>, "relative");
    for (std::size_t i = 0; i < columns.size(); ++i) {
      ASSERT_EQ(columns.status[i], BatchStatus::ok) << columns.describe(i);
      const FogIntensity truth = columns.scalar(mode, i);
      const auto text = [&] { return columns.describe(i); };
      intensity.add(ulp_error(columns.intensity[i], truth.intensity), text);
      extent.add(ulp_error(columns.extent[i], truth.extent), text);
      peak_range.add(relative_error(columns.peak_range[i], double(T(truth.peak_range))), text);
    }
    intensity.check();
    extent.check();
    peak_range.check();
  }
}

/// Runs a test on every SIMD target that this processor has.
class Batch : public testing::Test {
 protected:
  template <typename Check>
  void on_every_target(const Check& check) {
    for_each_simd_target([&](const char* target) {
      std::printf("%s\n", target);
      check();
    });
  }
};

TEST_F(Batch, FloatIsExactToTwoUlpOverOrdinaryLights) {
  on_every_target([] { expect_accurate("ordinary", ordinary_lights<float>(100'003)); });
}

TEST_F(Batch, DoubleIsNearTheScalarSolutionOverOrdinaryLights) {
  // Each may be 2 ulp from the truth. EveryTargetHoldsItsBoundAgainstFiftyDigits is the test of the bound.
  on_every_target([] { expect_accurate("ordinary", ordinary_lights<double>(100'003)); });
}

TEST_F(Batch, WideRangesAreAsExact) {
  on_every_target([] {
    expect_accurate("wide", wide_lights<float>(20'001));
    expect_accurate("wide", wide_lights<double>(20'001));
  });
}

/// Lights whose constant term is nearly 1 / threshold, half of them but for a rounding.
template <typename T>
Columns<T> barely_lit_lights() {
  Columns<T> columns;
  Random random(kSeed);
  while (columns.size() < 1001) {
    const T threshold = T(random.chance(0.5) ? random.log_uniform(1e-3, 0.9) : 1.0 / (2 + random.below(1000)));
    const T constant = T((random.chance(0.5) ? 1 : 1 - random.log_uniform(1e-18, 0.03)) / threshold);
    if (!(threshold < 1) || std::fma(double(constant), double(threshold), -1.0) >= 0) continue;
    columns.add(constant, random.log_uniform(1e-3, 1), random.log_uniform(1e-3, 1), threshold,
                random.log_uniform(0.01, 1));
  }
  return columns;
}

TEST_F(Batch, LightBarelyAboveItsThresholdIsNotDark) {
  on_every_target([] {
    expect_accurate("barely lit", barely_lit_lights<float>());
    expect_accurate("barely lit", barely_lit_lights<double>());
  });
}

// In clear air and in total fog there is no peak to find, but an extent.
TEST_F(Batch, ExtentOfALightBarelyAboveItsThresholdIsWithinItsBound) {
  Columns<float> columns = barely_lit_lights<float>();
  Random random(kSeed);
  while (columns.size() < 20'001) {
    const float threshold = float(1 - random.log_uniform(6e-8, 0.999));
    const float constant = float((1 - random.log_uniform(1e-15, 0.5)) / double(threshold));
    if (!(threshold < 1) || double(constant) * double(threshold) >= 1) continue;
    columns.add(double(constant), random.log_uniform(1e-8, 10), random.chance(0.3) ? 0 : random.log_uniform(1e-8, 10),
                double(threshold), random.pick(std::array{0.0, 1.0, kInfinity}));
  }
  on_every_target([&] {
    WorstError error("batch extent", "barely above the threshold", kBatchExtentMaxUlp<float>);
    columns.solve(FogMode::exp);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      error.add(ulp_error(columns.extent[i], columns.scalar(FogMode::exp, i).extent),
                [&] { return columns.describe(i); });
    }
    error.check();
  });
}

/// Lights whose constant is 1 but for a rounding, and lights that end next to their knee. Their stationary points are
/// near the knee.
template <typename T>
Columns<T> lights_next_to_one() {
  Columns<T> columns;
  Random random(kSeed);
  while (columns.size() < 20'001) {
    const bool ends_at_knee = random.chance(0.5);
    const double constant =
        ends_at_knee ? 0.5 : 1 - double(1 + random.below(8)) * double(std::numeric_limits<T>::epsilon()) / 2;
    const double threshold = ends_at_knee ? 1 - random.log_uniform(1e-7, 0.1) : 0.05;
    const double linear = random.chance(0.2) ? 0 : random.log_uniform(1e-6, 1);
    const double quadratic = linear > 0 && random.chance(0.5) ? 0 : random.log_uniform(1e-9, 1);
    const double knee = compute_knee({constant, linear, quadratic});
    columns.add(constant, linear, quadratic, threshold, random.log_uniform(0.5, 20) / knee);
  }
  return columns;
}

TEST_F(Batch, LightThatIsNextToOneAtItsConstantOrItsThresholdIsAsExact) {
  on_every_target([] {
    expect_accurate("next to 1", lights_next_to_one<float>());
    expect_accurate("next to 1", lights_next_to_one<double>());
  });
}

/// Ordinary lights in one fog mode with their solutions, rounded to float so that both precisions take the same.
struct ReferenceLights {
  Columns<float> columns;
  std::vector<ReferencePeak> peaks;

  ReferenceLights(FogMode mode, int count) {
    Random random(mode == FogMode::exp ? 7 : 8);
    for (int i = 0; i < count; ++i) {
      const auto& [attenuation, fog, threshold] = draw_ordinary_case(random, mode);
      columns.add(attenuation.constant, attenuation.linear, attenuation.quadratic, threshold, fog.density);
      peaks.push_back(solve_reference({columns.constant.back(), columns.linear.back(), columns.quadratic.back()},
                                      {mode, columns.density.back()}, columns.threshold.back()));
    }
  }
};

TEST_F(Batch, EveryTargetHoldsItsBoundAgainstFiftyDigits) {
  for (const FogMode mode : kModes) {
    const ReferenceLights lights(mode, scaled_count(4'003));
    on_every_target([&] {
      const std::string fog = std::string(name_of(mode)) + " fog";
      const auto expect_near_reference = [&]<typename T>(Columns<T> columns, const char* precision) {
        columns.solve(mode);
        const std::string range = std::string("ordinary lights, ") + precision + ", " + fog;
        WorstError intensity("batch intensity", range, kBatchIntensityMaxUlp);
        WorstError extent("batch extent", range, kBatchExtentMaxUlp<T>);
        WorstError peak_range("batch peak_range", range, kBatchPeakRangeMaxError<T>, "relative");
        for (std::size_t i = 0; i < columns.size(); ++i) {
          const auto text = [&] { return columns.describe(i); };
          intensity.add(ulp_error(columns.intensity[i], lights.peaks[i].intensity), text);
          extent.add(ulp_error(columns.extent[i], lights.peaks[i].extent), text);
          peak_range.add(relative_error(columns.peak_range[i], lights.peaks[i].peak_range), text);
        }
        intensity.check();
        extent.check();
        peak_range.check();
      };
      expect_near_reference(lights.columns, "float");
      Columns<double> in_double;
      for (std::size_t i = 0; i < lights.columns.size(); ++i) {
        in_double.add(lights.columns.constant[i], lights.columns.linear[i], lights.columns.quadratic[i],
                      lights.columns.threshold[i], lights.columns.density[i]);
      }
      expect_near_reference(in_double, "double");
    });
  }
}

template <typename T>
void expect_position_does_not_matter() {
  const Columns<T> all = ordinary_lights<T>(67);
  Columns<T> whole = all;
  whole.solve(FogMode::exp);
  for (std::size_t count = 0; count <= all.size(); ++count) {
    Columns<T> part;
    for (std::size_t i = all.size() - count; i < all.size(); ++i) {
      part.add(all.constant[i], all.linear[i], all.quadratic[i], all.threshold[i], all.density[i]);
    }
    part.solve(FogMode::exp);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t same = all.size() - count + i;
      ASSERT_EQ(part.intensity[i], whole.intensity[same]) << count << " lights, light " << i;
      ASSERT_EQ(part.peak_range[i], whole.peak_range[same]);
      ASSERT_EQ(part.extent[i], whole.extent[same]);
    }
  }
}

TEST_F(Batch, LightsResultDependsNeitherOnItsPositionNorOnTheLength) {
  on_every_target([] {
    expect_position_does_not_matter<float>();
    expect_position_does_not_matter<double>();
  });
}

TEST_F(Batch, SingleThresholdOrDensityServesAllLights) {
  Columns<double> columns = ordinary_lights<double>(37);
  columns.threshold.assign(37, 0.05);
  columns.density.assign(37, 0.01);
  columns.solve(FogMode::exp2);
  const std::vector<double> before = columns.intensity;
  columns.threshold.resize(1);
  columns.density.resize(1);
  solve_fog_intensities(FogMode::exp2, columns.lights(), {.intensity = columns.intensity});
  EXPECT_EQ(columns.intensity, before);
}

template <typename T>
void expect_special_values_as_scalar() {
  using Limits = std::numeric_limits<T>;
  const std::vector<T> values{T(0),
                              T(-0.0),
                              Limits::denorm_min(),
                              T(1e-12),
                              T(0.03),
                              T(1),
                              Limits::max(),
                              Limits::infinity(),
                              Limits::quiet_NaN(),
                              T(-1)};
  Columns<T> columns;
  for (const T c : values) {
    for (const T l : values) {
      for (const T q : values) {
        for (const T d : values) {
          for (const T t : {T(0), T(0.05), T(0.9), T(1), Limits::quiet_NaN(), Limits::denorm_min()}) {
            columns.add(double(c), double(l), double(q), double(t), double(d));
          }
        }
      }
    }
  }
  for (const FogMode mode : kModes) {
    columns.solve(mode);
    std::size_t invalid = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const bool is_bad = find_error(Attenuation{double(columns.constant[i]), double(columns.linear[i]),
                                                 double(columns.quadratic[i])}) ||
                          find_error(Fog{mode, double(columns.density[i])}) ||
                          find_threshold_error(double(columns.threshold[i]));
      ASSERT_EQ(columns.status[i], is_bad ? BatchStatus::invalid : BatchStatus::ok) << columns.describe(i);
      invalid += is_bad;
      const FogIntensity truth = is_bad ? FogIntensity{0, 0, 0, SolveStatus::ok} : columns.scalar(mode, i);
      ASSERT_LE(ulp_error(columns.intensity[i], truth.intensity), kBatchIntensityMaxUlp) << columns.describe(i);
      ASSERT_LE(ulp_error(columns.extent[i], truth.extent), kBatchExtentMaxUlp<T>) << columns.describe(i);
      ASSERT_LE(relative_error(columns.peak_range[i], double(T(truth.peak_range))), kBatchPeakRangeMaxError<T>)
          << columns.describe(i);
    }
    EXPECT_EQ(columns.invalid, invalid);
  }
}

TEST_F(Batch, SpecialValuesGiveTheScalarResultOrAreInvalid) {
  on_every_target([] {
    expect_special_values_as_scalar<float>();
    expect_special_values_as_scalar<double>();
  });
}

template <typename T>
void expect_negative_zero_as_zero() {
  Columns<T> zeros;
  Columns<T> negative_zeros;
  const auto negated = [](double x) { return x == 0 ? -0.0 : x; };
  for (const double c : {0.0, 0.4, 1.0, 3.0}) {
    for (const double l : {0.0, 0.01, 0.3}) {
      for (const double q : {0.0, 1e-5, 0.02}) {
        for (const double d : {0.0, 1e-4, 0.02, 1.0}) {
          if (c + l + q == 0) continue;
          zeros.add(c, l, q, 0.05, d);
          negative_zeros.add(negated(c), negated(l), negated(q), 0.05, negated(d));
        }
      }
    }
  }
  for (const FogMode mode : kModes) {
    zeros.solve(mode);
    negative_zeros.solve(mode);
    EXPECT_EQ(negative_zeros.intensity, zeros.intensity);
    EXPECT_EQ(negative_zeros.peak_range, zeros.peak_range);
    EXPECT_EQ(negative_zeros.extent, zeros.extent);
    EXPECT_EQ(negative_zeros.status, zeros.status);
  }
}

TEST_F(Batch, NegativeZeroIsZero) {
  on_every_target([] {
    expect_negative_zero_as_zero<float>();
    expect_negative_zero_as_zero<double>();
  });
}

// Degenerate lanes among ordinary ones: each lane has a kind of its own, so that a slip across lanes shows.
TEST_F(Batch, LimitCasesStandBesideOrdinaryLights) {
  Columns<float> columns;
  for (int round = 0; round < 11; ++round) {
    columns.add(1, 0.01, 0.001, 0.05, 0.01);
    columns.add(30, 0.01, 0.001, 0.05, 0.01);        // extent 0
    columns.add(2, 0, 0, 0.05, 0.01);                // constant
    columns.add(0.5, 0.01, 0.001, 0.05, 0);          // clear air
    columns.add(0.5, 0.01, 0.001, 0.05, kInfinity);  // total fog
    columns.add(0, 1, 0, 0.05, 0.02);                // inverse linear, peak at the knee for exp
    columns.add(1, 0, 0.0019, 0.05, 1e-5);           // thin fog
  }
  for (const FogMode mode : kModes) {
    columns.solve(mode);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const FogIntensity truth = columns.scalar(mode, i);
      EXPECT_LE(ulp_error(columns.intensity[i], truth.intensity), kBatchIntensityMaxUlp) << columns.describe(i);
      EXPECT_LE(ulp_error(columns.extent[i], truth.extent), kBatchExtentMaxUlp<float>) << columns.describe(i);
      EXPECT_LE(relative_error(columns.peak_range[i], truth.peak_range), kBatchPeakRangeMaxError<float>)
          << columns.describe(i);
    }
  }
}

TEST_F(Batch, ThreadsMayShareTheCallAndItsColumns) {
  const Columns<float> shared = ordinary_lights<float>(5'000);
  Columns<float> expected = shared;
  expected.solve(FogMode::exp);
  std::vector<std::vector<float>> results(4, std::vector<float>(shared.size()));
  std::vector<std::thread> threads;
  for (auto& result : results) {
    threads.emplace_back([&] { solve_fog_intensities(FogMode::exp, shared.lights(), {.intensity = result}); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& result : results) EXPECT_EQ(result, expected.intensity);
}

}  // namespace
}  // namespace litfog::test
