// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

#include "command/temporary_directory.h"
#include "files/json_schema.h"
#include "fit/light_target.h"

namespace litfog::test {
namespace {

/// Between them they have every member.
constexpr std::array kSpecs{
    R"({"$schema": "s", "litfog": "light-spec", "version": 1, "name": "a", "source": ["a", "b"],
      "color": [1, 0.5, 0], "density_scale": 0.4,
      "source_radius_m": 0.1, "flash": {"period_s": 1, "flashes": [{"start_s": 0, "duration_s": 0.1, "intensity": 2}]},
      "range": {"threshold": 0.05, "extent_m": 120, "constant": 1,
                "samples": [{"range_m": 10, "attenuation": 0.8, "weight": 1}, {"range_m": 20, "attenuation": 0.5}]},
      "cone": {"profile": "best", "half_angle_deg": 45, "beam_angle_deg": 10, "field_angle_deg": 20,
               "samples": [{"angle_deg": 0, "intensity": 7, "weight": 1}, {"angle_deg": 18, "intensity": 2}]}})",
    R"({"litfog": "light-spec", "version": 1, "source": "a", "color_temperature_k": 3200,
      "range": {"end_lx": "night", "illuminance": {"range_m": 10, "lx": 120}, "family": "linear"}})",
    R"({"litfog": "light-spec", "version": 1, "range": {"end_lx": 2, "flux_lm": 900},
      "cone": {"beam_angle_deg": [12, 6], "field_angle_deg": [22, 10]}})",
    R"({"litfog": "light-spec", "version": 1, "range": {"peak_cd": 12000}, "cone": {"photometry": "lamp.csv"}})"};

/// What a schema cannot say: order, sums and other files.
constexpr std::array kRulesAcrossMembers{"must be larger than the one before",
                                         "must be greater than the range before it",
                                         "must be larger than the beam angle",
                                         "must be above the beam angle",
                                         "with weight",
                                         "must be a photometric file",
                                         "must be 0, or in [1e-30, 1e30]",
                                         "must be 0, or in [1e-100, 1e100]",
                                         "must be 0 or in [1e-100, 1e100]",
                                         "must be in (0, 90]",
                                         "not before the end of the flash before",
                                         "must end within the period",
                                         "for end_lx"};

class LightSpecSchema : public testing::Test {
 protected:
  LightSpecSchema() { directory_.write("lamp.csv", "candela,horizontal_deg,vertical_deg\n100,5,5\n"); }

  const JsonSchema schema_{"light-spec"};
  TemporaryDirectory directory_;
  const Refusal refusal_of_ = refusal_by([](const std::string& path) { fit::read_spec(path); }, directory_.path());
};

TEST_F(LightSpecSchema, BundledSpecsAreValid) { expect_bundled_valid(schema_, "specs", 20); }

TEST_F(LightSpecSchema, SchemaHasTheReadersMembersAlone) {
  const auto refused_members = [&](const std::string& rest) {
    return members_in(refusal_of_(R"({"litfog": "light-spec", "version": 1, )" + rest + "}"));
  };
  EXPECT_EQ(schema_.members_at(""), refused_members(R"("zzz": 1)"));
  EXPECT_EQ(schema_.members_at("/definitions/range"), refused_members(R"("range": {"zzz": 1})"));
  EXPECT_EQ(schema_.members_at("/definitions/illuminance"), refused_members(R"("range": {"illuminance": {"zzz": 1}})"));
  EXPECT_EQ(schema_.members_at("/definitions/range/properties/samples/items"),
            refused_members(R"("range": {"samples": [{"zzz": 1}]})"));
  EXPECT_EQ(schema_.members_at("/definitions/cone_spec"), refused_members(R"("cone": {"zzz": 1})"));
  EXPECT_EQ(schema_.members_at("/definitions/cone_spec/properties/samples/items"),
            refused_members(R"("cone": {"samples": [{"zzz": 1}]})"));
}

TEST_F(LightSpecSchema, SchemaRefusesWhatTheReaderRefusesAndNothingElse) {
  const auto is_across_members = [](const std::string& refusal) {
    return std::ranges::any_of(kRulesAcrossMembers,
                               [&](const char* rule) { return refusal.find(rule) != refusal.npos; });
  };
  int refused = 0;
  for (const char* spec : kSpecs) refused += expect_same_refusals(schema_, refusal_of_, spec, is_across_members);
  EXPECT_GT(refused, 400);
}

TEST_F(LightSpecSchema, RangesOfMembersThatDoNotGoTogetherAreRefused) {
  const std::string one = R"({"range_m": 10, "attenuation": 0.8})",
                    two = one + R"(, {"range_m": 20, "attenuation": 0.5})";
  for (const auto& [range, is_valid] : {std::pair<std::string, bool>{"", false},
                                        {R"("threshold": 0.1, "constant": 1)", false},
                                        {R"("samples": [])", false},
                                        {R"("samples": [)" + one + "]", false},
                                        {R"("samples": [)" + two + "]", true},
                                        {R"("samples": [)" + two + R"(], "family": "linear")", false},
                                        {R"("extent_m": 9, "samples": [)" + one + R"(], "family": "linear")", false},
                                        {R"("extent_m": 9, "samples": [)" + one + "]", true},
                                        {R"("extent_m": 9, "samples": [], "family": "linear")", true}}) {
    const std::string text = R"({"litfog": "light-spec", "version": 1, "range": {)" + range + "}}";
    EXPECT_EQ(schema_.error_of(text).empty(), is_valid) << text;
    EXPECT_EQ(refusal_of_(text).empty(), is_valid) << text << "\n" << refusal_of_(text);
  }
}

TEST_F(LightSpecSchema, EveryProfileIsValid) {
  for (const ConeProfileFacts& facts : kConeProfiles) {
    if (fitted_parameters(facts.profile).empty()) continue;
    const std::string text = R"({"litfog": "light-spec", "version": 1, "cone": {"beam_angle_deg": 9, "profile": ")" +
                             std::string(facts.name) + "\"}}";
    EXPECT_EQ(schema_.error_of(text), "") << text;
    EXPECT_EQ(refusal_of_(text), "") << text;
  }
}

TEST_F(LightSpecSchema, EveryNamedThresholdIsValid) {
  for (const VisualThreshold& threshold : kVisualThresholds) {
    const std::string text = R"({"litfog": "light-spec", "version": 1, "range": {"peak_cd": 1, "end_lx": ")" +
                             std::string(threshold.name) + "\"}}";
    EXPECT_EQ(schema_.error_of(text), "") << text;
    EXPECT_EQ(refusal_of_(text), "") << text;
  }
}

}  // namespace
}  // namespace litfog::test
