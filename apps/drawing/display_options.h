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

/// render::Display, and before it the eye.
struct Display {
  render::Exposure exposure = {};
  render::ToneCurve tone = render::ToneCurve::neutral;
  Glare glare = Glare::none;
};

/// How scene light becomes the light of a picture that is shown.
struct DisplayOptions {
  std::optional<render::Exposure> exposure = {};  ///< default: the scene's
  std::optional<render::ToneCurve> tone = {};     ///< default: the scene's
  std::optional<Glare> glare = {};                ///< default: that of glare_of

  friend bool operator==(const DisplayOptions&, const DisplayOptions&) = default;

  /// What is asked for, else the eye's for pictures by airlight and none for the papers' pictures.
  Glare glare_of(render::FogLighting fog_lighting) const;
  render::ToneCurve tone_of(const scene::Scene& scene) const;
  Display display_for(const scene::Scene& scene, render::FogLighting fog_lighting) const;
};

/// --exposure, --tone and --glare.
void add_display(CLI::App& app, DisplayOptions& options);

// The words on the command line.
inline constexpr command::Choice<render::ToneCurve> kTones[] = {
    {"neutral", render::ToneCurve::neutral, "Light beyond white keeps its hue (Khronos PBR Neutral)"},
    {"clip", render::ToneCurve::clip, "Each channel is cut at white, as in the papers"}};
inline constexpr command::Choice<Glare> kGlares[] = {
    {"eye", Glare::eye, "Light spread as the eye spreads it; left out while the picture moves"},
    {"none", Glare::none, "Light as it comes"}};

/// "EV -7.32 (auto), tone clip": exposure and tone that are not the default of our own scenes; empty where both are.
std::string display_in_words(const Display& display);

/// A camera's picture as a display shows it: the eye's glare, then render::displayed.
render::Picture displayed(const render::Picture& picture, const scene::Camera& camera, const Display& display);

}  // namespace litfog::drawing
