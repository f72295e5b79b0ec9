// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <imgui.h>

#include <span>

#include "command/choice.h"

namespace litfog::window {

// Controls in the current ImGui window, each with its name left of it, below each other.

/// The name of the control that follows, which takes the rest of the line.
void label(const char* name);

/// A sentence beside the control before, where the mouse is over it; none where it is empty.
void explain(const char* sentence);

/// A slider. What it sets has four digits: what a person means.
///
/// returns  whether it has been moved
bool slide(const char* name, double& value, double low, double high, const char* format, ImGuiSliderFlags flags = 0);

/// Choices side by side, of which one has been made. Returns whether another has been.
template <typename Value, std::size_t count>
bool choose(const char* name, Value& value, const command::Choice<Value> (&choices)[count]) {
  bool is_changed = false;
  label(name);
  ImGui::PushID(name);
  for (const auto& choice : choices) {
    if (&choice != choices) ImGui::SameLine();
    if (ImGui::RadioButton(choice.word, value == choice.value)) {
      value = choice.value;
      is_changed = true;
    }
    explain(choice.meaning);
  }
  ImGui::PopID();
  return is_changed;
}

/// Numbers side by side that are dragged, or typed after a double click. What it sets is a whole number of hundredths.
///
/// speed    of dragging, a pixel
/// returns  whether one has been changed
bool drag(const char* name, std::span<double> values, double speed, const char* format);

/// A small button that is grey where it does nothing.
bool small_button(const char* text, bool is_enabled, const char* meaning);

}  // namespace litfog::window
