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

/// What the jobs of litfog-demo have in common: how they draw. A job adds the options that mean something to it; each
/// function that adds some states their heading in --help.
struct DrawingOptions {
  std::optional<FogMode> fog = FogMode::exp;       ///< none: clear air
  std::optional<double> visibility = {};           ///< metres; default: what each scene suggests
  double contrast = kContrastMor;                  ///< that is left at the visibility, (0, 1)
  std::optional<double> runway_visual_range = {};  ///< metres, in place of the visibility
  RunwayLights runway_lights = {};
  std::string phase = {};             ///< of the fog, as files::phase_named() takes it; default: the scenes' own
  std::optional<double> albedo = {};  ///< of the fog, [0, 1]; default: the scenes' own
  std::optional<std::vector<FogLayer>> layers = {};  ///< of the fog; default: the scenes' own
  std::string layers_file = {};                      ///< that states them; "none" or empty: none does
  double seconds = 0;                                ///< for which the scenes' lights have been turning and flashing
  int width = 1280;                                  ///< pixels
  int height = 720;
  render::RenderSettings render = {};
  std::optional<render::FogLighting> fog_light = {};  ///< default: airlight along `unified`, peak along the others
  std::optional<render::Scattering> scattering = {};  ///< default: all, where fog has it
  DisplayOptions display = {};

  friend bool operator==(const DrawingOptions&, const DrawingOptions&) = default;

  /// Metres, outside layers: the visibility that is asked for, else infinite between layers that are, else the one that
  /// the scene suggests; infinite in clear air.
  double visibility_in(const scene::Scene& scene) const;
  /// The visibility of a runway visual range, both in metres.
  double visibility_of_runway_visual_range(double metres) const;
  /// How a path draws. One that takes no airlight draws the peak whatever is asked for.
  render::RenderSettings settings_of(const render::LightingPath& path) const;
  /// How the chosen path draws: by `render`, except for what fog_light states and the path excludes.
  render::RenderSettings settings() const { return settings_of(*render.path); }
  FogMode fog_mode() const { return fog.value_or(FogMode::exp); }
  /// The fog of a visibility in metres.
  Fog fog_at(double metres) const { return Fog::from_visibility(fog_mode(), metres, contrast); }
  /// A scene's atmosphere at a visibility, with the layers, phase function and albedo that are asked for. exp2 fog,
  /// which no droplets make, is isotropic unless asked otherwise. Throws the usage error of layers in exp2 fog.
  Atmosphere atmosphere_of(const scene::Scene& scene, double metres) const;
};

/// Takes layers from a file, or "none". Throws InputError.
void take_layers(DrawingOptions& options, const std::string& file);

/// --fog, for a job that draws clear air anyway, --layers, --phase and --albedo.
void add_fog(CLI::App& app, DrawingOptions& options);
/// --fog, which may be none, --visibility, --contrast, --rvr with its lamps, --layers, --phase and --albedo.
void add_fog_and_visibility(CLI::App& app, DrawingOptions& options);
/// Whether a path is lookup-3d or lookup-2d, to which --flat-shading and --light-ambient belong.
bool is_hales_lookup(const render::LightingPath& path);
/// --path, --fog-light and what else is asked of light, add_display(), --size and what else is asked of pixels, and a
/// group of what only re-enacts papers.
void add_drawing(CLI::App& app, DrawingOptions& options);
void add_size(CLI::App& app, DrawingOptions& options);
void add_time(CLI::App& app, DrawingOptions& options);

/// The rules of --fog none and --shadows, all rules there are for a job over every path.
std::vector<command::OptionRule> fog_and_shadow_rules(const DrawingOptions& options);

/// fog_and_shadow_rules(), and the chosen path's rules.
std::vector<command::OptionRule> drawing_rules(const DrawingOptions& options);

/// Throws the usage error of a --size of more pixels than this. what: of which, "for a reference"
void expect_pixels(const DrawingOptions& options, std::int64_t most, const std::string& what);

}  // namespace litfog::drawing
