// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "window/session.h"

namespace litfog::window {

/// Requests of the user besides changes of the session.
struct Wishes {
  bool picture = false;  ///< save it
  bool scene = false;
  bool command = false;        ///< copy it
  std::string opened = {};     ///< scene to open, as in drawing::SceneOptions
  std::string complaint = {};  ///< why a setting was refused
};

/// Draws the controls of fog, lighting, display and camera into the current ImGui window.
///
/// shown_exposure  the edited settings', as drawn
/// histogram       light_histogram() of that picture
Wishes draw_settings(Session& session, const render::Exposure& shown_exposure, std::span<const float> histogram);

}  // namespace litfog::window
