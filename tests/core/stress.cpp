// SPDX-License-Identifier: Apache-2.0
// litfog_stress [--quick]: what the tests assert, over many more lights. Prints a table and exits 1 where a bound is
// broken.
//
// 1. Accuracy against 50 digits: a million random lights (--quick: 20,000), worst and mean ulp of each function.
// 2. Certificate, with no other solver involved: ten million solves (--quick: 200,000), each of which has to lie above
//    4,096 points over its extent and to rise before its peak and fall behind it.

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "litfog/batch.h"
#include "litfog/solve.h"
#include "reference/digits50.h"
#include "reference/double_limits.h"
#include "reference/error_tally.h"
#include "reference/random_light.h"
#include "reference/reference_solver.h"

namespace litfog::test {
namespace {

/// Coefficients, density and threshold over the whole range of a type's exponents.
template <typename T>
SolveCase draw_any_case(Random& random, FogMode mode) {
  const auto coefficient = [&] { return random.chance(0.2) ? T(0) : random.any_positive<T>(); };
  const T linear = coefficient();
  const T quadratic = linear == 0 ? random.any_positive<T>() : coefficient();
  T threshold = random.any_positive<T>();
  while (!(threshold < 1)) threshold = random.any_positive<T>();
  return {{coefficient(), linear, quadratic}, {mode, random.any_positive<T>()}, threshold};
}

SolveCase rounded_to_float(const SolveCase& c) {
  const auto& [constant, linear, quadratic] = c.attenuation;
  return {{float(constant), float(linear), float(quadratic)}, {c.fog.mode, float(c.fog.density)}, float(c.threshold)};
}

/// The batch's intensities for cases of one fog mode.
template <typename T>
std::vector<T> solve_as_batch(FogMode mode, const std::vector<SolveCase>& cases) {
  std::array<std::vector<T>, 5> columns;
  for (const SolveCase& c : cases) {
    const auto& [constant, linear, quadratic] = c.attenuation;
    const std::array values{constant, linear, quadratic, c.threshold, c.fog.density};
    for (std::size_t k = 0; k < 5; ++k) columns[k].push_back(T(values[k]));
  }
  std::vector<T> intensity(cases.size());
  solve_fog_intensities(mode, BasicBatchLights<T>{columns[0], columns[1], columns[2], columns[3], columns[4]},
                        BasicBatchSolutions<T>{.intensity = intensity});
  return intensity;
}

bool check_accuracy(std::size_t count) {
  bool is_good = true;
  for (const FogMode mode : kModes) {
    const auto tally = [&](const char* function, const char* lights, double bound) {
      return ErrorTally(function + std::string(", ") + name_of(mode), lights, bound);
    };
    ErrorTally extent = tally("extent", "all exponents", kExtentMaxUlp<double>);
    ErrorTally wide = tally("intensity", "all exponents", kIntensityMaxUlp<double>);
    ErrorTally intensity = tally("intensity", "ordinary lights", kIntensityMaxUlp<double>);
    ErrorTally single = tally("intensity, float", "ordinary lights", kIntensityMaxUlp<float>);
    ErrorTally batch = tally("batch intensity", "ordinary lights", kBatchIntensityMaxUlp);
    ErrorTally batch_single = tally("batch intensity, float", "ordinary lights", kBatchIntensityMaxUlp);
    Random random(mode == FogMode::exp ? 1 : 2);
    for (std::size_t i = 0; i < count / 4; ++i) {
      const SolveCase c = draw_any_case<double>(random, mode);
      if (!(c.attenuation.constant * c.threshold < 1)) continue;
      const ReferencePeak truth = solve_reference(c.attenuation, c.fog, c.threshold);
      const FogIntensity solved = solve_fog_intensity(c.attenuation, c.fog, c.threshold);
      const auto text = [&] { return to_string(c); };
      extent.add(ulp_error(solved.extent, truth.extent), text);
      wide.add(ulp_error(solved.intensity, truth.intensity), text);
    }
    std::vector<SolveCase> cases;
    for (std::size_t i = 0; i < count / 4; ++i) cases.push_back(rounded_to_float(draw_ordinary_case(random, mode)));
    const std::vector<double> in_double = solve_as_batch<double>(mode, cases);
    const std::vector<float> in_float = solve_as_batch<float>(mode, cases);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const auto& [attenuation, fog, threshold] = cases[i];
      const auto& [constant, linear, quadratic] = attenuation;
      const Digits50 truth = solve_reference(attenuation, fog, threshold).intensity;
      const auto text = [&] { return to_string(cases[i]); };
      intensity.add(ulp_error(solve_fog_intensity(attenuation, fog, threshold).intensity, truth), text);
      const FogIntensityF in_single =
          solve_fog_intensity(AttenuationF{float(constant), float(linear), float(quadratic)},
                              FogF{mode, float(fog.density)}, float(threshold));
      single.add(ulp_error(in_single.intensity, truth), text);
      batch.add(ulp_error(in_double[i], truth), text);
      batch_single.add(ulp_error(in_float[i], truth), text);
    }
    for (const ErrorTally* error : {&extent, &wide, &intensity, &single, &batch, &batch_single}) {
      error->print();
      if (error->is_within_bound()) continue;
      std::printf("broken: %s\n", error->worst_case().c_str());
      is_good = false;
    }
  }
  return is_good;
}

constexpr int kGridPoints = 4096;
constexpr std::size_t kAbreast = 16;  // lights whose grids are walked side by side, for the compiler to vectorise

/// The largest of opacity * attenuation - (1 + slack) * peak over each light's grid, relative to the peak: not above 0
/// where the peak is the supremum. The opacity is walked by o' = o + (1 - o) s, for exp fog with s the opacity of one
/// step, for exp2 with that of the growing square's step, itself walked so. Its error grows by less than an ulp a step.
void excess_over_grid(FogMode mode, const std::vector<SolveCase>& cases, const std::vector<FogIntensity>& solved,
                      std::array<double, kAbreast>& excess) {
  std::array<double, kAbreast> step, opacity{}, stride, growth, constant, linear, quadratic, needed, range{};
  for (std::size_t k = 0; k < kAbreast; ++k) {
    const SolveCase& c = cases[k];
    step[k] = solved[k].extent / kGridPoints;
    const double depth = c.fog.density * step[k];
    stride[k] = mode == FogMode::exp ? -std::expm1(-depth) : -std::expm1(-depth * depth);
    growth[k] = mode == FogMode::exp ? 0 : -std::expm1(-2 * depth * depth);
    constant[k] = c.attenuation.constant;
    linear[k] = c.attenuation.linear;
    quadratic[k] = c.attenuation.quadratic;
    needed[k] = solved[k].intensity * (1 + 2e-12);
    excess[k] = -1;
  }
  for (int i = 1; i <= kGridPoints; ++i) {
    for (std::size_t k = 0; k < kAbreast; ++k) {
      opacity[k] += (1 - opacity[k]) * stride[k];
      stride[k] += (1 - stride[k]) * growth[k];
      range[k] = double(i) * step[k];
      const double denominator = constant[k] + range[k] * (linear[k] + range[k] * quadratic[k]);
      const double above = opacity[k] - needed[k] * (denominator > 1 ? denominator : 1);
      excess[k] = above > excess[k] ? above : excess[k];
    }
  }
}

/// The sign of the derivative of opacity / D, by the closed form; 0 where rounding hides it.
int slope_sign(const SolveCase& c, double range) {
  const auto& [constant, linear, quadratic] = c.attenuation;
  const double x = c.fog.density * range;
  const double denominator = constant + range * (linear + range * quadratic);
  const double rise = (linear + 2 * quadratic * range) / c.fog.density;  // D'(x)
  const double left = c.fog.mode == FogMode::exp ? denominator : 2 * x * denominator;
  const double right = rise * std::expm1(c.fog.mode == FogMode::exp ? x : x * x);
  if (std::abs(left - right) <= 1e-12 * (left + right)) return 0;
  return left > right ? 1 : -1;
}

bool check_certificates(std::size_t count) {
  bool is_good = true;
  for (const FogMode mode : kModes) {
    Random random(mode == FogMode::exp ? 3 : 4);
    long long tried = 0;
    long long broken = 0;
    std::vector<SolveCase> cases(kAbreast);
    std::vector<FogIntensity> solved(kAbreast);
    std::array<double, kAbreast> excess;
    for (std::size_t done = 0; done < count / 2; done += kAbreast) {
      for (std::size_t k = 0; k < kAbreast; ++k) {
        cases[k] = draw_ordinary_case(random, mode);
        solved[k] = solve_fog_intensity(cases[k].attenuation, cases[k].fog, cases[k].threshold);
      }
      excess_over_grid(mode, cases, solved, excess);
      for (std::size_t k = 0; k < kAbreast; ++k) {
        ++tried;
        const auto& [intensity, peak, extent, status] = solved[k];
        const double knee = litfog::compute_knee(cases[k].attenuation);
        // Below the knee the product rises with the opacity; behind the extent the light ends.
        const bool rises = peak <= knee * (1 + 1e-9) || slope_sign(cases[k], peak * (1 - 1e-6)) >= 0;
        const bool falls = peak >= extent * (1 - 1e-9) || slope_sign(cases[k], peak * (1 + 1e-6)) <= 0;
        if (excess[k] <= 0 && rises && falls && status == SolveStatus::ok) continue;
        if (++broken <= 5) std::printf("broken: %s\n", to_string(cases[k]).c_str());
      }
    }
    std::printf("certificate, %-30s %9lld solves, %lld broken\n", name_of(mode), tried, broken);
    is_good = is_good && broken == 0 && tried > 0;
  }
  return is_good;
}

}  // namespace
}  // namespace litfog::test

int main(int argc, char** argv) {
  const bool is_quick = argc == 2 && std::strcmp(argv[1], "--quick") == 0;
  if (argc > 1 && !is_quick) {
    std::fprintf(stderr, "litfog_stress: takes --quick or nothing\n");
    return 1;
  }
  const bool is_accurate = litfog::test::check_accuracy(is_quick ? 20'000 : 1'000'000);
  const bool is_certified = litfog::test::check_certificates(is_quick ? 200'000 : 10'000'000);
  return is_accurate && is_certified ? 0 : 1;
}
