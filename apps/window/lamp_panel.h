// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "window/session.h"

namespace litfog::window {

/// Draws the scene's lamps, the picked one's controls and its curve into the current ImGui window, side by side.
///
/// hovered  set to the lamp in the list under the mouse
void draw_lamps(Session& session, std::optional<std::size_t>& hovered);

}  // namespace litfog::window
