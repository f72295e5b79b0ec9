// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <optional>

#include "core/value_errors.h"
#include "litfog/solve.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"
#include "reference/reference_solver.h"

// Every combination of the values at which arithmetic turns is either solved as documented or an error with the right
// sentence.

namespace litfog::test {
namespace {

template <typename Real>
constexpr std::array<Real, 15> special_values() {
  using Limits = std::numeric_limits<Real>;
  return {Real(0),
          Limits::denorm_min(),
          Limits::min(),
          Limits::epsilon(),
          Real(1e-30),
          Real(1e-5),
          Real(0.5),
          Real(1),
          Real(1e5),
          Real(1e30),
          Limits::max(),
          Limits::infinity(),
          Limits::quiet_NaN(),
          Real(-0.0),
          Real(-1)};
}

/// The error that solve.h states, of the first wrong argument.
std::optional<ValueError> expected_error(const SolveCase& c) {
  const auto is_coefficient = [](double x) { return x >= 0 && x < std::numeric_limits<double>::infinity(); };
  const auto& [constant, linear, quadratic] = c.attenuation;
  if (!is_coefficient(constant)) return ValueError{"attenuation.constant", constant, "must be finite and >= 0"};
  if (!is_coefficient(linear)) return ValueError{"attenuation.linear", linear, "must be finite and >= 0"};
  if (!is_coefficient(quadratic)) return ValueError{"attenuation.quadratic", quadratic, "must be finite and >= 0"};
  if (constant + linear + quadratic == 0) {
    return ValueError{"attenuation.constant", constant, "must be > 0 where linear and quadratic are 0"};
  }
  if (!(c.fog.density >= 0)) return ValueError{"fog.density", c.fog.density, "must be >= 0"};
  if (!(c.threshold > 0 && c.threshold < 1)) return ValueError{"threshold", c.threshold, "must be in (0, 1)"};
  return std::nullopt;
}

/// True where the fields of a solution are as documented; NaN is as nothing.
template <typename Real>
bool is_as_documented(const BasicFogIntensity<Real>& solved, const SolveCase& c) {
  const auto& [constant, linear, quadratic] = c.attenuation;
  const Real largest = Real(constant > 1 ? 1 / constant : 1);
  if (!(solved.intensity >= 0 && solved.intensity <= largest && solved.peak_range >= 0)) return false;
  if (!(solved.peak_range <= solved.extent && solved.status == SolveStatus::ok)) return false;
  const bool is_dark = Digits50(constant) * Digits50(c.threshold) >= 1;
  const bool is_constant = linear == 0 && quadratic == 0;
  if (is_dark) return solved.extent == 0 && solved.peak_range == 0 && solved.intensity == 0;
  if (is_constant && solved.extent != std::numeric_limits<Real>::infinity()) return false;
  if (c.fog.density == 0) return solved.intensity == 0 && solved.peak_range == 0;
  if (c.fog.density == kInfinity) return solved.intensity == largest && solved.peak_range == 0;
  if (is_constant) return solved.intensity == largest && solved.peak_range == std::numeric_limits<Real>::infinity();
  return true;
}

template <typename Real>
void check_special_values() {
  constexpr std::array kValues = special_values<Real>();
  int accepted = 0;
  int invalid = 0;
  for (const FogMode mode : kModes) {
    for (const Real constant : kValues) {
      for (const Real linear : kValues) {
        for (const Real quadratic : kValues) {
          for (const Real density : kValues) {
            for (const Real threshold : kValues) {
              const BasicAttenuation<Real> a{constant, linear, quadratic};
              const BasicFog<Real> fog{mode, density};
              const SolveCase c{{constant, linear, quadratic}, {mode, density}, threshold};
              const std::optional<ValueError> error = expected_error(c);
              if (!error) {
                ++accepted;
                const auto solved = solve_fog_intensity(a, fog, threshold);
                ASSERT_TRUE(is_as_documented(solved, c))
                    << to_string(c) << ": intensity " << solved.intensity << ", peak range " << solved.peak_range
                    << ", extent " << solved.extent;
              } else if (++invalid % 17 == 0) {  // exceptions are slow; 17 has no part in 15 values
                ASSERT_EQ(error_of([&] { solve_fog_intensity(a, fog, threshold); }), to_string(*error));
              }
            }
          }
        }
      }
    }
  }
  std::printf("special values: %d solved, %d of %d errors read\n", accepted, invalid / 17, invalid);
}

TEST(SolveSpecialValues, SpecialValuesAreSolvedAsDocumentedOrAnError) { check_special_values<double>(); }
TEST(SolveSpecialValues, SpecialValuesInSinglePrecisionAreSolvedAsDocumentedOrAnError) {
  check_special_values<float>();
}

TEST(SolveSpecialValues, SamplesOfSpecialValuesAreNeverNan) {
  constexpr std::array kValues = special_values<double>();
  for (const FogMode mode : kModes) {
    for (const double constant : kValues) {
      for (const double linear : kValues) {
        for (const double quadratic : kValues) {
          for (const double density : kValues) {
            for (const double threshold : kValues) {
              const SolveCase c{{constant, linear, quadratic}, {mode, density}, threshold};
              if (expected_error(c)) continue;
              const FogIntensity sampled = sample_fog_intensity(c.attenuation, c.fog, threshold, 3);
              ASSERT_TRUE(sampled.intensity >= 0 && sampled.intensity <= 1 && sampled.peak_range >= 0 &&
                          sampled.peak_range <= sampled.extent)
                  << to_string(c) << ": intensity " << sampled.intensity << ", peak range " << sampled.peak_range
                  << ", extent " << sampled.extent;
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace litfog::test
