// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "command/choice.h"
#include "drawing/glare.h"
#include "render/display.h"
#include "render/render_settings.h"
#include "scene/scene.h"

namespace litfog::drawing {

/// The eye's glare, then render::Display.
struct Display {
  render::Exposure exposure = {};
  render::ToneCurve tone = render::ToneCurve::neutral;
  Glare glare = Glare::none;
};

/// Options that turn scene light into a displayed picture.
struct DisplayOptions {
  std::optional<render::Exposure> exposure = {};  ///< default: the scene's
  std::optional<render::ToneCurve> tone = {};     ///< default: the scene's
  std::optional<Glare> glare = {};                ///< default: glare_of

  friend bool operator==(const DisplayOptions&, const DisplayOptions&) = default;

  /// The glare asked for, else the eye's for pictures by airlight and none for the papers' pictures.
  Glare glare_of(render::FogLighting fog_lighting) const;
  render::ToneCurve tone_of(const scene::Scene& scene) const;
  Display display_for(const scene::Scene& scene, render::FogLighting fog_lighting) const;
};

/// --exposure, --tone and --glare.
void add_display(CLI::App& app, DisplayOptions& options);

// Values on the command line.
inline constexpr command::Choice<render::ToneCurve> kTones[] = {
    {"neutral", render::ToneCurve::neutral, "Light beyond white keeps its hue (Khronos PBR Neutral)"},
    {"clip", render::ToneCurve::clip, "Each channel is cut at white, as in the papers"}};
inline constexpr command::Choice<Glare> kGlares[] = {
    {"eye", Glare::eye, "Light spread as the eye spreads it; left out while the picture moves"},
    {"none", Glare::none, "Light as it comes"}};

/// "EV -7.32 (auto), tone clip": exposure and tone unless they are the default of our own scenes; may be empty.
std::string display_in_words(const Display& display);

/// A camera's picture as a display shows it: the eye's glare, then render::displayed.
render::Picture displayed(const render::Picture& picture, const scene::Camera& camera, const Display& display);

}  // namespace litfog::drawing
