// SPDX-License-Identifier: Apache-2.0
#include "window/settings_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>
#include <glm/glm.hpp>

#include "render/plan/lighting_path.h"
#include "text/shown_number.h"
#include "window/controls.h"
#include "window/visibility_preset.h"

namespace litfog::window {
namespace {

void heading(const char* text) {
  ImGui::Dummy({0, ImGui::GetFontSize() * 0.1f});
  ImGui::Separator();
  ImGui::TextDisabled("%s", text);
}

void explain(const char* sentence) {
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", sentence);
}

template <typename Value>
bool choice(const char* text, Value& value, const Value& meant) {
  if (!ImGui::RadioButton(text, value == meant)) return false;
  value = meant;
  return true;
}

void draw_presets(drawing::DrawingOptions& options) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x / 2;
  const float right = ImGui::GetWindowContentRegionMax().x;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {spacing, spacing});
  for (const VisibilityPreset& preset : kVisibilityPresets) {
    const float width = ImGui::CalcTextSize(preset.name).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (&preset != kVisibilityPresets.data()) {
      ImGui::SameLine();
      if (ImGui::GetCursorPosX() + width > right) ImGui::NewLine();
    }
    const auto visibility = preset.visibility(options.fog_mode(), options.contrast, options.runway_lights);
    ImGui::BeginDisabled(!visibility);
    if (ImGui::Button(preset.name)) options.visibility = visibility;
    ImGui::EndDisabled();
    explain(preset.is_runway_visual_range && visibility
                ? fmt::format("{}; visibility {} m", preset.meaning, shown_rounded(*visibility, 4)).c_str()
                : preset.meaning);
  }
  ImGui::PopStyleVar();
}

void draw_fog(Session& session) {
  drawing::DrawingOptions& options = session.edited_settings();
  heading("FOG");
  label("Mode");
  choice("exp", options.fog, std::optional(FogMode::exp));
  ImGui::SameLine();
  choice("exp2", options.fog, std::optional(FogMode::exp2));
  ImGui::SameLine();
  choice("none", options.fog, std::optional<FogMode>());
  ImGui::BeginDisabled(!options.fog);
  double metres = *options.visibility;
  const char* const format = std::isinf(metres) ? "clear" : metres < 1e4 ? "%.4g m" : "%.0f m";
  if (slide("Visibility", metres, kMinVisibility, kMaxVisibility, format, ImGuiSliderFlags_Logarithmic)) {
    options.visibility = metres;
  }
  draw_presets(options);
  label("Contrast");
  constexpr std::pair<const char*, double> kContrasts[] = {
      {"MOR, 5 %", kContrastMor}, {"Koschmieder, 2 %", kContrastKoschmieder}, {"FlightGear, 1 %", kContrastFlightgear}};
  const std::string own = fmt::format("{} %", 100 * options.contrast);
  const char* shown = own.c_str();
  for (const auto& [name, contrast] : kContrasts) shown = contrast == options.contrast ? name : shown;
  if (ImGui::BeginCombo("##contrast", shown)) {
    for (const auto& [name, contrast] : kContrasts) {
      if (ImGui::Selectable(name, contrast == options.contrast)) options.contrast = contrast;
    }
    ImGui::EndCombo();
  }
  explain("The contrast that is left at the visibility: what its metres mean");
  ImGui::EndDisabled();
  const Fog fog = session.fog(session.edited);
  const double range = runway_visual_range(fog, options.runway_lights);
  if (std::isinf(range)) {
    ImGui::TextDisabled("clear air");
  } else {
    ImGui::TextDisabled("RVR %.4g m, density %.4g / m", range, fog.density);
  }
  explain(fmt::format("Runway visual range: how far lamps of {} cd are seen from {} lx at the eye, or markings",
                      options.runway_lights.candela, options.runway_lights.illuminance_threshold)
              .c_str());
}

void draw_lighting(drawing::DrawingOptions& options) {
  heading("LIGHTING");
  label("Path");
  const std::string shown(options.render.path->name);
  if (ImGui::BeginCombo("##path", shown.c_str(), ImGuiComboFlags_HeightLarge)) {
    for (const auto paths : {render::lighting_paths(), render::published_programs()}) {
      for (const render::LightingPath& path : paths) {
        const std::string name(path.name);
        if (ImGui::Selectable(name.c_str(), &path == options.render.path)) options.render.path = &path;
        explain(fmt::format("{}\n{}", path.description, path.source).c_str());
      }
    }
    ImGui::EndCombo();
  }
  label("Fog light");
  const bool takes_airlight = options.render.path->takes_airlight;
  render::FogLighting fog_light = options.settings().fog_lighting;
  ImGui::BeginDisabled(!takes_airlight);
  if (choice("airlight", fog_light, render::FogLighting::airlight)) options.fog_light = fog_light;
  explain("Every lamp by what the fog scatters into the eye along each ray");
  ImGui::SameLine();
  if (choice("peak", fog_light, render::FogLighting::peak)) options.fog_light = fog_light;
  explain("The papers' way: carried lamps by their fog colour intensity");
  ImGui::EndDisabled();
  label("Skipping");
  bool skips = options.render.skipping == render::Skipping::on;
  if (ImGui::Checkbox("what cannot be seen", &skips)) {
    options.render.skipping = skips ? render::Skipping::on : render::Skipping::off;
  }
}

void draw_display(drawing::DrawingOptions& options, const scene::Scene& scene, const render::Exposure& shown) {
  heading("DISPLAY");
  label("Exposure");
  bool is_auto = shown.is_auto;
  if (ImGui::Checkbox("auto", &is_auto)) options.display.exposure = {.ev = is_auto ? 0 : shown.ev, .is_auto = is_auto};
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-FLT_MIN);
  float ev = float(shown.ev);
  ImGui::BeginDisabled(is_auto);
  if (ImGui::SliderFloat("##ev", &ev, -12, 12, "%+.2f EV")) {
    options.display.exposure = {.ev = std::round(double(ev) * 20) / 20, .is_auto = false};
  }
  ImGui::EndDisabled();
  label("Tone");
  render::ToneCurve tone = options.display.tone_of(scene);
  if (choice("neutral", tone, render::ToneCurve::neutral)) options.display.tone = tone;
  ImGui::SameLine();
  if (choice("clip", tone, render::ToneCurve::clip)) options.display.tone = tone;
  label("Glare");
  drawing::Glare glare = options.display.glare_of(options.settings().fog_lighting);
  if (choice("eye", glare, drawing::Glare::eye)) options.display.glare = glare;
  explain("Light spread as the eye spreads it; left out while the picture moves");
  ImGui::SameLine();
  if (choice("none", glare, drawing::Glare::none)) options.display.glare = glare;
}

void draw_camera(Session& session) {
  heading("CAMERA");
  label("Dragging");
  choice("orbits", session.motion, CameraMotion::orbit);
  ImGui::SameLine();
  choice("flies", session.motion, CameraMotion::fly);
  explain("Look around by dragging; W A S D, Q and E move, with Shift faster");
  label("Field of view");
  float degrees = glm::degrees(session.camera.field_of_view);
  if (ImGui::SliderFloat("##fov", &degrees, 10, 120, "%.0f\u00b0", ImGuiSliderFlags_AlwaysClamp)) {
    session.camera.field_of_view = glm::radians(std::round(degrees));
  }
  ImGui::BeginDisabled(!session.is_camera_moved());
  if (ImGui::Button("Back to the scene's", {-FLT_MIN, 0})) session.camera = session.scene().camera;
  ImGui::EndDisabled();
}

}  // namespace

Wishes draw_settings(Session& session, const render::Exposure& shown_exposure) {
  ImGui::TextUnformatted(session.scene().name.c_str());
  if (!session.scene().description.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", session.scene().description.c_str());
    ImGui::PopStyleColor();
  }
  bool is_split = session.is_split;
  if (ImGui::Checkbox("Compare", &is_split)) session.split(is_split);
  explain("Two settings side by side: drag the line between them");
  if (session.is_split) {
    for (const std::size_t which : {0u, 1u}) {
      ImGui::SameLine();
      choice(which == 0 ? "A, left" : "B, right", session.edited, which);
    }
  }
  draw_fog(session);
  draw_lighting(session.edited_settings());
  draw_display(session.edited_settings(), session.scene(), shown_exposure);
  draw_camera(session);
  heading("KEEP");
  Wishes wishes;
  const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
  wishes.picture = ImGui::Button("Save picture", {half, 0});
  explain("As litfog-demo writes it (Ctrl+P)");
  ImGui::SameLine();
  wishes.scene = ImGui::Button("Save scene", {half, 0});
  explain("A scene file with this camera and these lamps");
  wishes.command = ImGui::Button("Copy command line", {-FLT_MIN, 0});
  explain("litfog-demo with the options that draw this picture (Ctrl+C)");
  return wishes;
}

}  // namespace litfog::window
