// SPDX-License-Identifier: Apache-2.0
#include "window/settings_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <cmath>
#include <glm/glm.hpp>
#include <utility>

#include "command/number.h"
#include "litfog/input_error.h"
#include "render/plan/lighting_path.h"
#include "text/shown_number.h"
#include "window/controls.h"
#include "window/light_levels.h"
#include "window/own_files.h"
#include "window/visibility_preset.h"

namespace litfog::window {
namespace {

void heading(const char* text) {
  ImGui::Dummy({0, ImGui::GetFontSize() * 0.1f});
  ImGui::Separator();
  ImGui::TextDisabled("%s", text);
}

constexpr command::Choice<std::optional<FogMode>> kFogModes[] = {{"exp", FogMode::exp, "What droplets make"},
                                                                 {"exp2", FogMode::exp2, "As rasterisers' fog has it"},
                                                                 {"none", std::nullopt, "Clear air"}};
constexpr command::Choice<CameraMotion> kMotions[] = {
    {"orbits", CameraMotion::orbit, ""},
    {"flies", CameraMotion::fly, "Look around by dragging; W A S D, Q and E move, with Shift faster"}};

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

/// A kind of phase function as files::phase_named() takes it.
struct PhaseKind {
  const char* text;
  const char* prefix;
  double first, least, most;  ///< of its parameter; all 0: none
};
constexpr PhaseKind kPhaseKinds[] = {{"as in the scene", "", 0, 0, 0},
                                     {"isotropic", "isotropic", 0, 0, 0},
                                     {"Rayleigh", "rayleigh", 0, 0, 0},
                                     {"Henyey and Greenstein", "hg:", 0.8, -0.95, 0.95},
                                     {"droplets", "droplets:", 10, 5, 50}};

void draw_phase(drawing::DrawingOptions& options) {
  const PhaseKind* kind = kPhaseKinds;
  for (const PhaseKind& each : kPhaseKinds) {
    if (*each.prefix && options.phase.starts_with(each.prefix)) kind = &each;
  }
  const auto set = [&options](const PhaseKind& of, double number) {
    options.phase = of.prefix + (of.most > 0 ? fmt::format("{}", number) : "");
  };
  label("Phase");
  const bool is_other = kind == kPhaseKinds && !options.phase.empty();
  if (ImGui::BeginCombo("##phase", is_other ? options.phase.c_str() : kind->text)) {
    for (const PhaseKind& each : kPhaseKinds) {
      if (ImGui::Selectable(each.text, &each == kind)) set(each, each.first);
    }
    ImGui::EndCombo();
  }
  explain("How droplets spread what they scatter");
  if (!(kind->most > 0)) return;
  const auto number = command::parse_number(std::string_view(options.phase).substr(options.phase.find(':') + 1));
  double value = number.value_or(kind->first);
  const bool is_droplets = kind->least > 0;
  if (slide(is_droplets ? "Diameter" : "Asymmetry", value, kind->least, kind->most,
            is_droplets ? "%.3g \u00b5m" : "%.3g")) {
    set(*kind, value);
  }
}

/// Returns why a file of layers is refused.
std::string draw_layers(drawing::DrawingOptions& options) {
  label("Layers");
  std::string file = options.layers_file;
  ImGui::SetNextItemWidth(-3 * ImGui::GetFontSize());
  bool is_entered =
      ImGui::InputTextWithHint("##layers", "the scene's; a file, or none", &file, ImGuiInputTextFlags_EnterReturnsTrue);
  explain("A file of layers of fog that replace the scene's, taken by Enter");
  ImGui::SameLine();
  static const std::string kEndings[] = {".json"};
  static FolderListing listing;
  const std::string picked = browse_files("layers", ImGui::Button("...", {-FLT_MIN, 0}), kEndings, listing);
  if (!picked.empty()) {
    file = picked;
    is_entered = true;
  }
  if (!is_entered || file == options.layers_file) return "";
  try {
    if (!file.empty()) drawing::take_layers(options, file);
  } catch (const InputError& error) {
    return error.what();
  }
  if (file.empty()) options.layers.reset();
  options.layers_file = file;
  return "";
}

std::string draw_fog(Session& session) {
  drawing::DrawingOptions& options = session.edited_settings();
  heading("FOG");
  choose("Mode", options.fog, kFogModes);
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
  const Fog fog = session.fog(session.edited);
  double range = runway_visual_range(fog, options.runway_lights);
  if (slide("RVR", range, 10, 5000, std::isinf(range) ? "clear" : "%.4g m", ImGuiSliderFlags_Logarithmic) &&
      !find_runway_visual_range_error(range, options.runway_lights)) {
    options.visibility = options.visibility_of_runway_visual_range(range);
  }
  explain(fmt::format("Runway visual range: how far lamps of {} cd are seen from {} lx at the eye, or markings\n"
                      "Density: {:.4g} / m",
                      options.runway_lights.candela, options.runway_lights.illuminance_threshold, fog.density)
              .c_str());
  ImGui::BeginDisabled(options.settings().fog_lighting != render::FogLighting::airlight);
  draw_phase(options);
  double albedo = options.albedo.value_or(session.scene().atmosphere.albedo);
  if (slide("Albedo", albedo, 0, 1, "%.3g")) options.albedo = albedo;
  explain("Below 1, light that is scattered twice or more is left out");
  ImGui::EndDisabled();
  const std::string complaint = draw_layers(options);
  ImGui::EndDisabled();
  return complaint;
}

void draw_lighting(drawing::DrawingOptions& options) {
  heading("LIGHTING");
  label("Path");
  const std::string shown(options.render.path->name);
  if (ImGui::BeginCombo("##path", shown.c_str(), ImGuiComboFlags_HeightLarge)) {
    for (const render::LightingPath& path : render::all_paths()) {
      const std::string name(path.name);
      if (ImGui::Selectable(name.c_str(), &path == options.render.path)) options.render.path = &path;
      explain(fmt::format("{}\n{}", path.description, path.source).c_str());
    }
    ImGui::EndCombo();
  }
  render::RenderSettings drawn = options.settings();
  ImGui::BeginDisabled(!options.render.path->takes_airlight);
  if (choose("Fog light", drawn.fog_lighting, drawing::kFogLights)) options.fog_light = drawn.fog_lighting;
  ImGui::BeginDisabled(drawn.fog_lighting != render::FogLighting::airlight);
  if (choose("Scattering", drawn.scattering, drawing::kScatterings)) {
    options.scattering.reset();  // the default: all, where fog has it
    if (drawn.scattering == render::Scattering::single) options.scattering = drawn.scattering;
  }
  ImGui::EndDisabled();
  if (choose("Shadows", drawn.shadows, drawing::kShadows)) options.render.shadows = drawn.shadows;
  ImGui::EndDisabled();
  choose("Samples", options.render.samples, drawing::kSamples);
  label("Skipping");
  bool skips = options.render.skipping == render::Skipping::on;
  if (ImGui::Checkbox("what cannot be seen", &skips)) {
    options.render.skipping = skips ? render::Skipping::on : render::Skipping::off;
  }
}

void draw_time(Session& session) {
  heading("TIME");
  double seconds = session.time();
  if (slide("Seconds", seconds, 0, 60, "%.4g s")) session.set_time(seconds);
  ImGui::Checkbox("Lamps turn and flash", &session.runs);
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
  render::ToneCurve tone = options.display.tone_of(scene);
  if (choose("Tone", tone, drawing::kTones)) options.display.tone = tone;
  drawing::Glare glare = options.display.glare_of(options.settings().fog_lighting);
  if (choose("Glare", glare, drawing::kGlares)) options.display.glare = glare;
}

void draw_camera(Session& session) {
  heading("CAMERA");
  choose("Dragging", session.motion, kMotions);
  label("Field of view");
  float degrees = glm::degrees(session.camera.field_of_view);
  if (ImGui::SliderFloat("##fov", &degrees, 10, 120, "%.0f\u00b0", ImGuiSliderFlags_AlwaysClamp)) {
    session.camera.field_of_view = glm::radians(std::round(degrees));
  }
  ImGui::BeginDisabled(!session.is_camera_moved());
  if (ImGui::Button("Back to the scene's", {-FLT_MIN, 0})) session.camera = session.scene().camera;
  ImGui::EndDisabled();
}

/// Returns the scene to open, or an empty text.
std::string pick_scene(const scene::Scene& scene) {
  static const std::string kEndings[] = {".json", ".gltf", ".glb"};
  static FolderListing listing;
  static bool browses = false;
  std::string picked = browse_files("scene files", std::exchange(browses, false), kEndings, listing);
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (!ImGui::BeginCombo("##scene", scene.name.c_str(), ImGuiComboFlags_HeightLarge)) return picked;
  static std::string path;
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (ImGui::InputTextWithHint("##path", "a scene or glTF file", &path, ImGuiInputTextFlags_EnterReturnsTrue)) {
    picked = path;
    ImGui::CloseCurrentPopup();
  }
  explain("Or drop a file on the window");
  browses = ImGui::Selectable("Browse files...");  // its popup opens when the list has closed
  const auto list = [&picked](const char* title, const std::vector<std::string>& scenes) {
    ImGui::TextDisabled("%s", title);
    for (const std::string& each : scenes) {
      if (ImGui::Selectable(each.c_str())) picked = each;
    }
  };
  list("Recent files", recent_files());
  list("Scenes of litfog", scene::bundled_scenes());
  ImGui::EndCombo();
  return picked;
}

}  // namespace

Wishes draw_settings(Session& session, const render::Exposure& shown_exposure, std::span<const float> histogram) {
  Wishes wishes{.opened = pick_scene(session.scene())};
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
      if (ImGui::RadioButton(which == 0 ? "A, left" : "B, right", session.edited == which)) session.edited = which;
    }
  }
  wishes.complaint = draw_fog(session);
  draw_lighting(session.edited_settings());
  if (drawing::changes_with_time(session.scene())) draw_time(session);
  draw_display(session.edited_settings(), session.scene(), shown_exposure);
  ImGui::Checkbox("False colours", &session.is_false_colored);
  explain("Levels of light, in EV above white (F)");
  ImGui::PlotHistogram("##levels", histogram.data(), int(histogram.size()), 0, nullptr, 0, FLT_MAX,
                       {ImGui::GetContentRegionAvail().x, 3 * ImGui::GetFontSize()});
  explain(fmt::format("Pixels by their light: {:+} to {:+} EV above white", kLeastLevel, kMostLevel).c_str());
  draw_camera(session);
  heading("KEEP");
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
