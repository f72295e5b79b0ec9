// SPDX-License-Identifier: Apache-2.0
#include "window/controls.h"

#include <fmt/format.h>

#include <cfloat>
#include <string>

#include "command/number.h"

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

bool small_button(const char* text, bool is_enabled, const char* meaning) {
  ImGui::BeginDisabled(!is_enabled);
  const bool is_pressed = ImGui::SmallButton(text);
  ImGui::EndDisabled();
  explain(meaning);
  return is_pressed;
}

}  // namespace litfog::window
