// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "render/display.h"
#include "scene/scene.h"

namespace CLI {
class App;
}

namespace litfog::drawing {

/// How scene light becomes the light of a picture that is shown.
struct DisplayOptions {
  std::optional<render::Exposure> exposure = {};  ///< default: the scene's
  render::ToneCurve tone = render::ToneCurve::neutral;

  friend bool operator==(const DisplayOptions&, const DisplayOptions&) = default;

  render::Display display_for(const scene::Scene& scene) const;
};

/// --exposure and --tone.
void add_display(CLI::App& app, DisplayOptions& options);

/// The curve's name on the command line.
const char* tone_name(render::ToneCurve tone);

/// "EV -7.32 (auto), tone clip": what is not the default of our own scenes; empty where nothing is.
std::string display_in_words(const render::Display& display);

}  // namespace litfog::drawing
