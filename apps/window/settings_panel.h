// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "window/session.h"

namespace litfog::window {

/// What a person asks for beside changes of the session.
struct Wishes {
  bool picture = false;  ///< to be saved
  bool scene = false;
  bool command = false;        ///< to be copied
  std::string complaint = {};  ///< why a setting cannot be as it was asked for
};

/// Draws the controls of fog, lighting, display and camera into the current ImGui window.
///
/// shown_exposure  of the edited settings as they are drawn
Wishes draw_settings(Session& session, const render::Exposure& shown_exposure);

}  // namespace litfog::window
