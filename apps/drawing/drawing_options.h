// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/choice.h"
#include "command/option_rule.h"
#include "drawing/display_options.h"
#include "litfog/atmosphere.h"
#include "litfog/runway_visual_range.h"
#include "render/render_settings.h"
#include "scene/scene.h"

namespace litfog::command {
struct NumberRule;
}

namespace litfog::drawing {

extern const command::NumberRule kSeconds;  ///< for --time

// The words of options.
inline constexpr command::Choice<render::FogLighting> kFogLights[] = {
    {"peak", render::FogLighting::peak, "The papers' way: carried lamps by their fog colour intensity"},
    {"airlight", render::FogLighting::airlight, "Every lamp by what the fog scatters into the eye along each ray"}};
inline constexpr command::Choice<render::Scattering> kScatterings[] = {
    {"single", render::Scattering::single, "What the fog scatters once"},
    {"all", render::Scattering::all,
     "Also what it scatters more often, in exp fog that absorbs nothing"}};
inline constexpr command::Choice<render::Shadows> kShadows[] = {
    {"none", render::Shadows::none, "Lamps shine through everything"},
    {"surfaces", render::Shadows::surfaces, "Lamps and moon cast shadows on surfaces"},
    {"shafts", render::Shadows::shafts, "On surfaces and through the airlight"}};
inline constexpr command::Choice<int> kSamples[] = {
    {"1", 1, "A pixel"}, {"2", 2, "A pixel"}, {"4", 4, "A pixel"}, {"8", 8, "A pixel"}};
inline constexpr command::Choice<render::ConeMaps> kConeMaps[] = {{"scaled", render::ConeMaps::scaled, ""},
                                                                  {"even", render::ConeMaps::even, ""},
                                                                  {"one-disc", render::ConeMaps::one_disc, ""}};

/// The drawing options that the jobs of litfog-demo share. A job adds those that apply to it. Each function that adds
/// options states their heading in --help.
struct DrawingOptions {
  std::optional<FogMode> fog = FogMode::exp;       ///< none: clear air
  std::optional<double> visibility = {};           ///< metres; default: what each scene suggests
  double contrast = kContrastMor;                  ///< contrast left at the visibility, (0, 1)
  std::optional<double> runway_visual_range = {};  ///< metres; replaces the visibility
  RunwayLights runway_lights = {};
  std::string phase = {};             ///< the fog's, as files::phase_named() takes it; default: the scenes' own
  std::optional<double> albedo = {};  ///< the fog's, [0, 1]; default: the scenes' own
  std::optional<std::vector<FogLayer>> layers = {};  ///< the fog's; default: the scenes' own
  std::string layers_file = {};                      ///< states the layers; "none" or empty: no file
  double seconds = 0;                                ///< time for which the scenes' lights have turned and flashed
  int width = 1280;                                  ///< pixels
  int height = 720;
  render::RenderSettings render = {};
  std::optional<render::FogLighting> fog_light = {};  ///< default: airlight along `unified`, peak along the others
  std::optional<render::Scattering> scattering = {};  ///< default: all, where fog has it
  DisplayOptions display = {};

  friend bool operator==(const DrawingOptions&, const DrawingOptions&) = default;

  /// Visibility outside layers, metres: the one asked for, else infinite if layers are asked for, else the scene's;
  /// infinite in clear air.
  double visibility_in(const scene::Scene& scene) const;
  /// The visibility of a runway visual range, both in metres.
  double visibility_of_runway_visual_range(double metres) const;
  /// The render settings of a path. A path that takes no airlight draws by peak whatever is asked for.
  render::RenderSettings settings_of(const render::LightingPath& path) const;
  /// The render settings of the chosen path: `render` with fog_light, within what the path allows.
  render::RenderSettings settings() const { return settings_of(*render.path); }
  FogMode fog_mode() const { return fog.value_or(FogMode::exp); }
  /// The fog of a visibility in metres.
  Fog fog_at(double metres) const { return Fog::from_visibility(fog_mode(), metres, contrast); }
  /// A scene's atmosphere at a visibility, with the layers, phase function and albedo asked for. exp2 fog, which no
  /// droplets make, is isotropic by default. Throws the usage error of layers in exp2 fog.
  Atmosphere atmosphere_of(const scene::Scene& scene, double metres) const;
};

/// Reads layers from a file, or takes "none". Throws InputError.
void take_layers(DrawingOptions& options, const std::string& file);

/// Adds --fog without `none`, --layers, --phase and --albedo: for a job that draws clear air anyway.
void add_fog(CLI::App& app, DrawingOptions& options);
/// Adds --fog with `none`, --visibility, --contrast, --rvr and its lamps, --layers, --phase and --albedo.
void add_fog_and_visibility(CLI::App& app, DrawingOptions& options);
/// Whether a path is lookup-3d or lookup-2d, to which --flat-shading and --light-ambient belong.
bool is_hales_lookup(const render::LightingPath& path);
/// Adds --path, --fog-light and other options of light, add_display(), --size and other options of pixels, and a group
/// of options that only re-enact papers.
void add_drawing(CLI::App& app, DrawingOptions& options);
void add_size(CLI::App& app, DrawingOptions& options);
void add_time(CLI::App& app, DrawingOptions& options);

/// The rules of --fog none and --shadows: all rules of a job over every path.
std::vector<command::OptionRule> fog_and_shadow_rules(const DrawingOptions& options);

/// fog_and_shadow_rules() and the chosen path's rules.
std::vector<command::OptionRule> drawing_rules(const DrawingOptions& options);

/// Throws the usage error of a --size of more than `most` pixels. what: "for a reference"
void expect_pixels(const DrawingOptions& options, std::int64_t most, const std::string& what);

}  // namespace litfog::drawing
