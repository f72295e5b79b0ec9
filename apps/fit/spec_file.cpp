// SPDX-License-Identifier: Apache-2.0
#include "fit/spec_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string_view>
#include <utility>

#include "command/angle_deg.h"
#include "command/exit_status.h"
#include "command/json_document.h"
#include "command/light_file.h"
#include "litfog/input_error.h"
#include "litfog/light.h"

using namespace litfog::command;

namespace {

using litfog::AttenuationFamily;
using litfog::AttenuationTarget;
using litfog::ConeChoice;
using litfog::ConeTarget;
using litfog::Luminaire;

/// Illuminance at which a photometric file's light ends: 1 lx, as for the lights of data/lights.
constexpr double kEndIlluminance = 1;

template <typename Choice, std::size_t kCount>
Choice choice_of(const JsonValue& value, const std::array<std::pair<std::string_view, Choice>, kCount>& choices) {
  std::string words;
  for (const auto& [word, choice] : choices) {
    if (value.string() == word) return choice;
    words += (words.empty() ? "" : ", ") + std::string(word);
  }
  value.fail("must be one of " + words);
}

std::optional<double> number_of(const JsonValue& value, std::string_view name) {
  const auto member = value.optional(name);
  return member ? std::optional(member->number()) : std::nullopt;
}

std::optional<double> angle_of(const JsonValue& value, std::string_view name) {
  const auto degrees = number_of(value, name);
  return degrees ? std::optional(radians(*degrees)) : std::nullopt;
}

/// The file's name for a target's field.
std::string member_name(std::string_view field) {
  if (field == "extent" || field == "range") return std::string(field) + "_m";
  if (field.ends_with("angle")) return std::string(field) + "_deg";
  return std::string(field);
}

/// A rule in the file's terms.
std::string rule_in_degrees(std::string rule) {
  for (const auto& [radians, degrees] : {std::pair{"2 pi", "360"}, {"pi/2", "90"}, {"pi", "180"}}) {
    if (const auto at = rule.find(radians); at != std::string::npos) {
      return rule.replace(at, std::string_view(radians).size(), degrees);
    }
  }
  return rule;
}

/// Refuses what a fit refuses, at the member that it came from, or at the nearest one that is given.
[[noreturn]] void fail(const JsonValue& target, const litfog::TargetError& error) {
  const auto& [field, value, rule] = error.error;
  JsonValue holder = target;
  if (error.sample) holder = target.member("samples").items()[*error.sample];
  const std::string name = member_name(field);
  const std::string rule_shown = name.ends_with("_deg") ? rule_in_degrees(rule) : rule;
  auto member = holder.optional(name);
  if (member && !member->is_array()) member->fail(rule_shown);
  if (!member && !error.sample) member = holder.optional("samples");  // what they lack together
  (member ? *member : holder).fail(holder.path() + "." + name, fmt::format("{}", value), rule_shown);
}

AttenuationTarget parse_range(const JsonValue& value) {
  value.allow_only({"threshold", "extent_m", "constant", "family", "samples"});
  AttenuationTarget target;
  target.threshold = value.number_or("threshold", target.threshold);
  target.extent = number_of(value, "extent_m");
  target.constant = number_of(value, "constant");
  if (const auto samples = value.optional("samples")) {
    for (const JsonValue& sample : samples->items()) {
      sample.allow_only({"range_m", "attenuation", "weight"});
      target.samples.push_back(
          {sample.member("range_m").number(), sample.member("attenuation").number(), sample.number_or("weight", 1)});
    }
  }
  if (const auto family = value.optional("family")) {
    constexpr std::array<std::pair<std::string_view, AttenuationFamily>, 3> kFamilies{
        {{"quadratic", AttenuationFamily::quadratic},
         {"linear", AttenuationFamily::linear},
         {"mixed", AttenuationFamily::mixed}}};
    target.family = choice_of(*family, kFamilies);
    if (!target.samples.empty()) family->fail("must not be given beside samples, which choose for themselves");
  }
  if (const auto refusal = check(target)) fail(value, *refusal);
  return target;
}

/// A file that is refused as a whole.
struct UnreadableFile : BadInput {
  using BadInput::BadInput;
};

Luminaire read_luminaire_file(const std::string& path) {
  try {
    return litfog::read_luminaire(path);
  } catch (const litfog::InputError& error) {
    if (error.location().line == 0) throw UnreadableFile(error.what());
    throw BadInput(error.what());
  }
}

std::vector<litfog::ConeSample> samples_of(const Luminaire& luminaire) {
  return cone_samples(axial_profile(luminaire.distribution, litfog::kPhotometricAxis));
}

AttenuationTarget range_of(const Luminaire& luminaire) {
  return {.extent = std::sqrt(find_peak(luminaire.distribution).intensity / kEndIlluminance)};
}

std::string sentence_on_range(const Luminaire& luminaire) {
  const double peak = find_peak(luminaire.distribution).intensity;
  return fmt::format(
      "Attenuation: C = 1 and no L; Q = (1/0.05 - 1)/E^2 puts the threshold 0.05 at E = sqrt({:.6g} cd / 1 lx) = "
      "{:.4g} "
      "m, where the lamp gives 1 lx.",
      peak, std::sqrt(peak / kEndIlluminance));
}

std::string sentence_on_cone(const std::string& file) {
  return fmt::format("Cone: fitted to {}, the mean over the turn about the photometric axis.", file);
}

void parse_cone(const JsonValue& value, std::optional<ConeChoice> choice, LightSpec& spec) {
  value.allow_only({"profile", "half_angle_deg", "beam_angle_deg", "field_angle_deg", "samples", "photometry"});
  ConeTarget& target = spec.cone.emplace();
  if (const auto profile = value.optional("profile")) {
    constexpr std::array<std::pair<std::string_view, ConeChoice>, 3> kProfiles{
        {{"best", ConeChoice::best}, {"cosine", ConeChoice::cosine}, {"smoothstep", ConeChoice::smoothstep}}};
    target.choice = choice_of(*profile, kProfiles);
  }
  target.choice = choice.value_or(target.choice);
  target.half_angle = angle_of(value, "half_angle_deg");
  target.beam_angle = angle_of(value, "beam_angle_deg");
  target.field_angle = angle_of(value, "field_angle_deg");
  if (const auto samples = value.optional("samples")) {
    for (const JsonValue& sample : samples->items()) {
      sample.allow_only({"angle_deg", "intensity", "weight"});
      target.samples.push_back({radians(sample.member("angle_deg").number()), sample.member("intensity").number(),
                                sample.number_or("weight", 1)});
    }
  }
  if (const auto photometry = value.optional("photometry")) {
    if (value.optional("samples")) photometry->fail("must not be given beside samples");
    const auto path = std::filesystem::path(spec.file).parent_path() / photometry->string();
    try {
      spec.luminaire = read_luminaire_file(path.string());
    } catch (const UnreadableFile& error) {
      photometry->fail(std::string("must be a photometric file: ") + error.what());
    }
    target.samples = samples_of(*spec.luminaire);
  }
  const auto refusal = check(target);
  if (!refusal) return;
  if (refusal->sample && spec.luminaire) value.member("photometry").fail(to_string(*refusal));
  fail(value, *refusal);
}

}  // namespace

LightSpec read_spec(const std::string& path, std::optional<ConeChoice> profile) {
  const JsonValue root = read_json(path);
  expect_header(root, "light-spec", 1);
  root.allow_only({"litfog", "version", "name", "source", "color", "density_scale", "range", "cone"});
  LightSpec spec{.file = path, .name = std::filesystem::path(path).stem().string()};
  if (const auto name = root.optional("name")) spec.name = name->string();
  if (const auto source = root.optional("source")) {
    const auto lines = source->is_array() ? source->items() : std::vector{*source};
    for (const JsonValue& line : lines) spec.source.push_back(line.string());
  }
  if (const auto color = root.optional("color")) spec.color = color->vec3();
  spec.density_scale = root.number_or("density_scale", spec.density_scale);
  litfog::Light light;
  light.color = spec.color;
  light.density_scale = spec.density_scale;
  if (const auto refusal = check(light)) fail_light(root, *refusal);

  const auto range = root.optional("range");
  const auto cone = root.optional("cone");
  if (!range && !cone) root.fail("range or cone", "", "must be given");
  if (range) spec.range = parse_range(*range);
  if (cone) parse_cone(*cone, profile, spec);
  if (spec.luminaire && !spec.range) {
    spec.range = range_of(*spec.luminaire);
    spec.source.push_back(sentence_on_range(*spec.luminaire));
  }
  return spec;
}

LightSpec read_photometric_spec(const std::string& path, ConeChoice profile) {
  LightSpec spec{.file = path, .name = std::filesystem::path(path).stem().string()};
  spec.luminaire = read_luminaire_file(path);
  const Luminaire& luminaire = *spec.luminaire;
  const std::string file = std::filesystem::path(path).filename().string();
  if (!luminaire.name.empty()) spec.name = luminaire.name;
  spec.source = {luminaire.manufacturer.empty() ? file : fmt::format("{}: {}", file, luminaire.manufacturer),
                 sentence_on_range(luminaire), sentence_on_cone(file)};
  spec.range = range_of(luminaire);
  spec.cone = ConeTarget{.choice = profile, .samples = samples_of(luminaire)};
  return spec;
}
