// SPDX-License-Identifier: Apache-2.0
#include "window/command_line.h"

#include <fmt/format.h>

#include <glm/glm.hpp>
#include <string_view>

#include "render/plan/lighting_path.h"

namespace litfog::window {
namespace {

using command::word_of;

/// Quotes a word for a POSIX shell.
std::string shell_word(std::string_view word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./,:=@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == word.npos) return std::string(word);
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? R"('\'')" : std::string(1, c);
  return text + "'";
}

std::string point(const glm::dvec3& p) { return fmt::format("{},{},{}", p.x, p.y, p.z); }

std::string contrast_word(double contrast) {
  return contrast == kContrastKoschmieder  ? "koschmieder"
         : contrast == kContrastFlightgear ? "flightgear"
                                           : fmt::format("{}", contrast);
}

}  // namespace

std::string to_string(const DrawingCommand& command) {
  const drawing::DrawingOptions& options = command.options;
  const drawing::DrawingOptions usual;
  const render::LightingPath& path = *options.render.path;
  const render::RenderSettings drawn = options.settings();
  const bool is_airlight = drawn.fog_lighting == render::FogLighting::airlight;
  std::string text = "litfog-demo " + shell_word(command.scene);
  const auto add = [&text](bool is_given, const std::string& option, const std::string& value = "") {
    if (is_given) text += " " + option + (value.empty() ? "" : " " + shell_word(value));
  };
  add(!options.fog, "--fog", "none");
  add(options.fog == FogMode::exp2, "--fog", "exp2");
  if (options.fog) {
    add(options.visibility.has_value(), "--visibility", fmt::format("{}", options.visibility.value_or(0)));
    add(options.contrast != usual.contrast, "--contrast", contrast_word(options.contrast));
    add(!options.layers_file.empty(), "--layers", options.layers_file);
    add(is_airlight && !options.phase.empty(), "--phase", options.phase);
    add(is_airlight && options.albedo, "--albedo", fmt::format("{}", options.albedo.value_or(1)));
  }
  add(&path != usual.render.path, "--path", std::string(path.name));
  const bool has_maps = path.maps != render::LightMapSet::none;
  const render::PaperSettings& papers = drawn.papers;
  add(has_maps && papers.map_size != usual.render.papers.map_size, "--map-size", fmt::format("{}", papers.map_size));
  add(has_maps && papers.cone_maps != usual.render.papers.cone_maps, "--cone-maps",
      word_of(drawing::kConeMaps, papers.cone_maps));
  const bool is_lookup = drawing::is_hales_lookup(path);
  add(is_lookup && papers.is_flat_shaded, "--flat-shading");
  add(is_lookup && papers.light_ambient != 0, "--light-ambient", fmt::format("{}", papers.light_ambient));
  add(path.surface == render::SurfaceModel::basic && papers.has_infinite_viewer, "--infinite-viewer");
  add(path.takes_airlight && options.fog_light, "--fog-light", word_of(drawing::kFogLights, drawn.fog_lighting));
  add(is_airlight && options.scattering, "--scattering", word_of(drawing::kScatterings, drawn.scattering));
  if (drawn.shadows != render::Shadows::none) {
    add(true, "--shadows", word_of(drawing::kShadows, drawn.shadows));
    add(drawn.shadow_lamps != usual.render.shadow_lamps, "--shadow-lamps", fmt::format("{}", drawn.shadow_lamps));
    add(drawn.shadow_map_size != usual.render.shadow_map_size, "--shadow-map-size",
        fmt::format("{}", drawn.shadow_map_size));
  }
  add(options.seconds != 0, "--time", fmt::format("{}", options.seconds));
  if (const auto& exposure = options.display.exposure) {
    add(true, "--exposure", exposure->is_auto ? "auto" : fmt::format("{}", exposure->ev));
  }
  if (options.display.tone) add(true, "--tone", word_of(drawing::kTones, *options.display.tone));
  if (options.display.glare) add(true, "--glare", word_of(drawing::kGlares, *options.display.glare));
  add(drawn.samples != usual.render.samples, "--samples", fmt::format("{}", drawn.samples));
  add(options.render.skipping == render::Skipping::off, "--no-skip");
  if (command.camera) {
    add(true, "--camera", point(command.camera->position));
    add(true, "--target", point(command.camera->target));
    add(true, "--fov-deg", fmt::format("{:.7g}", glm::degrees(command.camera->field_of_view)));
  }
  for (const scene::SceneChange& change : command.changes) add(true, "--set", change.member + "=" + change.value);
  add(command.is_lit_by_lamps_alone, "--lamps-only");
  add(true, "--size", fmt::format("{}x{}", options.width, options.height));
  return text;
}

}  // namespace litfog::window
