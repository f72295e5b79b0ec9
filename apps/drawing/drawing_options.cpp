// SPDX-License-Identifier: Apache-2.0
#include "drawing/drawing_options.h"

#include <fmt/format.h>

#include <functional>
#include <limits>

#include "command/command.h"
#include "command/number.h"
#include "command/runway_lights.h"
#include "litfog/files/phase_name.h"
#include "litfog/multiple_scattering.h"
#include "render/plan/lighting_path.h"
#include "scene/file/fog_layers.h"

namespace litfog::drawing {
namespace {

constexpr int kMaxSide = 16'384;
constexpr command::NumberRule kFraction{[](double x) { return x >= 0 && x <= 1; }, "must be a number in [0, 1]", 0, 1};
constexpr std::int64_t kMaxPixels = 40'000'000;  // about 3 GiB, 5 with airlight

void parse_size(const std::string& text, DrawingOptions& options) {
  const auto cross = text.find('x');
  const auto width = command::parse_integer(std::string_view(text).substr(0, cross));
  const auto height =
      cross == std::string::npos ? std::nullopt : command::parse_integer(std::string_view(text).substr(cross + 1));
  const bool is_side = width && height && *width >= 1 && *height >= 1 && *width <= kMaxSide && *height <= kMaxSide;
  if (!is_side || std::int64_t(*width) * *height > kMaxPixels) {
    command::fail_option(
        "--size", text,
        fmt::format("must be WIDTHxHEIGHT, each in [1, {}], at most {} pixels in all", kMaxSide, kMaxPixels));
  }
  options.width = *width;
  options.height = *height;
}

/// command::add_number for an option without a default, whose target is made from a number.
///
/// then  called afterwards
template <typename Target>
void add_number(
    CLI::App& app, const std::string& name, std::optional<Target>& target, command::NumberRule rule,
    const std::string& description, const std::function<void()>& then = [] {}) {
  const auto parse = [&target, name, rule, then](const std::string& text) {
    const auto number = command::parse_number(text, rule);
    if (!number) command::fail_option(name, text, rule.text);
    target = Target{*number};
    then();
  };
  app.add_option_function<std::string>(name, parse, description)->type_name("NUMBER");
}

void add_layers(CLI::App& app, DrawingOptions& options) {
  app.add_option_function<std::string>(
         "--layers", [&options](const std::string& text) { take_layers(options, text); },
         "Layers of fog instead of the scene's, from a file with an array like atmosphere.layers of a scene file; "
         "--visibility is then the one outside them (default inf)")
      ->type_name("FILE|none");
}

void add_phase(CLI::App& app, DrawingOptions& options) {
  const auto add_named = [&](const std::string& option, const char* type, const std::string& prefix,
                             const std::string& description) {
    const auto parse = [&options, option, prefix](const std::string& text) {
      if (!files::phase_named(prefix + text))
        command::fail_option(option, text, prefix.empty() ? files::kPhaseRule : kAsymmetryRule);
      options.phase = prefix + text;
    };
    return app.add_option_function<std::string>(option, parse, description)->type_name(type);
  };
  CLI::Option* const phase = add_named("--phase", "PHASE", "",
                                       "With airlight: phase function of the fog, instead of the scene's: isotropic, "
                                       "rayleigh (air), hg:G (Henyey and Greenstein, G near 1 scatters straight "
                                       "ahead), draine:G,ALPHA (Draine), a sum of two of these such as "
                                       "0.7*hg:0.8+0.3*hg:-0.2, or droplets:D (water droplets of 5 to 50 micrometres; "
                                       "default droplets:10 in exp fog, isotropic in exp2)");
  add_named("--phase-g", "NUMBER", "hg:", "Shorthand for --phase hg:NUMBER")->excludes(phase);
  add_number(app, "--albedo", options.albedo, kFraction,
             "With airlight: the fog's albedo, scattering over extinction, instead of the scene's; below 1, light that "
             "is scattered twice or more is left out (--scattering single)");
}

std::vector<std::pair<std::string, const render::LightingPath*>> path_names() {
  std::vector<std::pair<std::string, const render::LightingPath*>> names;
  for (const render::LightingPath& path : render::all_paths()) names.emplace_back(path.name, &path);
  return names;
}

/// Why a path takes neither airlight nor shadows.
const char* why_without_airlight(const render::LightingPath& path) {
  return path.evaluation == render::Evaluation::vertex ? "its lamps do not light each fragment"
                                                       : "it is as its paper prints it";
}

}  // namespace

const command::NumberRule kSeconds{[](double x) { return x >= 0 && x <= scene::kMaxSeconds; },
                                   "must be a number in [0, 1e9]", 0, scene::kMaxSeconds};

double DrawingOptions::visibility_in(const scene::Scene& scene) const {
  if (!fog) return std::numeric_limits<double>::infinity();
  if (runway_visual_range) return visibility_of_runway_visual_range(*runway_visual_range);
  if (visibility) return *visibility;
  const bool has_layers = layers && !layers->empty();
  return has_layers ? std::numeric_limits<double>::infinity() : scene::suggested_visibility(scene);
}

double DrawingOptions::visibility_of_runway_visual_range(double metres) const {
  return litfog::visibility(fog_from_runway_visual_range(fog_mode(), metres, runway_lights), contrast);
}

render::RenderSettings DrawingOptions::settings_of(const render::LightingPath& path) const {
  const bool is_default = &path == &render::lighting_paths().front();
  const auto own = is_default ? render::FogLighting::airlight : render::FogLighting::peak;
  render::RenderSettings settings = render;
  settings.path = &path;
  settings.fog_lighting = path.takes_airlight ? fog_light.value_or(own) : render::FogLighting::peak;
  settings.scattering = scattering.value_or(render::Scattering::all);
  if (!path.takes_airlight) settings.shadows = render::Shadows::none;
  const bool is_peak = settings.fog_lighting == render::FogLighting::peak;
  if (is_peak && settings.shadows == render::Shadows::shafts) settings.shadows = render::Shadows::surfaces;
  settings.has_eye_threshold = display.glare_of(settings.fog_lighting) == Glare::eye;
  return settings;
}

Atmosphere DrawingOptions::atmosphere_of(const scene::Scene& scene, double metres) const {
  Atmosphere air = scene.atmosphere.with(fog_at(metres));
  if (!phase.empty()) {
    air.phase = files::phase_named(phase).value();
  } else if (fog_mode() == FogMode::exp2 && !scene.states_phase) {
    air.phase = {};
  }
  if (albedo) air.albedo = *albedo;
  air.profile = fog ? make_density_profile(layers.value_or(scene.layers), contrast) : DensityProfile{};
  if (air.profile.count > 0 && fog_mode() == FogMode::exp2) {
    command::fail_option("--fog", "exp2", "must be exp where the air has layers: --layers none draws it without");
  }
  if (air.profile.count > 0 && runway_visual_range) {
    command::fail_option("--rvr", fmt::format("{}", *runway_visual_range),
                         "must be in air without layers, which change it: --layers none draws it without");
  }
  if (const auto error = find_scattering_error(air); error && scattering == render::Scattering::all) {
    const std::string_view field = error->field;
    const char* const option = field == "fog.mode" ? "--fog" : field == "albedo" ? "--albedo" : "--phase";
    command::fail_option("--scattering", "all", fmt::format("{} {}", option, error->rule));
  }
  return air;
}

void take_layers(DrawingOptions& options, const std::string& file) {
  options.layers = file == "none" ? std::vector<FogLayer>() : scene::read_fog_layers(file);
  options.layers_file = file;
}

void add_fog(CLI::App& app, DrawingOptions& options) {
  app.option_defaults()->group("Fog");
  command::add_choice<std::optional<FogMode>>(app, "--fog", options.fog,
                                              {{"exp", FogMode::exp}, {"exp2", FogMode::exp2}},
                                              "Law by which fog dims light over range (default exp)");
  add_layers(app, options);
  add_phase(app, options);
}

void add_fog_and_visibility(CLI::App& app, DrawingOptions& options) {
  app.option_defaults()->group("Fog");
  command::add_choice<std::optional<FogMode>>(app, "--fog", options.fog,
                                              {{"exp", FogMode::exp}, {"exp2", FogMode::exp2}, {"none", std::nullopt}},
                                              "Law by which fog dims light over range (default exp)");
  add_number(app, "--visibility", options.visibility, command::kNotNegative,
             "Range in metres at which a fraction of the contrast is left; inf is clear air (default: what the scene "
             "suggests)",
             [&options] { options.runway_visual_range.reset(); });
  command::add_contrast(app, options.contrast);
  command::add_runway_lights(app, options.runway_lights);
  add_number(
      app, "--rvr", options.runway_visual_range, command::kNotNegative,
      "Runway visual range in metres, instead of --visibility, in air without layers: how far lamps of --lamp-cd "
      "are seen",
      [&options] {
        options.visibility.reset();
        command::expect_lamps_reach(*options.runway_visual_range, options.runway_lights);
      });
  add_layers(app, options);
  add_phase(app, options);
}

bool is_hales_lookup(const render::LightingPath& path) {
  return path.evaluation == render::Evaluation::lookup && path.surface == render::SurfaceModel::diffuse;
}

void add_size(CLI::App& app, DrawingOptions& options) {
  const std::string description = fmt::format("Pixels (default {}x{})", options.width, options.height);
  app.add_option_function<std::string>(
         "--size", [&options](const std::string& text) { parse_size(text, options); }, description)
      ->type_name("WxH");
}

void add_drawing(CLI::App& app, DrawingOptions& options) {
  app.option_defaults()->group("Light");
  command::add_choice(app, "--path", options.render.path, path_names(),
                      "Lighting path: see `litfog-demo list paths` (default unified)");
  command::add_choice(
      app, "--fog-light", options.fog_light, kFogLights,
      "How lamps light the fog: peak is the papers' term, for carried lights only; airlight is the light of every lamp "
      "along each ray (default airlight with --path unified, else peak)");
  command::add_choice(
      app, "--scattering", options.scattering, kScatterings,
      "With airlight: light that the fog scatters once, or in all orders; beyond one visibility, most light is "
      "scattered more than once (default all in exp fog of albedo 1 that is isotropic, hg:G with G in [0, 0.95] or of "
      "droplets, else single)");
  command::add_choice(
      app, "--shadows", options.render.shadows, kShadows,
      fmt::format("What shadows of lamps and moon darken: surfaces, or with shafts also the lamps' airlight, with "
                  "errors of up to 2.5 steps of 1/255 at the edges of shafts (default {})",
                  options.render.shadows == render::Shadows::none ? "none" : "surfaces"));
  command::add_integer(
      app, "--shadow-lamps", options.render.shadow_lamps, 1, int(scene::kMaxSceneLights),
      "With --shadows: how many lamps may cast shadows, the carried ones first, then the brightest at the camera "
      "(default 8)");
  command::add_integer(app, "--shadow-map-size", options.render.shadow_map_size, 16, 8192,
                       "With --shadows: edge of a shadow map in texels; a lamp has one, or up to six if it shines in "
                       "all directions, the moon four (default 1024)");
  add_display(app, options.display);
  app.option_defaults()->group("Pixels");
  add_size(app, options);
  command::add_choice(app, "--samples", options.render.samples, kSamples,
                      "At least this many samples per pixel (default 4)");
  app.add_flag_callback(
      "--no-skip", [&options] { options.render.skipping = render::Skipping::off; },
      "Draw and light everything, even if it cannot be visible");
  render::PaperSettings& papers = options.render.papers;
  app.option_defaults()->group("The papers' ways");
  app.add_flag("--flat-shading", papers.is_flat_shaded,
               "With lookup-3d and lookup-2d: directional light by face normals");
  command::add_number(
      app, "--light-ambient", papers.light_ambient, kFraction,
      "With lookup-3d and lookup-2d: the lights' ambient colour as a fraction of their colour (default 0)");
  app.add_flag("--infinite-viewer", papers.has_infinite_viewer,
               "Highlights for a viewer at infinity along the camera's axis");
  command::add_integer(app, "--map-size", papers.map_size, 8, 256,
                       "Edge of the path's light maps in texels (default 128)");
  command::add_choice(
      app, "--cone-maps", papers.cone_maps, kConeMaps,
      "Cube maps of paths with light maps: scaled fits each cone below 90 degrees to one face, as in the papers; even "
      "spreads cones wider than 60 degrees over all faces; one-disc is Frazier's single map for all cones (default "
      "scaled)");
}

void add_time(CLI::App& app, DrawingOptions& options) {
  app.option_defaults()->group("Scene");
  command::add_number(app, "--time", options.seconds, kSeconds,
                      "Time in seconds, for cookies and lights that turn or flash (default 0)");
}

std::vector<command::OptionRule> fog_and_shadow_rules(const DrawingOptions& options) {
  using render::Shadows;
  const render::LightingPath& path = *options.render.path;
  const std::string name = fmt::format("--path {}", path.name);
  const Shadows shadows = options.render.shadows;
  const bool is_peak = options.settings().fog_lighting == render::FogLighting::peak;
  const bool has_range = options.runway_visual_range.has_value();
  return {{"--fog none",
           !options.fog,
           {"--visibility", "--contrast", "--rvr", "--layers", "--phase", "--phase-g", "--albedo", "--scattering"},
           "the air is clear"},
          {"--fog exp2",
           options.fog == FogMode::exp2 && options.scattering == render::Scattering::all,
           {"--scattering"},
           "only exp fog has all orders"},
          {"--rvr", has_range, {"--visibility", "--contrast"}, "lamps and threshold give its meaning"},
          {options.visibility ? "--visibility" : "the scene's visibility",
           !has_range,
           {"--rvr", "--lamp-cd", "--background-cd-m2", "--threshold-lx"},
           "only --rvr depends on them"},
          {name, shadows != Shadows::none && !path.takes_airlight, {"--shadows"}, why_without_airlight(path)},
          {options.fog_light ? "--fog-light peak" : name,
           shadows == Shadows::shafts && is_peak,
           {"--shadows"},
           "only airlight has shafts"},
          {"--shadows none", shadows == Shadows::none, {"--shadow-lamps", "--shadow-map-size"}, "no lamp casts any"}};
}

std::vector<command::OptionRule> drawing_rules(const DrawingOptions& options) {
  const render::LightingPath& path = *options.render.path;
  const std::string name = fmt::format("--path {}", path.name);
  const bool is_peak = options.settings().fog_lighting == render::FogLighting::peak;
  std::vector<command::OptionRule> rules = fog_and_shadow_rules(options);
  rules.insert(
      rules.end(),
      {{options.fog_light ? "--fog-light peak" : name,
        is_peak,
        {"--phase", "--phase-g", "--albedo", "--scattering"},
        "only airlight scatters by it"},
       {name, path.maps == render::LightMapSet::none, {"--map-size", "--cone-maps"}, "it has no light maps"},
       {name, !is_hales_lookup(path), {"--flat-shading", "--light-ambient"}, "only lookup-3d and lookup-2d have it"},
       {name,
        options.fog_light == render::FogLighting::airlight && !path.takes_airlight,
        {"--fog-light"},
        why_without_airlight(path)},
       {name, path.surface != render::SurfaceModel::basic, {"--infinite-viewer"}, "it has no highlights"}});
  return rules;
}

void expect_pixels(const DrawingOptions& options, std::int64_t most, const std::string& what) {
  if (std::int64_t(options.width) * options.height <= most) return;
  command::fail_option("--size", fmt::format("{}x{}", options.width, options.height),
                       fmt::format("must be at most {} pixels in all {}", most, what));
}

}  // namespace litfog::drawing
