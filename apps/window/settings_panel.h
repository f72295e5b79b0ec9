// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "window/session.h"

namespace litfog::window {

/// What a person asks for beside changes of the session.
struct Wishes {
  bool picture = false;  ///< to be saved
  bool scene = false;
  bool command = false;        ///< to be copied
  std::string opened = {};     ///< a scene to be opened, as drawing::SceneOptions names it
  std::string complaint = {};  ///< why a setting cannot be as it was asked for
};

/// Draws the controls of fog, lighting, display and camera into the current ImGui window.
///
/// shown_exposure  of the edited settings as they are drawn
/// histogram       light_histogram() of that picture
Wishes draw_settings(Session& session, const render::Exposure& shown_exposure, std::span<const float> histogram);

}  // namespace litfog::window
