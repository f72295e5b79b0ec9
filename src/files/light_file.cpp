// SPDX-License-Identifier: Apache-2.0
#include "litfog/files/light_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <numbers>
#include <string_view>

#include "files/angle_deg.h"
#include "files/json_document.h"
#include "files/json_text.h"
#include "files/light_json.h"
#include "files/whole_file.h"
#include "model/float_limit.h"
#include "model/require.h"

namespace litfog {
namespace files {
namespace {

Cone parse_cone(const JsonValue& value) {
  const JsonValue profile = value.member("profile");
  if (profile.string() == "cosine") {
    value.allow_only({"profile", "half_angle_deg", "exponent"});
    return Cone::cosine(snapped(radians(value.member("half_angle_deg").number()), 0, std::numbers::pi / 2),
                        value.member("exponent").number());
  }
  if (profile.string() == "smoothstep") {
    value.allow_only({"profile", "inner_deg", "outer_deg"});
    return Cone::smoothstep(radians(value.member("inner_deg").number()),
                            snapped(radians(value.member("outer_deg").number()), 0, std::numbers::pi));
  }
  profile.fail("must be \"cosine\" or \"smoothstep\"");
}

void check_source(const JsonValue& source) {
  if (!source.is_array()) {
    source.string();
    return;
  }
  for (const JsonValue& item : source.items()) item.string();
}

/// Where the file's terms differ from the model's.
struct FileTerm {
  std::string_view field;
  std::string_view path;
  std::string_view rule;
};
constexpr std::array<FileTerm, 3> kFileTerms{{
    {"cone.half_angle", "cone.half_angle_deg", "must be in (0, 90]"},
    {"cone.inner", "cone.inner_deg", "must be in [0, outer_deg)"},
    {"cone.outer", "cone.outer_deg", "must be in (0, 180]"},
}};

std::string cone_json(const Cone& cone) {
  if (cone.profile == ConeProfile::cosine) {
    return fmt::format("{{\"profile\": \"cosine\", \"half_angle_deg\": {}, \"exponent\": {}}}",
                       degrees(cone.half_angle), cone.exponent);
  }
  return fmt::format("{{\"profile\": \"smoothstep\", \"inner_deg\": {}, \"outer_deg\": {}}}", degrees(cone.inner),
                     degrees(cone.outer));
}

}  // namespace

void fail_light(const JsonValue& light, const ValueError& error) {
  FileTerm term{error.field, error.field, error.rule};
  for (const FileTerm& candidate : kFileTerms) {
    if (candidate.field == term.field) term = candidate;
  }
  JsonValue value = light;
  for (std::size_t begin = 0; begin < term.path.size();) {
    const std::size_t end = std::min(term.path.find('.', begin), term.path.size());
    const std::string_view name = term.path.substr(begin, end - begin);
    if (value.is_array()) {
      value = value.items()[std::string_view("rgb").find(name)];
    } else if (const auto member = value.optional(name)) {
      value = *member;
    } else {  // wrong because it is absent, which is 0
      value.fail(value.path_of(name), "0", term.rule);
    }
    begin = end + 1;
  }
  value.fail(term.rule);
}

Light parse_light(const JsonValue& value) {
  value.allow_only(
      {"litfog", "version", "name", "source", "color", "attenuation", "threshold", "cone", "density_scale", "fit"});
  if (value.optional("litfog") || value.optional("version")) expect_header(value, "light", 1);
  if (const auto source = value.optional("source")) check_source(*source);

  Light light;
  if (const auto name = value.optional("name")) light.name = name->string();
  if (const auto color = value.optional("color")) light.color = color->vec3();
  const JsonValue attenuation = value.member("attenuation");
  attenuation.allow_only({"constant", "linear", "quadratic"});
  light.attenuation = {attenuation.number_or("constant", 0), attenuation.number_or("linear", 0),
                       attenuation.number_or("quadratic", 0)};
  light.threshold = value.number_or("threshold", light.threshold);
  if (const auto cone = value.optional("cone")) light.cone = parse_cone(*cone);
  light.density_scale = value.number_or("density_scale", light.density_scale);

  if (const auto error = check(light)) fail_light(value, *error);
  return light;
}

}  // namespace files

Light read_light(const std::string& path) {
  const files::JsonValue root = files::read_json(path);
  files::expect_header(root, "light", 1);
  Light light = files::parse_light(root);
  if (light.name.empty()) light.name = std::filesystem::path(path).stem().string();
  return light;
}

std::string format_light(const Light& light, const std::vector<std::string>& source, std::string_view fit) {
  std::vector<std::string> members{"\"litfog\": \"light\"", "\"version\": 1",
                                   "\"name\": " + files::json_quoted(light.name)};
  if (!source.empty()) {
    std::vector<std::string> lines;
    for (const std::string& line : source) lines.push_back(files::json_quoted(line));
    members.push_back("\"source\": " + files::json_array(lines, 1));
  }
  members.push_back(fmt::format("\"color\": [{}, {}, {}]", light.color.r, light.color.g, light.color.b));
  const auto& [constant, linear, quadratic] = light.attenuation;
  members.push_back(fmt::format("\"attenuation\": {{\"constant\": {}, \"linear\": {}, \"quadratic\": {}}}", constant,
                                linear, quadratic));
  members.push_back(fmt::format("\"threshold\": {}", light.threshold));
  if (light.cone.profile != ConeProfile::none) members.push_back("\"cone\": " + files::cone_json(light.cone));
  if (light.density_scale != 1) members.push_back(fmt::format("\"density_scale\": {}", light.density_scale));
  if (!fit.empty()) members.push_back(fmt::format("\"fit\": {}", fit));
  return files::json_object(members) + "\n";
}

void write_light(const std::string& path, const Light& light, const std::vector<std::string>& source) {
  require(check(light));
  files::write_whole_file(path, format_light(light, source));
}

}  // namespace litfog
