// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "litfog/batch.h"

namespace litfog {

/// Whether the columns hold `count` lights.
template <typename T>
bool holds_lights(const BasicBatchLights<T>& lights, std::size_t count) {
  const auto is_whole = [count](const auto& column) { return column.size() == count; };
  const auto is_shared = [&](const auto& column) { return is_whole(column) || column.size() == 1; };
  return is_whole(lights.constant) && is_whole(lights.linear) && is_whole(lights.quadratic) &&
         is_shared(lights.threshold) && is_shared(lights.density);
}

/// A light's value in a column that holds one a light, or a single one for all.
template <typename T>
T value_at(std::span<const T> column, std::size_t at) {
  return column[column.size() == 1 ? 0 : at];
}

/// Copies the five values of a light into a lane of vectors.
template <typename T, std::size_t kLanes>
void copy_light(const BasicBatchLights<T>& lights, std::size_t at, T (&columns)[5][kLanes], std::size_t lane) {
  columns[0][lane] = lights.constant[at];
  columns[1][lane] = lights.linear[at];
  columns[2][lane] = lights.quadratic[at];
  columns[3][lane] = value_at(lights.threshold, at);
  columns[4][lane] = value_at(lights.density, at);
}

}  // namespace litfog
