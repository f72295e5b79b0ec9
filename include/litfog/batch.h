// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "litfog/fog.h"

namespace litfog {

/// What became of a light of a batch.
enum class BatchStatus : std::uint8_t {
  ok,             ///< solved to the stated error
  not_converged,  ///< as SolveStatus::not_converged
  refused,        ///< an argument breaks its rule (see solve.h); intensity, peak range and extent are 0
};

/// The lights of a batch, a column a parameter. Columns hold one value a light; threshold and density may also hold a
/// single value for all. Values as for solve_fog_intensity (solve.h).
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

/// Where a batch's results go. A column holds one value a light; an empty one is not wanted and not computed.
template <typename Real>
struct BasicBatchSolutions {
  std::span<Real> intensity;
  std::span<Real> peak_range = {};  ///< metres
  std::span<Real> extent = {};      ///< metres
  std::span<BatchStatus> status = {};
};
using BatchSolutions = BasicBatchSolutions<double>;
using BatchSolutionsF = BasicBatchSolutions<float>;

/// solve_fog_intensity for many lights: SIMD of the widest kind that the processor has, chosen at run time. Allocates
/// nothing, never throws, and may run on any number of threads at once. Columns whose lengths do not fit are our
/// caller's bug and assert.
///
/// Bound by arithmetic, not by memory: copying the same columns takes a twentieth of the time from the caches and a
/// fifth from memory (`litfog-bench solve`, rows batch and memory-copy).
///
/// returns    how many lights were refused
/// max error  float: intensity 2 ulp, extent 1 ulp, peak_range 1e-4 relative;
///            double: intensity 2 ulp, extent 2 ulp, peak_range 1e-8 relative; on every target     (batch_test.cpp)
std::size_t solve_fog_intensities(FogMode mode, const BatchLights& lights, const BatchSolutions& solutions);
std::size_t solve_fog_intensities(FogMode mode, const BatchLightsF& lights, const BatchSolutionsF& solutions);

}  // namespace litfog
