// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "files/json_document.h"
#include "files/json_schema.h"
#include "files/light_json.h"
#include "litfog/files/light_file.h"
#include "litfog/input_error.h"

namespace litfog::test {
namespace {

/// The text of a light with every member.
std::string full_light(const Cone& cone) {
  std::string text = format_light({.name = "a",
                                   .color = {1, 0.5, 0},
                                   .attenuation = {1, 0.1, 0.01},
                                   .cone = cone,
                                   .density_scale = 0.4,
                                   .source_radius = 0.1,
                                   .flash = {2, 2, {{{0, 0.1, 5}, {0.5, 0.25}}}}},
                                  {"a", "b"}, "{}");
  return text.insert(text.find("\"litfog\""), R"("$schema": "s", )");
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

TEST(LightSchema, BundledLightsAreValid) { expect_bundled_valid(JsonSchema("light"), "lights", 20); }

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
  const auto is_across_members = [](const std::string& refusal) {
    const auto has = [&](const char* part) { return refusal.find(part) != refusal.npos; };
    return has("must be in [0, outer_deg)") || has("must end within the period") ||
           (has("not before the end") && !has("start_s = -")) || (has("source_radius_m") && has("attenuation"));
  };
  int refused = 0;
  for (const ConeProfileFacts& facts : kConeProfiles) {
    refused += expect_same_refusals(schema, refusal_of, full_light(facts.first), is_across_members);
  }
  EXPECT_GT(refused, 150);
}

}  // namespace
}  // namespace litfog::test
