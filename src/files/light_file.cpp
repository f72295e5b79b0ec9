// SPDX-License-Identifier: Apache-2.0
#include "litfog/files/light_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

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
  Cone cone{.profile = *parse_profile(value.member("profile"))};
  std::vector<std::string_view> names{"profile"};
  for (const ConeParameter& parameter : facts_of(cone.profile).parameters) names.emplace_back(parameter.file_name);
  value.allow_only(names);
  for (const ConeParameter& parameter : facts_of(cone.profile).parameters) {
    const double number = value.member(parameter.file_name).number();
    cone.*parameter.member = parameter.is_angle ? snapped(radians(number), 0, parameter.most) : number;
  }
  return cone;
}

std::string flash_json(const Flash& flash) {
  std::string flashes;
  for (std::size_t i = 0; i < flash.count; ++i) {
    const auto& [start, duration, intensity] = flash.flashes[i];
    flashes += fmt::format("{}{{\"start_s\": {}, \"duration_s\": {}, \"intensity\": {}}}", i > 0 ? ", " : "", start,
                           duration, intensity);
  }
  return fmt::format("{{\"period_s\": {}, \"flashes\": [{}]}}", flash.period, flashes);
}

void check_source(const JsonValue& source) {
  if (!source.is_array()) {
    source.string();
    return;
  }
  for (const JsonValue& item : source.items()) item.string();
}

}  // namespace

std::optional<ConeProfile> parse_profile(const JsonValue& value, std::vector<std::string_view> words) {
  const std::string name = value.string();
  if (std::ranges::find(words, name) != words.end()) return std::nullopt;
  for (const ConeProfileFacts& facts : kConeProfiles) {
    if (facts.parameters.empty()) continue;  // a point light has no cone
    if (facts.name == name) return facts.profile;
    words.emplace_back(facts.name);
  }
  value.fail_choice(words);
}

std::string cone_json(const Cone& cone) {
  std::string members = fmt::format("\"profile\": \"{}\"", facts_of(cone.profile).name);
  for (const ConeParameter& parameter : facts_of(cone.profile).parameters) {
    members += fmt::format(", \"{}\": {}", parameter.file_name, file_value(cone, parameter));
  }
  return "{" + members + "}";
}

void fail_light(const JsonValue& light, const ValueError& error) {
  std::string path = error.field;
  std::string_view rule = error.rule;
  if (path == "source_radius") path = "source_radius_m";
  if (path.starts_with("flash.") && !path.ends_with("intensity")) path += "_s";
  for (const ConeProfileFacts& facts : kConeProfiles) {
    for (const ConeParameter& parameter : facts.parameters) {
      if (error.field != std::string_view(parameter.field)) continue;
      path = std::string("cone.") + parameter.file_name;
      rule = parameter.rule_in_file;
    }
  }
  JsonValue value = light;
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string_view step = std::string_view(path).substr(begin, end - begin);
    const std::string_view name = step.substr(0, step.find('['));
    if (value.is_array()) {
      value = value.items()[std::string_view("rgb").find(name)];
    } else if (const auto member = value.optional(name)) {
      value = name == step ? *member : member->items()[std::size_t(step[name.size() + 1] - '0')];
    } else {  // wrong because it is absent, which is 0
      value.fail(value.path_of(name), "0", rule);
    }
    begin = end + 1;
  }
  value.fail(rule);
}

Flash parse_flash(const JsonValue& value) {
  value.allow_only({"period_s", "flashes"});
  Flash flash{.period = value.member("period_s").number()};
  const JsonValue flashes = value.member("flashes");
  const std::vector<JsonValue> items = flashes.items();
  if (items.empty() || items.size() > kMaxFlashes) flashes.fail("must hold 1 to 8 flashes");
  for (const JsonValue& item : items) {
    item.allow_only({"start_s", "duration_s", "intensity"});
    flash.flashes[flash.count++] = {item.member("start_s").number(), item.member("duration_s").number(),
                                    item.number_or("intensity", 1)};
  }
  return flash;
}

Light parse_light(const JsonValue& value) {
  value.allow_only({"litfog", "version", "name", "source", "color", "attenuation", "threshold", "cone", "density_scale",
                    "source_radius_m", "flash", "fit"});
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
  light.source_radius = value.number_or("source_radius_m", light.source_radius);
  if (const auto flash = value.optional("flash")) light.flash = parse_flash(*flash);

  if (const auto error = find_error(light)) fail_light(value, *error);
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
  if (!light.cone.is_point_light()) members.push_back("\"cone\": " + files::cone_json(light.cone));
  if (light.density_scale != 1) members.push_back(fmt::format("\"density_scale\": {}", light.density_scale));
  if (light.source_radius != 0) members.push_back(fmt::format("\"source_radius_m\": {}", light.source_radius));
  if (light.flash.count > 0) members.push_back("\"flash\": " + files::flash_json(light.flash));
  if (!fit.empty()) members.push_back(fmt::format("\"fit\": {}", fit));
  return files::json_object(members) + "\n";
}

void write_light(const std::string& path, const Light& light, const std::vector<std::string>& source) {
  require(find_error(light));
  files::write_whole_file(path, format_light(light, source));
}

}  // namespace litfog
