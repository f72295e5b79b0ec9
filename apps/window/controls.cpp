// SPDX-License-Identifier: Apache-2.0
#include "window/controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cfloat>

#include "command/number.h"
#include "command/printable.h"

namespace litfog::window {

void label(const char* name) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name);
  ImGui::SameLine(ImGui::GetFontSize() * 6.8f);
  ImGui::SetNextItemWidth(-FLT_MIN);
}

void explain(const char* sentence) {
  if (*sentence && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", sentence);
}

bool slide(const char* name, double& value, double low, double high, const char* format, ImGuiSliderFlags flags) {
  label(name);
  if (!ImGui::SliderScalar((std::string("##") + name).c_str(), ImGuiDataType_Double, &value, &low, &high, format,
                           flags | ImGuiSliderFlags_AlwaysClamp)) {
    return false;
  }
  value = *command::parse_number(fmt::format("{:.4g}", value));
  return true;
}

bool drag(const char* name, std::span<double> values, double speed, const char* format) {
  label(name);
  if (!ImGui::DragScalarN((std::string("##") + name).c_str(), ImGuiDataType_Double, values.data(), int(values.size()),
                          float(speed), nullptr, nullptr, format)) {
    return false;
  }
  for (double& value : values) value = *command::parse_number(fmt::format("{:.2f}", value));
  return true;
}

std::string browse_files(const char* title, bool is_asked, std::span<const std::string> endings, FolderListing& shown) {
  if (is_asked) {
    shown = list_folder(shown.folder.empty() ? "." : shown.folder, endings);
    ImGui::OpenPopup(title);
  }
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float font = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(40 * font, display.x), std::min(30 * font, display.y)});
  if (!ImGui::BeginPopup(title)) return "";
  ImGui::TextUnformatted(command::printable(shown.folder.string()).c_str());
  if (!shown.error.empty()) ImGui::TextUnformatted(shown.error.c_str());
  ImGui::Separator();
  const auto draw_row = [](const std::string& words) {
    const bool is_clicked = ImGui::Selectable("##row", false, ImGuiSelectableFlags_DontClosePopups);
    ImGui::SameLine();
    ImGui::TextUnformatted(words.c_str());  // apart, because ImGui reads ## in a control's name
    return is_clicked;
  };
  std::filesystem::path folder, file;
  ImGui::BeginChild(shown.folder.string().c_str());  // each folder keeps its scroll position
  if (shown.folder.has_relative_path() && draw_row("..")) folder = shown.folder.parent_path();
  ImGuiListClipper clipper;
  clipper.Begin(int(shown.entries.size()));
  while (clipper.Step()) {
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      const auto& [name, is_folder] = shown.entries[std::size_t(row)];
      ImGui::PushID(row);
      if (draw_row(command::printable(name) + (is_folder ? "/" : ""))) {
        (is_folder ? folder : file) = shown.folder / name;
      }
      ImGui::PopID();
    }
  }
  ImGui::EndChild();
  if (!folder.empty()) shown = list_folder(folder, endings);
  if (!file.empty()) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return file.string();
}

bool small_button(const char* text, bool is_enabled, const char* meaning) {
  ImGui::BeginDisabled(!is_enabled);
  const bool is_pressed = ImGui::SmallButton(text);
  ImGui::EndDisabled();
  explain(meaning);
  return is_pressed;
}

}  // namespace litfog::window
