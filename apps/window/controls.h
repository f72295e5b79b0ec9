// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <imgui.h>

#include <span>
#include <string>

#include "command/choice.h"
#include "window/folder_listing.h"

namespace litfog::window {

// Controls in the current ImGui window, one below the other, each with its name on the left.

/// Draws the name of the next control, which takes the rest of the line.
void label(const char* name);

/// A tooltip for the previous control; none if empty.
void explain(const char* sentence);

/// A slider. It sets values of four digits, because a user means no more.
///
/// returns  whether it has been moved
bool slide(const char* name, double& value, double low, double high, const char* format, ImGuiSliderFlags flags = 0);

/// Choices side by side, one of them active. Returns whether the choice has changed.
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

/// Numbers side by side that are dragged, or typed after a double click. Sets whole hundredths.
///
/// speed    of dragging, per pixel
/// returns  whether one has been changed
bool drag(const char* name, std::span<double> values, double speed, const char* format);

/// A popup over the window, in which a file is chosen.
///
/// is_asked  opens it, in the folder shown last; at first in the current one
/// endings   as in list_folder()
/// shown     kept between frames
/// returns   the path of the file chosen in this frame; else empty
std::string browse_files(const char* title, bool is_asked, std::span<const std::string> endings, FolderListing& shown);

/// A small button that is grey if disabled.
bool small_button(const char* text, bool is_enabled, const char* meaning);

}  // namespace litfog::window
