// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

struct ModelInfo {
  std::string_view name;
  std::string_view description;
  std::vector<ParameterInfo> parameters;
};

/// Every model there is, in the order of the documentation.
std::span<const ModelInfo> models();

/// Null if there is no such model.
const ModelInfo* find_model(std::string_view name);

/// Builds a model; the same name and parameters give the same vertices.
/// throws std::invalid_argument for an unknown name, an unknown parameter, a value out of its range, or a bend_m that
/// is too large for its length_m
Model make_model(std::string_view name, const ModelParameters& parameters = {});

}  // namespace litfog::scene
