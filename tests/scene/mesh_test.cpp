// SPDX-License-Identifier: Apache-2.0
#include "scene/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <set>
#include <stdexcept>

#include "scene/model/model_catalogue.h"
#include "scene/model/primitive.h"
#include "scene/model/terrain.h"
#include "scene/paint/material_catalogue.h"

namespace litfog::test {
using namespace scene;

namespace litfog::demo {
namespace {

/// What is wrong with a mesh, counted.
struct Faults {
  int not_finite = 0;
  int normals_not_unit = 0;   // by more than 1e-3
  int tangents_not_unit = 0;  // likewise
  int tangents_not_square = 0;
  int signs_not_one = 0;
  int indices_out_of_range = 0;
  int without_area = 0;
  int facing_away = 0;  // from the mean of their vertices' normals
  int tangents_against_u = 0;
  int triangles = 0;
};

bool finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void count_faults(const Mesh& mesh, Faults& faults) {
  for (const Vertex& vertex : mesh.vertices) {
    const glm::vec3 tangent(vertex.tangent);
    if (!finite(vertex.position) || !finite(vertex.normal) || !finite(tangent) || !std::isfinite(vertex.uv.x) ||
        !std::isfinite(vertex.uv.y)) {
      ++faults.not_finite;
    }
    if (!(std::abs(glm::length(vertex.normal) - 1.0f) <= 1e-3f)) ++faults.normals_not_unit;
    if (!(std::abs(glm::length(tangent) - 1.0f) <= 1e-3f)) ++faults.tangents_not_unit;
    if (!(std::abs(glm::dot(vertex.normal, tangent)) <= 1e-3f)) ++faults.tangents_not_square;
    if (!(std::abs(vertex.tangent.w) == 1.0f)) ++faults.signs_not_one;
  }
  if (mesh.indices.size() % 3 != 0) ++faults.indices_out_of_range;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    ++faults.triangles;
    const std::uint32_t* corner = &mesh.indices[i];
    if (corner[0] >= mesh.vertices.size() || corner[1] >= mesh.vertices.size() || corner[2] >= mesh.vertices.size()) {
      ++faults.indices_out_of_range;
      continue;
    }
    const Vertex& a = mesh.vertices[corner[0]];
    const Vertex& b = mesh.vertices[corner[1]];
    const Vertex& c = mesh.vertices[corner[2]];
    const glm::vec3 area = glm::cross(b.position - a.position, c.position - a.position);
    // A tenth of a square millimetre.
    if (!(glm::length(area) > 2e-7f)) {
      ++faults.without_area;
      continue;
    }
    if (!(glm::dot(area, a.normal + b.normal + c.normal) > 0.0f)) ++faults.facing_away;
    // du along the mean tangent, seen through the linear map from the triangle to uv.
    const glm::vec3 tangent = glm::vec3(a.tangent) + glm::vec3(b.tangent) + glm::vec3(c.tangent);
    const glm::vec2 d1 = b.uv - a.uv;
    const glm::vec2 d2 = c.uv - a.uv;
    const float determinant = d1.x * d2.y - d1.y * d2.x;
    if (std::abs(determinant) < 1e-9f) continue;
    const glm::vec3 along_u = ((b.position - a.position) * d2.y - (c.position - a.position) * d1.y) / determinant;
    if (!(glm::dot(along_u, tangent) > 0.0f)) ++faults.tangents_against_u;
  }
}

Faults faults_of(const Model& model) {
  Faults faults;
  for (const Part& each : model) count_faults(each.mesh, faults);
  return faults;
}

enum class Setting { kDefault, kMinimum, kMaximum };

ModelParameters parameters_of(const ModelInfo& info, Setting setting) {
  ModelParameters parameters;
  for (const ParameterInfo& each : info.parameters) {
    if (setting == Setting::kMinimum) parameters.set(each.name, each.minimum);
    if (setting == Setting::kMaximum) parameters.set(each.name, each.maximum);
  }
  // A bend has a radius of at least 100 m.
  if (parameters.values().contains("bend_m")) {
    const double most = std::pow(parameters.get("length_m", 0.0), 2) / 200.0;
    parameters.set("bend_m", std::clamp(parameters.get("bend_m", 0.0), -most, most));
  }
  return parameters;
}

void expect_sound(const std::string& what, const Model& model) {
  SCOPED_TRACE(what);
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

TEST_P(EveryModel, IsSoundWithDefaultParameters) {
  const Model model = make_model(GetParam());
  EXPECT_GT(triangle_count(model), 0u);
  expect_sound("defaults", model);
}

TEST_P(EveryModel, IsSoundWithExtremeParameters) {
  const ModelInfo& info = *find_model(GetParam());
  for (const Setting setting : {Setting::kMinimum, Setting::kMaximum}) {
    expect_sound(setting == Setting::kMinimum ? "all at their minimum" : "all at their maximum",
                 make_model(info.name, parameters_of(info, setting)));
  }
}

TEST_P(EveryModel, IsSoundWithEachParameterAtItsEnds) {
  const ModelInfo& info = *find_model(GetParam());
  for (const ParameterInfo& parameter : info.parameters) {
    for (const double value : {parameter.minimum, parameter.maximum}) {
      ModelParameters parameters;
      parameters.set(parameter.name, value);
      expect_sound(std::string(parameter.name) + " = " + std::to_string(value), make_model(info.name, parameters));
    }
  }
}

TEST_P(EveryModel, HasABoundedNumberOfTrianglesWhateverItsParameters) {
  const ModelInfo& info = *find_model(GetParam());
  const auto count = [&](const ModelParameters& parameters) {
    return triangle_count(make_model(info.name, parameters));
  };
  const ModelParameters most = parameters_of(info, Setting::kMaximum);
  EXPECT_LE(count(most), 5'000'000u);
  // The smaller these, the more there are.
  for (const std::string_view name : {"cell_m", "spacing_m", "dash_m", "gap_m"}) {
    for (const ParameterInfo& parameter : info.parameters) {
      if (parameter.name != name) continue;
      ModelParameters parameters = most;
      parameters.set(name, parameter.minimum);
      EXPECT_LE(count(parameters), 5'000'000u) << name;
    }
  }
}

TEST_P(EveryModel, HasOnlyKnownMaterials) {
  std::set<std::string_view> known(material_names().begin(), material_names().end());
  for (const Setting setting : {Setting::kDefault, Setting::kMinimum, Setting::kMaximum}) {
    const ModelInfo& info = *find_model(GetParam());
    for (const Part& each : make_model(info.name, parameters_of(info, setting))) {
      EXPECT_TRUE(known.contains(each.material)) << each.material;
    }
  }
}

TEST_P(EveryModel, ComesOutTheSameTwice) { EXPECT_TRUE(same_bytes(make_model(GetParam()), make_model(GetParam()))); }

TEST_P(EveryModel, ChangesWithItsSeed) {
  const ModelInfo& info = *find_model(GetParam());
  for (const ParameterInfo& parameter : info.parameters) {
    if (parameter.name != "seed" && parameter.name != "ground_seed") continue;
    ModelParameters other;
    other.set(parameter.name, parameter.default_value + 1);
    EXPECT_FALSE(same_bytes(make_model(info.name), make_model(info.name, other))) << parameter.name;
  }
}

TEST_P(EveryModel, RefusesBadParameters) {
  const ModelInfo& info = *find_model(GetParam());
  EXPECT_THROW(make_model(info.name, {{"no_such_parameter", 1.0}}), std::invalid_argument);
  for (const ParameterInfo& parameter : info.parameters) {
    SCOPED_TRACE(parameter.name);
    EXPECT_TRUE(refusal(parameter, parameter.default_value).empty());
    for (const double bad : {parameter.minimum - 1.0, parameter.maximum + 1.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
      ModelParameters parameters;
      parameters.set(parameter.name, bad);
      EXPECT_THROW(make_model(info.name, parameters), std::invalid_argument) << bad;
    }
    if (!parameter.whole) continue;
    ModelParameters parameters;
    parameters.set(parameter.name, parameter.minimum + 0.5);
    EXPECT_THROW(make_model(info.name, parameters), std::invalid_argument);
  }
}

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const ModelInfo& info : models()) names.emplace_back(info.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Mesh, EveryModel, testing::ValuesIn(model_names()),
                         [](const auto& tested) { return tested.param; });

TEST(Mesh, RefusesAnUnknownModel) {
  EXPECT_THROW(make_model("no_such_model"), std::invalid_argument);
  EXPECT_EQ(find_model("no_such_model"), nullptr);
}

TEST(Mesh, RefusesABendThatIsTooTight) {
  EXPECT_NO_THROW(make_model("road", {{"length_m", 100.0}, {"bend_m", 50.0}}));
  EXPECT_THROW(make_model("road", {{"length_m", 100.0}, {"bend_m", 51.0}}), std::invalid_argument);
}

TEST(Mesh, BoundsHoldABox) {
  const Bounds box = bounds(make_box({2.0f, 3.0f, 4.0f}));
  EXPECT_EQ(box.low, glm::vec3(-1.0f, 0.0f, -2.0f));
  EXPECT_EQ(box.high, glm::vec3(1.0f, 3.0f, 2.0f));
}

TEST(Mesh, AppendKeepsFrontsInFrontWhenMirrored) {
  Model mirrored;
  append(part(mirrored, "stone"), make_bevelled_box({1.0f, 2.0f, 3.0f}, 0.2f),
         glm::scale(glm::mat4(1.0f), glm::vec3(-1.0f, 1.0f, 2.0f)));
  const Faults faults = faults_of(mirrored);
  EXPECT_EQ(faults.facing_away, 0);
  EXPECT_EQ(faults.tangents_against_u, 0);
  EXPECT_EQ(faults.normals_not_unit, 0);
}

TEST(Mesh, PartKeepsEarlierReferencesValid) {
  Model model;
  Mesh& first = part(model, "stone");
  for (int i = 0; i < 100; ++i) part(model, "material " + std::to_string(i));
  EXPECT_EQ(&first, &part(model, "stone"));
  EXPECT_EQ(model.size(), 101u);
}

TEST(Mesh, PlaceTurnsCounterClockwiseSeenFromAbove) {
  const glm::vec3 turned(place({1.0f, 2.0f, 3.0f}, glm::radians(90.0f)) * glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
  EXPECT_NEAR(glm::distance(turned, glm::vec3(1.0f, 2.0f, 2.0f)), 0.0f, 1e-6f);
}

TEST(Mesh, ABeamIsClosedAndOfItsLength) {
  const Bounds box = bounds(make_beam({0.0f, 1.0f, 0.0f}, {0.0f, 1.0f, -5.0f}, 0.2f, 0.4f));
  EXPECT_NEAR(glm::distance(box.low, glm::vec3(-0.1f, 0.8f, -5.0f)), 0.0f, 1e-5f);
  EXPECT_NEAR(glm::distance(box.high, glm::vec3(0.1f, 1.2f, 0.0f)), 0.0f, 1e-5f);
}

TEST(Mesh, AWallLeavesItsOpeningsFree) {
  const Opening window{1.0f, 1.0f, 2.0f, 2.0f};
  const Mesh wall = make_wall(4.0f, 3.0f, std::span(&window, 1), 0.2f);
  float front = 0.0f;
  for (std::size_t i = 0; i + 2 < wall.indices.size(); i += 3) {
    const Vertex& a = wall.vertices[wall.indices[i]];
    if (a.normal.z < 0.9f) continue;
    const glm::vec3 ab = wall.vertices[wall.indices[i + 1]].position - a.position;
    const glm::vec3 ac = wall.vertices[wall.indices[i + 2]].position - a.position;
    front += 0.5f * glm::length(glm::cross(ab, ac));
  }
  EXPECT_NEAR(front, 11.0f, 1e-4f);
}

TEST(Mesh, TheGroundLiesUnderTheRoadOnAllItsLength) {
  Ground ground;
  ground.corridor_m = 14.0f;
  ground.relief_m = 3.0f;
  ground.bend_m = 25.0f;
  for (float along = 0.0f; along <= ground.length_m; along += 3.0f) {
    for (const float offset : {-6.0f, 0.0f, 6.0f}) {
      const glm::vec3 p = ground.point(along, offset);
      EXPECT_LT(ground_height(ground, p.x, p.z), -0.05f) << along << " " << offset;
    }
  }
}

TEST(Mesh, RoadPaintLiesOverTheRoad) {
  RoadMarkings markings;
  const Bounds paint = bounds(make_road_markings(markings));
  EXPECT_GE(paint.low.y, 0.9f * markings.lift_m);
  EXPECT_LE(paint.high.y, road_height(markings, 0.0f) + markings.lift_m + 1e-4f);
}

// Between vertices whose tangents jump, what is carried into tangent space is interpolated to nonsense.
TEST(Mesh, TangentsWithoutTextureCoordinatesTurnWithTheNormal) {
  constexpr int kSteps = 64;
  const auto tangent = [](int ring, int turn) {
    const double polar = 0.9 * 3.14159 * ring / kSteps;  // all but straight down
    const double around = 2 * 3.14159 * turn / kSteps;
    const glm::vec3 normal(std::sin(polar) * std::sin(around), std::cos(polar), std::sin(polar) * std::cos(around));
    Mesh mesh;
    mesh.vertices.push_back({normal, normal, {}, {}});
    compute_tangents(mesh);
    EXPECT_NEAR(glm::dot(normal, glm::vec3(mesh.vertices[0].tangent)), 0, 1e-6);
    return glm::vec3(mesh.vertices[0].tangent);
  };
  for (int ring = 0; ring < kSteps; ++ring) {
    for (int turn = 0; turn < kSteps; ++turn) {
      // The frame is a turn by the polar angle about a level axis, which itself turns with the normal: a step around
      // turns the tangent back and forth.
      EXPECT_LT(glm::distance(tangent(ring, turn), tangent(ring + 1, turn)), 0.9 * 3.1416 / kSteps);
      EXPECT_LT(glm::distance(tangent(ring, turn), tangent(ring, turn + 1)), 2 * 2 * 3.1416 / kSteps);
    }
  }
}

TEST(Bounds, TransformedBoxHoldsItsTransformedCorners) {
  const Bounds box{{-1, 0, 2}, {3, 1, 4}};
  const glm::mat4 turn = glm::translate(glm::rotate(glm::mat4(1), 0.7f, glm::vec3(0.6f, 0.8f, 0)), {5, 6, 7});
  const Bounds around = transformed(box, turn);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 at{corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                       corner & 4 ? box.high.z : box.low.z};
    const glm::vec3 moved = glm::vec3(turn * glm::vec4(at, 1));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(around.low, moved + 1e-4f)));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(moved, around.high + 1e-4f)));
  }
}

}  // namespace
}  // namespace litfog::demo

}  // namespace litfog::test
