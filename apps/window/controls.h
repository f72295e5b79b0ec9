// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <imgui.h>

namespace litfog::window {

// Controls in the current ImGui window, each with its name left of it, below each other.

/// The name of the control that follows, which takes the rest of the line.
void label(const char* name);

/// A slider. What it sets has four digits: what a person means.
///
/// returns  whether it has been moved
bool slide(const char* name, double& value, double low, double high, const char* format, ImGuiSliderFlags flags = 0);

}  // namespace litfog::window
