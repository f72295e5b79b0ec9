// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "litfog/batch.h"
#include "litfog/solve.h"
#include "litfog/updater.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"

// A host may run with any rounding mode, and engines often flush subnormals to zero. The stated errors are those of the
// default mode; in others nothing may turn into NaN, leave its range or go far astray.

namespace litfog::test {
namespace {

/// The floating-point environment of a test, put back at its end.
class FloatingPointMode : public testing::Test {
 protected:
  FloatingPointMode() { std::fegetenv(&before_); }
  ~FloatingPointMode() override { std::fesetenv(&before_); }
  void back_to_default() { std::fesetenv(&before_); }

 private:
  std::fenv_t before_;
};

constexpr double kFar = 1e-14;        // relative, double: 45 ulp
constexpr double kFarInFloat = 2e-6;  // 17 ulp

std::vector<SolveCase> random_cases(std::size_t count) {
  std::vector<SolveCase> cases;
  Random random(3);
  while (cases.size() < count) {
    const auto coefficient = [&] { return random.chance(0.25) ? 0 : random.log_uniform(1e-8, 1e2); };
    const SolveCase c{{random.chance(1 / 3.) ? 1 : coefficient(), coefficient(), coefficient()},
                      {random.pick(kModes), random.log_uniform(1e-5, 10)},
                      random.log_uniform(1e-4, 0.5)};
    if (!find_error(c.attenuation)) cases.push_back(c);
  }
  return cases;
}

bool is_near(double value, double usual, double far) {
  return value == usual || std::abs(value - usual) <= far * usual;  // false for NaN
}

/// Solves the cases in the mode that `enter` sets, alone and as batches, and compares with the default mode.
template <typename Enter, typename Leave>
void expect_near_the_usual(const Enter& enter, const Leave& leave) {
  const std::vector<SolveCase> cases = random_cases(20'000);
  std::vector<FogIntensity> usual;
  for (const SolveCase& c : cases) usual.push_back(solve_fog_intensity(c.attenuation, c.fog, c.threshold));
  std::vector<FogIntensity> alone;
  enter();
  for (const SolveCase& c : cases) alone.push_back(solve_fog_intensity(c.attenuation, c.fog, c.threshold));
  leave();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    ASSERT_EQ(alone[i].status, SolveStatus::ok) << i;
    ASSERT_TRUE(is_near(alone[i].intensity, usual[i].intensity, kFar)) << i << ": " << alone[i].intensity;
    ASSERT_TRUE(is_near(alone[i].extent, usual[i].extent, kFar)) << i << ": " << alone[i].extent;
    ASSERT_TRUE(is_near(alone[i].peak_range, usual[i].peak_range, 1e-7)) << i << ": " << alone[i].peak_range;
    ASSERT_LE(alone[i].intensity, 1);
  }
  const auto expect_batch_near = [&]<typename T>(T, double far) {
    for (const FogMode mode : kModes) {
      std::vector<T> columns[5];
      std::vector<std::size_t> positions;
      for (std::size_t i = 0; i < cases.size(); ++i) {
        if (cases[i].fog.mode != mode) continue;
        positions.push_back(i);
        const auto& [constant, linear, quadratic] = cases[i].attenuation;
        const double values[] = {constant, linear, quadratic, cases[i].threshold, cases[i].fog.density};
        for (int k = 0; k < 5; ++k) columns[k].push_back(T(values[k]));
      }
      std::vector<T> intensity(positions.size());
      enter();
      const std::size_t invalid =
          solve_fog_intensities(mode, BasicBatchLights<T>{columns[0], columns[1], columns[2], columns[3], columns[4]},
                                BasicBatchSolutions<T>{.intensity = intensity});
      leave();
      EXPECT_EQ(invalid, 0u);
      for (std::size_t k = 0; k < positions.size(); ++k) {
        const double truth =
            solve_fog_intensity(Attenuation{double(columns[0][k]), double(columns[1][k]), double(columns[2][k])},
                                Fog{mode, double(columns[4][k])}, double(columns[3][k]))
                .intensity;
        ASSERT_TRUE(is_near(double(intensity[k]), truth, far)) << positions[k] << ": " << intensity[k] << " " << truth;
      }
    }
  };
  expect_batch_near(0.0, kFar);
  expect_batch_near(0.0f, kFarInFloat);
}

/// Solves every combination of special values: an error, or in range.
template <typename T, typename Enter, typename Leave>
void expect_no_nan(const Enter& enter, const Leave& leave) {
  using Limits = std::numeric_limits<T>;
  const std::vector<T> values{T(0),    Limits::denorm_min(), Limits::min(),       T(1e-20), T(0.05), T(1),
                              T(1e20), Limits::infinity(),   Limits::quiet_NaN(), T(-1)};
  std::vector<T> columns[5];
  for (const T c : values) {
    for (const T l : values) {
      for (const T q : values) {
        for (const T d : values) {
          for (const T t : {Limits::denorm_min(), T(0.05), T(1)}) {
            const T light[] = {c, l, q, t, d};
            for (int k = 0; k < 5; ++k) columns[k].push_back(light[k]);
          }
        }
      }
    }
  }
  const std::size_t count = columns[0].size();
  for (const FogMode mode : kModes) {
    std::vector<T> intensity(count);
    std::vector<T> peak_range(count);
    std::vector<T> extent(count);
    std::vector<BatchStatus> status(count);
    enter();
    solve_fog_intensities(
        mode, BasicBatchLights<T>{columns[0], columns[1], columns[2], columns[3], columns[4]},
        BasicBatchSolutions<T>{.intensity = intensity, .peak_range = peak_range, .extent = extent, .status = status});
    leave();
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_TRUE(intensity[i] >= 0 && intensity[i] <= 1 && peak_range[i] >= 0 && extent[i] >= 0)
          << "C " << columns[0][i] << " L " << columns[1][i] << " Q " << columns[2][i] << " t " << columns[3][i]
          << " d " << columns[4][i] << ": " << intensity[i] << ", " << peak_range[i] << ", " << extent[i];
      ASSERT_NE(status[i], BatchStatus::not_converged);
    }
  }
}

/// Takes an updater through a change of the fog in the mode that `enter` sets: no light's intensity may then be further
/// from the true one than the budget.
template <typename Enter, typename Leave>
void expect_updater_within_budget(const Enter& enter, const Leave& leave) {
  const double budget = kDefaultSkipBudget255 / 255;
  FogUpdater updater;
  std::vector<FogLightHandle> handles;
  const std::vector<SolveCase> cases = random_cases(2'000);
  for (const SolveCase& c : cases) {
    PlacedLight light;
    light.light.attenuation = c.attenuation;
    light.light.threshold = c.threshold;
    light.carried = true;
    handles.push_back(updater.add(light));
  }
  std::size_t skipped = 0;
  for (const double visibility : {20.0, 300.0, 5'000.0}) {
    for (const FogMode mode : kModes) {
      const Fog fog = Fog::from_visibility(mode, visibility);
      enter();
      updater.set_fog(fog);
      leave();
      skipped += updater.statistics().kinds_skipped;
      for (std::size_t i = 0; i < cases.size(); ++i) {
        const double stored = double(updater.kinds()[updater.kind_of(handles[i])].cone_scale_intensity.w);
        const double truth = solve_fog_intensity(cases[i].attenuation, fog, cases[i].threshold).intensity;
        ASSERT_TRUE(is_near(stored, truth, kFarInFloat) || (stored == 0 && truth <= budget))
            << i << ": " << stored << " " << truth;
      }
    }
  }
  EXPECT_GT(skipped, 0u);
}

TEST_F(FloatingPointMode, SolutionsStayNearTheUsualInEveryRoundingMode) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST}) {
    SCOPED_TRACE("rounding mode " + std::to_string(mode));
    const auto enter = [mode] { std::fesetround(mode); };
    const auto leave = [this] { back_to_default(); };
    expect_near_the_usual(enter, leave);
    expect_no_nan<double>(enter, leave);
    expect_no_nan<float>(enter, leave);
    expect_updater_within_budget(enter, leave);
  }
}

#if defined(__SSE2__)
TEST_F(FloatingPointMode, SolutionsStayNearTheUsualWhereSubnormalsAreFlushed) {
  const auto enter = [] { _mm_setcsr(_mm_getcsr() | 0x8040); };  // FTZ and DAZ
  const auto leave = [this] { back_to_default(); };
  expect_near_the_usual(enter, leave);
  expect_no_nan<double>(enter, leave);
  expect_no_nan<float>(enter, leave);
  expect_updater_within_budget(enter, leave);
}
#endif

}  // namespace
}  // namespace litfog::test
