// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <imgui.h>

#include <span>

namespace litfog::window {

// Controls in the current ImGui window, each with its name left of it, below each other.

/// The name of the control that follows, which takes the rest of the line.
void label(const char* name);

/// A slider. What it sets has four digits: what a person means.
///
/// returns  whether it has been moved
bool slide(const char* name, double& value, double low, double high, const char* format, ImGuiSliderFlags flags = 0);

/// Numbers side by side that are dragged, or typed after a double click. What it sets is a whole number of hundredths.
///
/// speed    of dragging, a pixel
/// returns  whether one has been changed
bool drag(const char* name, std::span<double> values, double speed, const char* format);

/// A small button that is grey where it does nothing.
bool small_button(const char* text, bool is_enabled, const char* meaning);

}  // namespace litfog::window
