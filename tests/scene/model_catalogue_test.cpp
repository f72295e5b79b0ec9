// SPDX-License-Identifier: Apache-2.0
#include "scene/model/model_catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "mesh_faults.h"
#include "scene/paint/material_catalogue.h"

namespace litfog::test {
using namespace scene;

namespace {

enum class Setting { kDefault, kMinimum, kMaximum };

ModelParameters parameters_of(const ModelInfo& info, Setting setting) {
  ModelParameters parameters;
  for (const ParameterInfo& each : info.parameters) {
    if (setting == Setting::kMinimum) parameters[std::string(each.name)] = each.minimum;
    if (setting == Setting::kMaximum) parameters[std::string(each.name)] = each.maximum;
  }
  // A bend has a radius of at least 100 m.
  if (const auto bend = parameters.find("bend_m"); bend != parameters.end()) {
    const double most = std::pow(parameters.at("length_m"), 2) / 200.0;
    bend->second = std::clamp(bend->second, -most, most);
  }
  return parameters;
}

constexpr std::size_t kMaxTriangles = 5'000'000;

/// Faults of its triangles, their number, and materials that the catalogue lacks.
void expect_sound(const std::string& what, const Model& model) {
  SCOPED_TRACE(what);
  const auto known = material_names();
  for (const Part& each : model) EXPECT_NE(std::ranges::find(known, each.material), known.end()) << each.material;
  EXPECT_LE(triangle_count(model), kMaxTriangles);
  const Faults faults = faults_of(model);
  EXPECT_EQ(faults.not_finite, 0);
  EXPECT_EQ(faults.normals_not_unit, 0);
  EXPECT_EQ(faults.tangents_not_unit, 0);
  EXPECT_EQ(faults.tangents_not_square, 0);
  EXPECT_EQ(faults.signs_not_one, 0);
  EXPECT_EQ(faults.indices_out_of_range, 0);
  // Poles, tips and the smallest twigs of the smallest trees: at most 2 in 100.
  EXPECT_LE(faults.without_area * 50, faults.triangles);
  // Smoothing over sharp corners may turn a normal away from a sliver: at most 1 in 200.
  EXPECT_LE(faults.facing_away * 200, faults.triangles);
  EXPECT_LE(faults.tangents_against_u * 50, faults.triangles);
}

bool same_bytes(const Model& a, const Model& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Mesh& x = a[i].mesh;
    const Mesh& y = b[i].mesh;
    if (a[i].material != b[i].material || x.indices != y.indices || x.vertices.size() != y.vertices.size())
      return false;
    if (std::memcmp(x.vertices.data(), y.vertices.data(), x.vertices.size() * sizeof(Vertex)) != 0) return false;
  }
  return true;
}

class EveryModel : public testing::TestWithParam<std::string> {};

TEST_P(EveryModel, ModelIsSoundWithDefaultParameters) {
  const Model model = make_model(GetParam());
  EXPECT_GT(triangle_count(model), 0u);
  expect_sound("defaults", model);
}

TEST_P(EveryModel, ModelIsSoundWithExtremeParameters) {
  const ModelInfo& info = *find_model(GetParam());
  for (const Setting setting : {Setting::kMinimum, Setting::kMaximum}) {
    expect_sound(setting == Setting::kMinimum ? "all at their minimum" : "all at their maximum",
                 make_model(info.name, parameters_of(info, setting)));
  }
}

TEST_P(EveryModel, ModelIsSoundWithEachParameterAtItsEnds) {
  const ModelInfo& info = *find_model(GetParam());
  for (const ParameterInfo& parameter : info.parameters) {
    for (const double value : {parameter.minimum, parameter.maximum}) {
      const ModelParameters parameters{{std::string(parameter.name), value}};
      expect_sound(std::string(parameter.name) + " = " + std::to_string(value), make_model(info.name, parameters));
    }
  }
}

// The smaller these of the parameters, the more triangles there are.
TEST_P(EveryModel, NumberOfTrianglesIsBoundedByTheClosestSpacing) {
  const ModelInfo& info = *find_model(GetParam());
  const ModelParameters most = parameters_of(info, Setting::kMaximum);
  for (const std::string_view name : {"cell_m", "spacing_m", "dash_m", "gap_m"}) {
    for (const ParameterInfo& parameter : info.parameters) {
      if (parameter.name != name) continue;
      ModelParameters parameters = most;
      parameters[std::string(name)] = parameter.minimum;
      EXPECT_LE(triangle_count(make_model(info.name, parameters)), kMaxTriangles) << name;
    }
  }
}

TEST_P(EveryModel, ModelIsTheSameTwice) { EXPECT_TRUE(same_bytes(make_model(GetParam()), make_model(GetParam()))); }

TEST_P(EveryModel, AnotherSeedMakesAnotherModel) {
  const ModelInfo& info = *find_model(GetParam());
  for (const ParameterInfo& parameter : info.parameters) {
    if (parameter.name != "seed" && parameter.name != "ground_seed") continue;
    const ModelParameters other{{std::string(parameter.name), parameter.default_value + 1}};
    EXPECT_FALSE(same_bytes(make_model(info.name), make_model(info.name, other))) << parameter.name;
  }
}

TEST_P(EveryModel, BadParameterIsAnError) {
  const ModelInfo& info = *find_model(GetParam());
  EXPECT_THROW(make_model(info.name, {{"no_such_parameter", 1.0}}), std::invalid_argument);
  for (const ParameterInfo& parameter : info.parameters) {
    SCOPED_TRACE(parameter.name);
    EXPECT_EQ(find_error(parameter, parameter.default_value), std::nullopt);
    for (const double bad : {parameter.minimum - 1.0, parameter.maximum + 1.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
      const ModelParameters parameters{{std::string(parameter.name), bad}};
      EXPECT_THROW(make_model(info.name, parameters), std::invalid_argument) << bad;
    }
    if (!parameter.is_whole) continue;
    const ModelParameters parameters{{std::string(parameter.name), parameter.minimum + 0.5}};
    EXPECT_THROW(make_model(info.name, parameters), std::invalid_argument);
  }
}

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const ModelInfo& info : models()) names.emplace_back(info.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(ModelCatalogue, EveryModel, testing::ValuesIn(model_names()),
                         [](const auto& tested) { return tested.param; });

TEST(ModelCatalogue, UnknownModelIsAnError) {
  EXPECT_THROW(make_model("no_such_model"), std::invalid_argument);
  EXPECT_EQ(find_model("no_such_model"), nullptr);
}

}  // namespace
}  // namespace litfog::test
