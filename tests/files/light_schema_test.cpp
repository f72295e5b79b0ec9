// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "files/json_document.h"
#include "files/json_schema.h"
#include "files/light_json.h"
#include "litfog/files/light_file.h"
#include "litfog/input_error.h"

namespace litfog::test {
namespace {

/// The text of a light with every member.
std::string full_light(const Cone& cone) {
  return format_light({.name = "a",
                       .color = {1, 0.5, 0},
                       .attenuation = {1, 0.1, 0.01},
                       .cone = cone,
                       .density_scale = 0.4,
                       .source_radius = 0.1,
                       .flash = {2, 2, {{{0, 0.1, 5}, {0.5, 0.25}}}}},
                      {"a", "b"}, "{}");
}

/// What a reader says; nothing where it takes the text.
std::string refusal_of(const std::string& text) {
  try {
    const files::JsonValue root = files::parse_json(text, "f");
    files::expect_header(root, "light", 1);
    files::parse_light(root);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LightSchema, BundledLightsAreValid) {
  const auto errors = JsonSchema("light").errors_in("lights");
  EXPECT_GE(errors.size(), 20u);
  for (const auto& [file, error] : errors) EXPECT_EQ(error, "") << file;
}

TEST(LightSchema, SchemaHasTheReadersMembersAlone) {
  const JsonSchema schema("light");
  const std::string light = R"({"litfog": "light", "version": 1, "attenuation": {"constant": 1})";
  const auto refused_members = [&](const std::string& rest) { return members_in(refusal_of(light + rest + "}")); };
  EXPECT_EQ(schema.members_at("/definitions/light"), refused_members(R"(, "zzz": 1)"));
  for (const ConeProfileFacts& facts : kConeProfiles) {
    if (facts.parameters.empty()) continue;
    const std::string name = facts.name;
    EXPECT_EQ(schema.members_at("/definitions/" + name),
              refused_members(R"(, "cone": {"profile": ")" + name + R"(", "zzz": 1})"));
  }
  EXPECT_EQ(schema.members_at("/definitions/flash"), refused_members(R"(, "flash": {"zzz": 1})"));
  EXPECT_EQ(schema.members_at("/definitions/single_flash"),
            refused_members(R"(, "flash": {"period_s": 1, "flashes": [{"zzz": 1}]})"));
  EXPECT_EQ(schema.members_at("/definitions/attenuation"),
            members_in(refusal_of(R"({"litfog": "light", "version": 1, "attenuation": {"zzz": 1}})")));
}

TEST(LightSchema, SchemaRefusesWhatTheReaderRefusesAndNothingElse) {
  const JsonSchema schema("light");
  int refused = 0;
  for (const ConeProfileFacts& facts : kConeProfiles) {
    const std::string light = full_light(facts.first);
    EXPECT_EQ(refusal_of(light), "");
    EXPECT_EQ(schema.error_of(light), "");
    for (const std::string& text : changed_documents(light)) {
      const std::string refusal = refusal_of(text);
      // Rules across members are beyond the schema.
      if (refusal.find("must be in [0, outer_deg)") != refusal.npos) continue;
      if (refusal.find("not before the end") != refusal.npos && refusal.find("start_s = -") == refusal.npos) continue;
      if (refusal.find("must end within the period") != refusal.npos) continue;
      if (refusal.find("source_radius_m") != refusal.npos && refusal.find("attenuation") != refusal.npos) continue;
      EXPECT_EQ(schema.error_of(text).empty(), refusal.empty()) << text << "\n" << refusal << schema.error_of(text);
      if (!refusal.empty()) ++refused;
    }
  }
  EXPECT_GT(refused, 150);
}

}  // namespace
}  // namespace litfog::test
