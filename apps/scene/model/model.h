// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh.h"

namespace litfog::scene {

/// What a scene file says about a model beside its name: {"model":"spruce", "height_m":9, "seed":3}.
class ModelParameters {
 public:
  ModelParameters() = default;
  ModelParameters(std::initializer_list<std::pair<const std::string, double>> values) : values_(values) {}
  void set(std::string_view name, double value) { values_.insert_or_assign(std::string(name), value); }
  double get(std::string_view name, double if_absent) const {
    const auto found = values_.find(name);
    return found == values_.end() ? if_absent : found->second;
  }
  const std::map<std::string, double, std::less<>>& values() const { return values_; }

 private:
  std::map<std::string, double, std::less<>> values_;
};

/// A parameter of a model. Its unit is in its name: _m metres, _deg degrees; none for counts, seeds and shares.
struct ParameterInfo {
  std::string_view name;
  double default_value;
  double minimum;
  double maximum;
  bool whole;  ///< whole numbers only
};

struct ModelInfo {
  std::string_view name;
  std::string_view description;
  std::vector<ParameterInfo> parameters;
};

/// Every model there is, in the order of the documentation.
std::span<const ModelInfo> models();

/// Null where there is no such model.
const ModelInfo* find_model(std::string_view name);

/// Why a value does not do for a parameter ("must be a whole number", "must be in [0.5, 40]"); empty where it does.
std::string refusal(const ParameterInfo& parameter, double value);

/// Builds a model; the same name and parameters give the same vertices.
/// throws std::invalid_argument for an unknown name, an unknown parameter, a value out of its range, or a bend_m that
/// is too much for its length_m
Model make_model(std::string_view name, const ModelParameters& parameters = {});

}  // namespace litfog::scene
