// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "window/session.h"

namespace litfog::window {

/// Draws what the picked lamp makes of the fog into the current ImGui window, as the picture has it: by airlight what
/// the ray at the mouse gathers of it, by the peak (1 - f) a over the range.
void draw_curve(const Session& session);

}  // namespace litfog::window
