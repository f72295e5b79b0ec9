// SPDX-License-Identifier: Apache-2.0
#include "litfog/files/light_spec_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <utility>

#include "files/angle_deg.h"
#include "files/json_document.h"
#include "files/light_json.h"
#include "litfog/color_temperature.h"
#include "litfog/light.h"
#include "model/float_limit.h"
#include "model/require.h"

namespace litfog {

struct LightSpecText {
  files::JsonValue root;
};

namespace files {
namespace {

RangeSpec::Family family_of(const JsonValue& value) {
  using Families = std::pair<std::string_view, RangeSpec::Family>;
  constexpr std::array<Families, 3> kFamilies{{{"quadratic", RangeSpec::Family::quadratic},
                                               {"linear", RangeSpec::Family::linear},
                                               {"mixed", RangeSpec::Family::mixed}}};
  const auto found = std::ranges::find(kFamilies, value.string(), &Families::first);
  if (found != kFamilies.end()) return found->second;
  value.fail_choice({kFamilies[0].first, kFamilies[1].first, kFamilies[2].first});
}

std::optional<double> number_of(const JsonValue& value, std::string_view name) {
  const auto member = value.optional(name);
  return member ? std::optional(member->number()) : std::nullopt;
}

std::optional<double> angle_of(const JsonValue& value, std::string_view name) {
  const auto degrees = number_of(value, name);
  return degrees ? std::optional(radians(*degrees)) : std::nullopt;
}

/// A full angle, or a pair of them, horizontal and vertical.
std::optional<FullAngles> angles_of(const JsonValue& value, std::string_view name) {
  const auto member = value.optional(name);
  if (!member) return std::nullopt;
  constexpr const char* kRule = "must be a number, or an array of two: horizontal and vertical";
  if (member->is_object()) member->fail(kRule);
  if (!member->is_array()) return FullAngles(radians(member->number()));
  const auto angles = member->items();
  if (angles.size() != 2) member->fail(kRule);
  return FullAngles(radians(angles[0].number()), radians(angles[1].number()));
}

double positive_number(const JsonValue& value) {
  if (!(value.number() > 0)) value.fail("must be > 0");
  return value.number();
}

double parse_end_illuminance(const JsonValue& value) {
  if (!value.is_string()) return positive_number(value);
  const auto threshold = std::ranges::find(kVisualThresholds, value.string(), &VisualThreshold::name);
  if (threshold != kVisualThresholds.end()) return threshold->illuminance;
  std::vector<std::string_view> names;
  for (const VisualThreshold& known : kVisualThresholds) names.push_back(known.name);
  value.fail_choice(names);
}

void parse_end(const JsonValue& value, RangeSpec& range) {
  std::vector<JsonValue> peaks;  // members that state the peak; one is enough
  for (const char* name : {"peak_cd", "illuminance", "flux_lm"}) {
    if (const auto peak = value.optional(name)) peaks.push_back(*peak);
  }
  const auto end = value.optional("end_lx");
  if (range.extent && (end || !peaks.empty())) {
    value.member("extent_m").fail("must not be given beside end_lx, peak_cd, illuminance or flux_lm");
  }
  if (peaks.size() > 1) peaks[1].fail(fmt::format("must not be given beside {}", peaks[0].name()));
  if (end) range.end_illuminance = parse_end_illuminance(*end);
  if (const auto peak = value.optional("peak_cd")) range.peak = positive_number(*peak);
  if (const auto flux = value.optional("flux_lm")) range.flux = positive_number(*flux);
  if (const auto illuminance = value.optional("illuminance")) {
    const bool is_table = illuminance->is_array() && !illuminance->items().empty();
    if (!illuminance->is_object() && !is_table) {
      illuminance->fail("must be an object of range_m and lx, or an array of them, the rows of a table");
    }
    for (const JsonValue& row : is_table ? illuminance->items() : std::vector{*illuminance}) {
      row.allow_only({"range_m", "lx"});
      const double metres = positive_number(row.member("range_m"));
      if (std::ranges::count(range.illuminance, metres, &RangeSpec::Illuminance::range) > 0) {
        row.member("range_m").fail("must not be the range of a row before it");
      }
      range.illuminance.push_back({.range = metres, .lux = positive_number(row.member("lx"))});
    }
  }
}

RangeSpec parse_range(const JsonValue& value) {
  value.allow_only(
      {"threshold", "extent_m", "end_lx", "peak_cd", "illuminance", "flux_lm", "constant", "family", "samples"});
  RangeSpec range;
  range.threshold = value.number_or("threshold", range.threshold);
  range.extent = number_of(value, "extent_m");
  parse_end(value, range);
  range.constant = number_of(value, "constant");
  if (const auto samples = value.optional("samples")) {
    for (const JsonValue& sample : samples->items()) {
      sample.allow_only({"range_m", "attenuation", "weight"});
      const double weight = sample.number_or("weight", 1);
      range.samples.push_back({sample.member("range_m").number(), sample.member("attenuation").number(), weight});
    }
  }
  if (const auto family = value.optional("family")) {
    range.family = family_of(*family);
    if (!range.samples.empty()) family->fail("must not be given beside samples, which choose for themselves");
  }
  return range;
}

ConeSpec parse_cone_spec(const JsonValue& value) {
  value.allow_only({"profile", "half_angle_deg", "beam_angle_deg", "field_angle_deg", "samples", "photometry"});
  ConeSpec cone;
  if (const auto profile = value.optional("profile")) cone.profile = parse_profile(*profile, {"best"});
  cone.half_angle = angle_of(value, "half_angle_deg");
  cone.beam_angle = angles_of(value, "beam_angle_deg");
  cone.field_angle = angles_of(value, "field_angle_deg");
  for (const char* name : {"beam_angle_deg", "field_angle_deg"}) {
    const auto angles = value.optional(name);
    if (!angles || !angles->is_array()) continue;
    for (const char* data : {"samples", "photometry"}) {
      if (value.optional(data)) angles->fail(fmt::format("must be one number beside {}", data));
    }
  }
  if (const auto samples = value.optional("samples")) {
    for (const JsonValue& sample : samples->items()) {
      sample.allow_only({"angle_deg", "intensity", "weight"});
      cone.samples.push_back({radians(sample.member("angle_deg").number()), sample.member("intensity").number(),
                              sample.number_or("weight", 1)});
    }
  }
  if (const auto photometry = value.optional("photometry")) {
    if (value.optional("samples")) photometry->fail("must not be given beside samples");
    cone.photometry = (std::filesystem::path(value.file()).parent_path() / photometry->string()).string();
  }
  return cone;
}

LightSpec parse_spec(const JsonValue& root) {
  expect_header(root, "light-spec", 1);
  root.allow_only({"litfog", "version", "name", "source", "color", "color_temperature_k", "density_scale",
                   "source_radius_m", "flash", "range", "cone"});
  LightSpec spec{.file = root.file(), .name = std::filesystem::path(root.file()).stem().string()};
  if (const auto name = root.optional("name")) spec.name = name->string();
  if (const auto source = root.optional("source")) {
    const auto lines = source->is_array() ? source->items() : std::vector{*source};
    for (const JsonValue& line : lines) spec.source.push_back(line.string());
  }
  const auto color = root.optional("color");
  if (color) spec.color = color->vec3();
  if (const auto temperature = root.optional("color_temperature_k")) {
    if (color) temperature->fail("must not be given beside color");
    const double kelvin = temperature->number();
    if (!is_within(kelvin, kMinColorTemperature, kMaxColorTemperature)) {
      temperature->fail(fmt::format("must be in [{}, {}]", kMinColorTemperature, kMaxColorTemperature));
    }
    spec.color_temperature = kelvin;
    spec.color = color_of_temperature(kelvin);
    spec.color /= luminance(spec.color);
  }
  spec.density_scale = root.number_or("density_scale", spec.density_scale);
  if (const auto radius = root.optional("source_radius_m")) {
    spec.source_radius = radius->number();
    if (!is_finite_and_not_negative(*spec.source_radius)) radius->fail("must be finite and >= 0");
  }
  if (const auto flash = root.optional("flash")) spec.flash = parse_flash(*flash);
  Light light;
  light.color = spec.color;
  light.density_scale = spec.density_scale;
  light.flash = spec.flash;
  if (const auto error = find_error(light)) fail_light(root, *error);

  const auto range = root.optional("range");
  const auto cone = root.optional("cone");
  if (!range && !cone) root.fail("range or cone", "", "must be given");
  if (range) spec.range = parse_range(*range);
  if (cone) spec.cone = parse_cone_spec(*cone);
  spec.text = std::make_shared<const LightSpecText>(LightSpecText{root});
  return spec;
}

/// The file's name for a field of a range or a cone.
std::string member_name(std::string_view field) {
  using Names = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Names, 5> kNames{{{"extent", "extent_m"},
                                                {"end_illuminance", "end_lx"},
                                                {"peak", "peak_cd"},
                                                {"flux", "flux_lm"},
                                                {"range", "range_m"}}};
  if (field.ends_with("angle")) return std::string(field) + "_deg";
  const auto found = std::ranges::find(kNames, field, &Names::first);
  return std::string(found == kNames.end() ? field : found->second);
}

/// A step of a path to a value: a member, and an item if it is an array.
struct Step {
  std::string name;  // the file's
  std::optional<std::size_t> index;
};

/// "range.samples[3].range" as range, samples[3], range_m.
std::vector<Step> steps_of(std::string_view field) {
  std::vector<Step> steps;
  while (!field.empty()) {
    const std::string_view word = field.substr(0, field.find('.'));
    field.remove_prefix(std::min(word.size() + 1, field.size()));
    const std::string_view name = word.substr(0, word.find('['));
    Step& step = steps.emplace_back(Step{steps.empty() ? std::string(name) : member_name(name), {}});
    if (name.size() == word.size()) continue;
    std::size_t index = 0;
    std::from_chars(word.data() + name.size() + 1, word.data() + word.size(), index);
    step.index = index;
  }
  return steps;
}

/// A rule in the file's terms.
std::string rule_in_degrees(std::string_view rule) {
  std::string result(rule);
  for (const auto& [radians, degrees] : {std::pair{"2 pi", "360"}, {"pi/2", "90"}, {"pi", "180"}}) {
    if (const auto at = result.find(radians); at != result.npos) {
      result.replace(at, std::string_view(radians).size(), degrees);
      break;
    }
  }
  return result;
}

}  // namespace
}  // namespace files

InputError LightSpec::error_at(std::string_view field, std::string_view value, std::string_view rule) const {
  files::JsonValue given = text->root;  // the innermost value in the file on the path to the field
  std::string path;                     // path of the field
  bool is_complete = true;
  for (const files::Step& step : files::steps_of(field)) {
    path += (path.empty() ? "" : ".") + step.name;
    if (step.index) path += fmt::format("[{}]", *step.index);
    const auto member = is_complete && given.is_object() ? given.optional(step.name) : std::nullopt;
    is_complete = member.has_value();
    if (member) given = step.index ? member->items().at(*step.index) : *member;
  }
  const std::string shown_rule = path.find("_deg") != path.npos ? files::rule_in_degrees(rule) : std::string(rule);
  if (is_complete && !given.is_array()) return given.error(shown_rule);
  // A member that a range or a cone lacks is missing in its samples.
  const bool is_part = given.path() == "range" || given.path() == "cone";
  if (const auto samples = is_part ? given.optional("samples") : std::nullopt) given = *samples;
  return given.error(path, value, shown_rule);
}

LightSpec read_light_spec(const std::string& path) { return files::parse_spec(files::read_json(path)); }

}  // namespace litfog
