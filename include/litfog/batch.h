// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "litfog/fog.h"

namespace litfog {

/// The outcome for one light of a batch.
enum class BatchStatus : std::uint8_t {
  ok,             ///< solved to the stated error
  not_converged,  ///< as SolveStatus::not_converged
  invalid,        ///< an argument breaks its rule (see solve.h): intensity, peak range and extent are 0
};

/// The lights of a batch, one column per parameter. A column holds one value per light; threshold and density may also
/// hold a single value for all lights. Values obey the rules of solve_fog_intensity (solve.h).
template <typename Real>
struct BasicBatchLights {
  std::span<const Real> constant;
  std::span<const Real> linear;     ///< 1/m
  std::span<const Real> quadratic;  ///< 1/m^2
  std::span<const Real> threshold;
  std::span<const Real> density;  ///< 1/m: the fog's, scaled for the light's class
};
using BatchLights = BasicBatchLights<double>;
using BatchLightsF = BasicBatchLights<float>;

/// Where a batch's results go. A column holds one value per light. All columns except intensity may be empty; an empty
/// column is not computed.
template <typename Real>
struct BasicBatchSolutions {
  std::span<Real> intensity;
  std::span<Real> peak_range = {};  ///< metres
  std::span<Real> extent = {};      ///< metres
  std::span<BatchStatus> status = {};
};
using BatchSolutions = BasicBatchSolutions<double>;
using BatchSolutionsF = BasicBatchSolutions<float>;

/// Largest errors of solve_fog_intensities: intensity and extent in ulp, peak range relative.
inline constexpr double kBatchIntensityMaxUlp = 2;
template <typename Real>
inline constexpr double kBatchExtentMaxUlp = std::is_same_v<Real, float> ? 1 : 2;
template <typename Real>
inline constexpr double kBatchPeakRangeMaxError = std::is_same_v<Real, float> ? 1e-4 : 1e-8;

/// solve_fog_intensity for many lights, with the processor's widest SIMD, chosen at run time. Allocates nothing, never
/// throws, and may run on any number of threads concurrently. No column of results may overlap another column:
/// a light's parameters are read again after results have been written. Columns of wrong lengths are a caller's bug and
/// assert.
///
/// Arithmetic, not memory, limits the speed: copying the same columns takes at most 7 % of the time from caches and
/// 27 % from memory (data/benchmarks/epyc-solve.csv, rows batch and memory-copy).
///
/// returns    number of invalid lights
/// max error  on every target: intensity kBatchIntensityMaxUlp, extent kBatchExtentMaxUlp,
///            peak_range kBatchPeakRangeMaxError                                                   (batch_test.cpp)
std::size_t solve_fog_intensities(FogMode mode, const BatchLights& lights, const BatchSolutions& solutions);
std::size_t solve_fog_intensities(FogMode mode, const BatchLightsF& lights, const BatchSolutionsF& solutions);

}  // namespace litfog
