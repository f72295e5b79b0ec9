// SPDX-License-Identifier: Apache-2.0
#include "window/lamp_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <glm/glm.hpp>
#include <string>

#include "command/number.h"
#include "window/camera_motion.h"
#include "window/controls.h"
#include "window/curve_panel.h"

namespace litfog::window {
namespace {

bool slide_degrees(const char* name, double& radians, double low, double high) {
  double degrees = glm::degrees(radians);
  if (!slide(name, degrees, low, high, "%.4g\u00b0")) return false;
  radians = glm::radians(degrees);
  return true;
}

/// Adds a lamp at the picture's centre: a copy of the picked one, or a plain one.
void add_lamp(Session& session) {
  PlacedLight light{.light = {}, .position = session.camera.target, .direction = {0, -1, 0}};
  light.light.name = "lamp";
  light.light.attenuation = {1, 0, 0.05};
  if (session.picked) {
    const glm::dvec3 position = light.position;
    light = session.lights()[*session.picked];
    light.position = position;
  }
  session.add(light);
}

void draw_history(Session& session) {
  if (small_button("Undo", session.can_undo(), "The last change of a lamp (Ctrl+Z)")) session.undo();
  ImGui::SameLine();
  if (small_button("Redo", session.can_redo(), "Ctrl+Y")) session.redo();
  ImGui::SameLine();
  if (small_button("Reset", session.has_changes(), "All lamps as in the file")) session.reset_all();
  ImGui::SameLine();
  if (small_button("Add", true, "Where the camera looks: one more of the picked lamp, or a plain one")) {
    add_lamp(session);
  }
  ImGui::SameLine();
  if (small_button("Remove", session.picked.has_value(), "The picked lamp, with its copies; a city's alone (Del)")) {
    session.remove(*session.picked);
  }
}

void draw_list(Session& session, std::optional<std::size_t>& hovered) {
  if (session.lights().empty()) ImGui::TextDisabled("The scene has no lamps");
  ImGuiListClipper clipper;
  clipper.Begin(int(session.firsts().size()));
  while (clipper.Step()) {
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      const std::size_t light = session.firsts()[std::size_t(row)];
      const std::size_t copies = session.copies(light);
      const std::string text =
          fmt::format("{}{}{}", session.lights()[light].light.name, copies > 1 ? fmt::format(" \u00d7 {}", copies) : "",
                      session.is_changed(light) ? " *" : "");
      ImGui::PushID(row);
      const bool is_picked = session.picked && session.are_copies(*session.picked, light);
      if (ImGui::Selectable(text.c_str(), is_picked)) session.picked = light;
      if (ImGui::IsItemHovered()) hovered = light;
      ImGui::PopID();
    }
  }
}

bool draw_place(PlacedLight& placed, bool turns) {
  bool is_changed = drag("Position", {&placed.position.x, 3}, 0.02, "%.2f");
  if (placed.light.cone == Cone{} || turns) return is_changed;
  const Direction old = direction_of(placed.direction);
  double degrees[] = {glm::degrees(old.heading), glm::degrees(old.pitch)};
  if (drag("Heading, pitch", degrees, 0.2, "%.4g\u00b0")) {
    placed.direction = unit_vector({glm::radians(degrees[0]), glm::radians(std::clamp(degrees[1], -90.0, 90.0))});
    is_changed = true;
  }
  return is_changed;
}

bool draw_cone(Cone& cone, bool was_point_light) {
  bool is_changed = false;
  label("Cone");
  if (ImGui::BeginCombo("##cone", facts_of(cone.profile).name)) {
    for (const ConeProfileFacts& facts : kConeProfiles) {
      if (facts.parameters.empty() && !was_point_light) continue;  // a file cannot take a cone away
      if (!ImGui::Selectable(facts.name, facts.profile == cone.profile)) continue;
      cone = facts.first;
      is_changed = true;
    }
    ImGui::EndCombo();
  }
  for (const ConeParameter& parameter : facts_of(cone.profile).parameters) {
    const auto [least, most] = parameter.control;
    double& value = cone.*parameter.member;
    is_changed |= parameter.is_angle ? slide_degrees(parameter.label, value, least, most)
                                     : slide(parameter.label, value, least, most, "%.4g", ImGuiSliderFlags_Logarithmic);
  }
  return is_changed;
}

/// A colour's component with four digits, as read back from a scene file, whose colours are floats.
double shortest(double value) { return double(float(*command::parse_number(fmt::format("{:.4g}", value)))); }

bool draw_color(glm::dvec3& color) {
  const double largest = std::max({color.r, color.g, color.b});
  double brightness = largest;
  const glm::dvec3 hue = largest > 0 ? color / largest : glm::dvec3(1);
  float rgb[] = {float(hue.r), float(hue.g), float(hue.b)};
  label("Colour");
  const bool has_hue = ImGui::ColorEdit3("##colour", rgb, ImGuiColorEditFlags_Float);
  const bool has_brightness = slide("Brightness", brightness, 0.001, 1000, "%.4g", ImGuiSliderFlags_Logarithmic);
  if (!has_hue && !has_brightness) return false;
  for (int i = 0; i < 3; ++i) color[i] = shortest(double(rgb[i]) * brightness);
  return true;
}

void draw_controls(Session& session, std::size_t index) {
  PlacedLight placed = session.lights()[index];
  Light& light = placed.light;
  const scene::Scene& scene = session.scene();
  const bool is_added = session.is_added(index);
  const bool has_cookie = scene.cookie_uses.contains(index);
  const std::size_t copies = session.copies(index);
  ImGui::TextUnformatted(light.name.c_str());
  if (session.is_changed(index) && !is_added) {
    const char* const words = "As in the file";
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(words).x -
                    2 * ImGui::GetStyle().FramePadding.x);
    if (ImGui::SmallButton(words)) session.reset(index);
  }
  ImGui::TextDisabled(
      "%s%s%s", placed.carried ? "carried" : "local", is_added ? ", added" : "",
      copies > 1 ? fmt::format(", {} copies{}", copies, session.is_of_city(index) ? ", moves alone" : "").c_str() : "");
  bool is_changed = slide("Constant", light.attenuation.constant, 0, 20, "%.4g", ImGuiSliderFlags_Logarithmic);
  is_changed |= slide("Linear", light.attenuation.linear, 0, 10, "%.4g / m", ImGuiSliderFlags_Logarithmic);
  is_changed |= slide("Quadratic", light.attenuation.quadratic, 0, 10, "%.4g / m\u00b2", ImGuiSliderFlags_Logarithmic);
  is_changed |= slide("Threshold", light.threshold, 0.001, 0.9, "%.4g", ImGuiSliderFlags_Logarithmic);
  if (has_cookie) {
    ImGui::TextDisabled("A cookie is in place of the cone");
  } else {
    is_changed |= draw_cone(light.cone, is_added || scene.lights[index].light.cone == Cone{});
  }
  is_changed |= draw_color(light.color);
  if (session.is_movable(index)) is_changed |= draw_place(placed, scene.turn_rates.contains(index) || has_cookie);
  if (is_changed && !find_error(placed)) session.change(index, placed);
}

}  // namespace

void draw_lamps(Session& session, std::optional<std::size_t>& hovered) {
  const float font = ImGui::GetFontSize();
  ImGui::BeginChild("lamps", {font * 18, 0});
  draw_history(session);
  ImGui::BeginChild("list");
  draw_list(session, hovered);
  ImGui::EndChild();
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, font * 0.1f});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, font * 0.25f});
  ImGui::BeginChild("controls", {font * 21, 0});
  if (session.picked) {
    draw_controls(session, *session.picked);
  } else {
    ImGui::TextDisabled("Click a lamp in the picture or in the list");
  }
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ImGui::SameLine();
  ImGui::BeginChild("curve", {0, 0});
  if (session.picked) draw_curve(session);
  ImGui::EndChild();
}

}  // namespace litfog::window
