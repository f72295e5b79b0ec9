// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "command/temporary_directory.h"
#include "files/json_schema.h"
#include "litfog/photometry/cookie_file.h"
#include "scene/file/scene_file.h"
#include "scene/model/city.h"
#include "scene/model/model_catalogue.h"

namespace litfog::test {
namespace {

constexpr const char* kScene = R"({"$schema": "s", "litfog": "scene", "version": 1, "name": "a", "description": "b",
  "camera": {"position": [0, 2, 0], "target": [0, 1, -9], "field_of_view_deg": 50},
  "environment": {"ambient": [0.1, 0.1, 0.1], "fog_color": [0, 0, 0], "sky_zenith": [0, 0, 0],
                  "sky_horizon": [0, 0, 0], "stars": 1, "moon": {"direction": [0, -1, 0], "color": [1, 1, 1]}},
  "visibilities_m": [100, 50], "lit_at_vertices": true, "fog_top_m": 60,
  "atmosphere": {"phase": "hg:0.5", "albedo": 0.9,
                 "layers": [{"base_m": 90, "top_m": 120, "transition_m": 9, "visibility_m": 150}]},
  "display": {"exposure": "auto", "tone": "clip"},
  "lights": [{"light": {"attenuation": {"constant": 1}}, "position": [0, 3, 0], "aim": [0, 0, -5], "color": [1, 1, 1],
              "cookie": {"image": "spot.exr", "roll_deg": 9, "spin_deg_per_s": 9}, "turn_deg_per_s": 9, "carried": true,
              "repeat": [{"count": 2, "step": [1, 0, 0]}]},
             {"light": "lamp.json", "position": [0, 3, 0], "direction": [0, -1, 0]},
             {"light": "lamp.json", "position": [0, 3, 0], "mount": {"azimuth_deg": 9, "elevation_deg": 9}}],
  "vehicle": {"position": [0, 1, 0], "heading_deg": 9, "pitch_deg": 9, "roll_deg": 9},
  "objects": [{"model": "box", "width_m": 1, "position": [0, 0, 0], "heading_deg": 9, "scale": 1,
               "repeat": [{"count": 2, "step": [1, 0, 0]}]},
              {"model": "box", "scatter": {"count": 2, "area": [0, 0, 9, 9], "seed": 2, "scale": [1, 2]}}]})";

/// What a schema cannot say: what lies in other files, sums, directions without a length.
constexpr std::array kRulesAcrossMembers{"must be a light file",
                                         "must be a cookie",
                                         "straight above or below",
                                         "must have a length",
                                         "must be in a scene with a vehicle",
                                         "every copy's position",
                                         "must be above the base",
                                         "with its transition band",
                                         "must have at most 8 heights"};

class SceneSchema : public testing::Test {
 protected:
  SceneSchema() {
    directory_.write("lamp.json",
                     R"({"litfog": "light", "version": 1, "attenuation": {"constant": 1, "quadratic": 1}})");
    directory_.write("spot.exr", format_cookie(make_cookie(2, [](const glm::dvec3&) { return 1.0; })));
  }

  /// The members that the reader lists where a scene has a wrong one.
  std::set<std::string> refused_members(const std::string& rest) const {
    return members_in(refusal_of_(R"({"litfog": "scene", "version": 1, )" + rest + "}"));
  }

  const JsonSchema schema_{"scene"};
  TemporaryDirectory directory_;
  const Refusal refusal_of_ = refusal_by([](const std::string& path) { scene::read_scene(path); }, directory_.path());
};

TEST_F(SceneSchema, BundledScenesAreValid) {
  expect_bundled_valid(schema_, "scenes", 8);
  std::ifstream strip(LITFOG_DATA_DIR "/pictures/lamp-in-fog.json");
  EXPECT_EQ(schema_.error_of({std::istreambuf_iterator<char>(strip), {}}), "");
}

TEST_F(SceneSchema, SchemaHasTheReadersMembersAlone) {
  const std::string camera = R"("camera": {"position": [0, 2, 0], "target": [0, 1, -9]}, )";
  EXPECT_EQ(schema_.members_at(""), refused_members(R"("zzz": 1)"));
  EXPECT_EQ(schema_.members_at("/definitions/camera"), refused_members(R"("camera": {"zzz": 1})"));
  EXPECT_EQ(schema_.members_at("/definitions/environment"), refused_members(camera + R"("environment": {"zzz": 1})"));
  EXPECT_EQ(schema_.members_at("/definitions/environment/properties/moon"),
            refused_members(camera + R"("environment": {"moon": {"zzz": 1}})"));
  EXPECT_EQ(schema_.members_at("/definitions/placed_light"), refused_members(camera + R"("lights": [{"zzz": 1}])"));
  const std::string light = R"("lights": [{"light": "lamp.json", "position": [0, 3, 0], )";
  EXPECT_EQ(schema_.members_at("/definitions/cookie"), refused_members(camera + light + R"("cookie": {"zzz": 1}}])"));
  EXPECT_EQ(schema_.members_at("/definitions/repeat/items"),
            refused_members(camera + light + R"("repeat": [{"zzz": 1}]}])"));
  EXPECT_EQ(schema_.members_at("/definitions/city"), refused_members(camera + R"("city": {"zzz": 1})"));
  EXPECT_EQ(schema_.members_at("/definitions/scatter"),
            refused_members(camera + R"("objects": [{"model": "box", "scatter": {"zzz": 1}}])"));
}

// By itself, because each reading of a city builds it.
TEST_F(SceneSchema, LightsOfACityThatAreOffAreTheReaders) {
  const auto scene_without = [](const std::string& lights) {
    std::string kinds;
    for (const scene::CityLightKind& kind : scene::kCityLightKinds) {
      kinds += std::string(", \"") + kind.name + R"(": "lamp.json")";
    }
    return R"({"litfog": "scene", "version": 1, "camera": {"position": [0, 2, 0], "target": [0, 1, -9]}, )"
           R"("city": {"lights": 1, "without": )" +
           lights + kinds + "}}";
  };
  for (const char* right : {"[]", "[0, 99999]"}) {
    EXPECT_EQ(schema_.error_of(scene_without(right)), "") << right;
    EXPECT_EQ(refusal_of_(scene_without(right)), "") << right;
  }
  for (const char* wrong : {"0", "[-1]", "[0.5]", "[100000]", "[\"0\"]"}) {
    EXPECT_NE(schema_.error_of(scene_without(wrong)), "") << wrong;
    EXPECT_NE(refusal_of_(scene_without(wrong)), "") << wrong;
  }
}

TEST_F(SceneSchema, ModelsAreTheCatalogues) {
  std::size_t number = 0;
  for (const scene::ModelInfo& model : scene::models()) {
    std::set<std::string> members{"model", "position", "heading_deg", "scale", "repeat", "scatter"};
    const auto scene_with = [&model](std::string_view parameter, double value) {
      return R"({"litfog": "scene", "version": 1, "camera": {"position": [0, 2, 0], "target": [0, 1, -9]}, "objects": [{"model": ")" +
             std::string(model.name) + "\", \"" + std::string(parameter) + "\": " + fmt::format("{}", value) + "}]}";
    };
    for (const scene::ParameterInfo& parameter : model.parameters) {
      members.emplace(parameter.name);
      SCOPED_TRACE(std::string(model.name) + "." + std::string(parameter.name));
      for (const double value : {parameter.default_value, parameter.minimum, parameter.maximum}) {
        EXPECT_EQ(schema_.error_of(scene_with(parameter.name, value)), "") << value;
      }
      for (const double value : {parameter.minimum - 1, parameter.maximum + 1}) {
        EXPECT_NE(schema_.error_of(scene_with(parameter.name, value)), "") << value;
      }
      EXPECT_EQ(schema_.error_of(scene_with(parameter.name, parameter.minimum + 0.5)).empty(),
                !find_error(parameter, parameter.minimum + 0.5));
    }
    EXPECT_EQ(schema_.members_at(fmt::format("/definitions/object/allOf/{}/then", number++)), members);
  }
}

TEST_F(SceneSchema, SchemaRefusesWhatTheReaderRefusesAndNothingElse) {
  const auto is_across_members = [](const std::string& refusal) {
    return std::ranges::any_of(kRulesAcrossMembers,
                               [&](const char* rule) { return refusal.find(rule) != refusal.npos; });
  };
  EXPECT_GT(expect_same_refusals(schema_, refusal_of_, kScene, is_across_members), 500);
  const std::string with_phase_g =
      R"({"litfog": "scene", "version": 1, "camera": {"position": [0, 2, 0], "target": [0, 1, -9]},
    "phase_g": 0.5, "atmosphere": {"albedo": 1}, "objects": []})";
  EXPECT_GT(expect_same_refusals(schema_, refusal_of_, with_phase_g, is_across_members), 20);
  std::string with_both = with_phase_g;
  with_both.replace(with_both.find("\"albedo\": 1"), 11, "\"phase\": \"hg:0.5\"");
  EXPECT_NE(schema_.error_of(with_both), "");
  EXPECT_NE(refusal_of_(with_both), "");
}

}  // namespace
}  // namespace litfog::test
