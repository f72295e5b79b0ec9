// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "window/session.h"

namespace litfog::window {

/// Draws how the picked lamp lights the fog into the current ImGui window, as in the picture: by airlight the airlight
/// along the ray at the mouse, by peak (1 - f) a over the range.
void draw_curve(const Session& session);

}  // namespace litfog::window
