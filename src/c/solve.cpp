// SPDX-License-Identifier: Apache-2.0
#include "litfog/solve.h"

#include <array>
#include <stdexcept>
#include <string>

#include "c/call.h"
#include "c/convert.h"
#include "c/layout.h"
#include "litfog/airlight.h"
#include "litfog/batch.h"
#include "model/require.h"

using namespace litfog;

namespace {

/// A column with one value per light, or one for all.
template <typename Real>
std::span<const Real> shared_column(const Real* first, std::size_t size, std::size_t count, const char* name) {
  if (size != 1 && size != count) {
    throw std::invalid_argument(std::string(name) + "_count = " + std::to_string(size) + ": must be 1 or count");
  }
  return c::array(first, size, name);
}

/// litfog_batch_lights or litfog_batch_lights_f.
template <typename Real, typename Lights>
BasicBatchLights<Real> batch_lights(const Lights* lights) {
  const Lights& from = c::at(lights, "lights");
  return {.constant = c::array(from.constant, from.count, "lights.constant"),
          .linear = c::array(from.linear, from.count, "lights.linear"),
          .quadratic = c::array(from.quadratic, from.count, "lights.quadratic"),
          .threshold = shared_column(from.threshold, from.threshold_count, from.count, "lights.threshold"),
          .density = shared_column(from.density, from.density_count, from.count, "lights.density")};
}

template <typename Real>
std::array<c::Column, 5> columns_of(const BasicBatchLights<Real>& lights) {
  return {{{lights.constant, "lights.constant"},
           {lights.linear, "lights.linear"},
           {lights.quadratic, "lights.quadratic"},
           {lights.threshold, "lights.threshold"},
           {lights.density, "lights.density"}}};
}

/// A column of results, empty if not asked for.
template <typename Result, typename T>
std::span<Result> result_column(T* first, std::size_t count) {
  static_assert(sizeof(Result) == sizeof(T));
  return {reinterpret_cast<Result*>(first), first == nullptr ? 0 : count};
}

template <typename Real, typename Lights, typename Solutions>
litfog_status solve_batch(int32_t mode, const Lights* lights, const Solutions* solutions, size_t* invalid) {
  return c::call([&] {
    const BasicBatchLights<Real> batch = batch_lights<Real>(lights);
    const Solutions& to = c::at(solutions, "solutions");
    const std::size_t count = lights->count;
    const BasicBatchSolutions<Real> results{.intensity = c::array(to.intensity, count, "solutions.intensity"),
                                            .peak_range = result_column<Real>(to.peak_range, count),
                                            .extent = result_column<Real>(to.extent, count),
                                            .status = result_column<BatchStatus>(to.status, count)};
    c::expect_apart(std::array<c::Column, 4>{{{results.intensity, "solutions.intensity"},
                                              {results.peak_range, "solutions.peak_range"},
                                              {results.extent, "solutions.extent"},
                                              {results.status, "solutions.status"}}},
                    columns_of(batch));
    const std::size_t found = solve_fog_intensities(c::fog_mode(mode), batch, results);
    if (invalid != nullptr) *invalid = found;
  });
}

}  // namespace

litfog_status litfog_solve(const litfog_light* light, const litfog_fog* fog, litfog_fog_intensity* solution) {
  return c::call([&] {
    c::at(solution, "solution") = c::to_c<litfog_fog_intensity>(solve_fog_intensity(c::light(light), c::fog(fog)));
  });
}

litfog_status litfog_sample(const litfog_light* light, const litfog_fog* fog, int32_t samples,
                            litfog_fog_intensity* solution) {
  return c::call([&] {
    const Light from = c::light(light);
    require(find_error(from));
    c::at(solution, "solution") = c::to_c<litfog_fog_intensity>(
        sample_fog_intensity(from.attenuation, scaled(c::fog(fog), from.density_scale), from.threshold, samples));
  });
}

litfog_status litfog_solve_batch(int32_t fog_mode, const litfog_batch_lights* lights,
                                 const litfog_batch_solutions* solutions, size_t* invalid) {
  return solve_batch<double>(fog_mode, lights, solutions, invalid);
}

litfog_status litfog_solve_batch_f(int32_t fog_mode, const litfog_batch_lights_f* lights,
                                   const litfog_batch_solutions_f* solutions, size_t* invalid) {
  return solve_batch<float>(fog_mode, lights, solutions, invalid);
}
