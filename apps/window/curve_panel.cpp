// SPDX-License-Identifier: Apache-2.0
#include "window/curve_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <CLI/Error.hpp>
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "litfog/solve.h"
#include "render/light/scene_lights.h"
#include "text/shown_number.h"
#include "window/airlight_curve.h"
#include "window/range_curve.h"

namespace litfog::window {
namespace {

constexpr int kSamples = 240;
constexpr int kAirlightSamples = 80;
constexpr ImU32 kExtentColor = IM_COL32(120, 170, 230, 255);
constexpr ImU32 kOpacityColor = IM_COL32(110, 150, 210, 150);
constexpr ImU32 kAttenuationColor = IM_COL32(130, 190, 130, 170);
constexpr ImU32 kKneeColor = IM_COL32(150, 210, 150, 255);
constexpr ImU32 kPeakColor = IM_COL32(255, 180, 80, 255);
constexpr ImU32 kAllColor = IM_COL32(240, 240, 240, 255);

/// A plot's rectangle on the screen, and its scales.
struct Axes {
  ImVec2 low;   ///< the bottom left corner
  ImVec2 size;  ///< pixels
  double end;   ///< largest range, metres
  double top;   ///< largest value

  ImVec2 at(double range, double value) const {
    return {low.x + size.x * float(range / end), low.y - size.y * float(value / top)};
  }
};

/// 1, 2 or 5 times a power of ten: about a fifth of the whole.
double tick_step(double whole) {
  const double power = std::pow(10, std::floor(std::log10(whole / 5)));
  const double times = whole / 5 / power;
  return power * (times < 1.5 ? 1 : times < 3.5 ? 2 : times < 7.5 ? 5 : 10);
}

void draw_grid(ImDrawList& draw, const Axes& axes) {
  const ImU32 line = IM_COL32(255, 255, 255, 22);
  const ImU32 text = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  const float font = ImGui::GetFontSize();
  const double step = tick_step(axes.end);
  for (double range = 0; range <= axes.end; range += step) {
    const ImVec2 foot = axes.at(range, 0);
    draw.AddLine(foot, axes.at(range, axes.top), line);
    const std::string number = shown_rounded(range, 4) + (range == 0 ? " m" : "");
    draw.AddText({foot.x - ImGui::CalcTextSize(number.c_str()).x / 2, foot.y + 2}, text, number.c_str());
  }
  const double rise = tick_step(axes.top);
  for (double value = 0; value <= axes.top; value += rise) {
    const ImVec2 left = axes.at(0, value);
    draw.AddLine(left, axes.at(axes.end, value), line);
    if (value == 0) continue;
    const std::string number = fmt::format("{:.3g}", value);
    draw.AddText({left.x - ImGui::CalcTextSize(number.c_str()).x - 5, left.y - font / 2}, text, number.c_str());
  }
}

void draw_mark(ImDrawList& draw, const Axes& axes, double range, const std::string& text, ImU32 color, float line) {
  if (!(range > 0 && range <= axes.end)) return;
  const ImVec2 foot = axes.at(range, 0);
  const float height = ImGui::GetFontSize();
  draw.AddLine(foot, axes.at(range, axes.top), color);
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  const bool is_left = foot.x + width + 6 > axes.low.x + axes.size.x;
  draw.AddText({is_left ? foot.x - width - 4 : foot.x + 4, axes.low.y - axes.size.y + line * height}, color,
               text.c_str());
}

/// Draws a line's name above the plot.
void name(ImU32 color, const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted(text);
  ImGui::PopStyleColor();
  ImGui::SameLine();
}

/// Draws axes with a grid in the rest of the window.
Axes draw_axes(double end, double top) {
  const float font = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const Axes axes{.low = {corner.x + 4.2f * font, corner.y + room.y - 1.5f * font},
                  .size = {std::max(room.x - 5.2f * font, 1.0f), std::max(room.y - 2 * font, 1.0f)},
                  .end = end,
                  .top = top};
  draw_grid(*ImGui::GetWindowDrawList(), axes);
  return axes;
}

/// Draws a line through samples at equal distances.
///
/// value  gets the value of a sample
template <typename Samples, typename Value>
void plot(const Axes& axes, const Samples& samples, Value value, ImU32 color, float width) {
  std::vector<ImVec2> points;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    points.push_back(axes.at(axes.end * double(i) / double(samples.size() - 1), std::invoke(value, samples[i])));
  }
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(axes.at(0, axes.top), axes.at(axes.end, 0), true);
  draw.AddPolyline(points.data(), int(points.size()), color, 0, width);
  draw.PopClipRect();
}

void draw_range_curve(const Light& light, const Fog& fog) {
  const RangeCurve curve = make_range_curve(light, fog, kSamples);
  const FogIntensity& solved = curve.solved;
  name(kPeakColor, "(1 - f) a");
  name(kOpacityColor, "  1 - f");
  name(kAttenuationColor, "  a");
  ImGui::TextDisabled("  over the range;  I = %.4g", solved.intensity);
  const Axes axes = draw_axes(curve.end, solved.intensity > 0 ? solved.intensity * 1.6 : 1);
  plot(axes, curve.samples, &RangeCurve::Sample::attenuation, kAttenuationColor, 1.3f);
  plot(axes, curve.samples, &RangeCurve::Sample::opacity, kOpacityColor, 1.3f);
  plot(axes, curve.samples, &RangeCurve::Sample::product, kPeakColor, 2);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw_mark(draw, axes, curve.knee, fmt::format("knee {} m", shown_rounded(curve.knee, 4)), kKneeColor, 2);
  draw_mark(draw, axes, solved.extent, fmt::format("extent {} m", shown_rounded(solved.extent, 4)), kExtentColor, 1);
  if (solved.intensity > 0 && std::isfinite(solved.peak_range)) {
    draw_mark(draw, axes, solved.peak_range,
              fmt::format("peak {:.3g} at {} m", solved.intensity, shown_rounded(solved.peak_range, 4)), kPeakColor, 0);
    draw.AddCircleFilled(axes.at(solved.peak_range, solved.intensity), 4, kPeakColor);
  }
}

void draw_airlight_curve(PlacedLight light, const Atmosphere& air, const render::RenderSettings& settings,
                         const EyeRay& ray) {
  const double peak = solve_fog_intensity(light.light, air.fog).intensity;
  light.light = render::drawn_light(light.light, settings);
  AirlightCurve curve = make_airlight_curve(light, air, ray, kAirlightSamples);
  if (settings.scattering == render::Scattering::single) curve.all.clear();
  const std::vector<double>& drawn = curve.all.empty() ? curve.single : curve.all;
  if (!curve.all.empty()) name(kAllColor, fmt::format("airlight {:.3g}", curve.all.back()).c_str());
  name(kExtentColor,
       fmt::format("{} {:.3g}", curve.all.empty() ? "airlight" : "  single", curve.single.back()).c_str());
  name(kPeakColor, fmt::format("  peak {:.3g}", peak).c_str());
  ImGui::TextDisabled("  along the ray at +");
  const bool is_peak_near = peak < 3 * drawn.back();  // else only its number above is shown
  const Axes axes = draw_axes(curve.end, std::max({drawn.back(), is_peak_near ? peak : 0, 1e-9}) * 1.2);
  plot(axes, curve.single, std::identity(), kExtentColor, 1.6f);
  if (!curve.all.empty()) plot(axes, curve.all, std::identity(), kAllColor, 2);
  plot(axes, std::vector<double>(2, peak), std::identity(), kPeakColor, 1.3f);
  const double nearest = glm::dot(light.position - ray.origin, ray.direction);
  draw_mark(*ImGui::GetWindowDrawList(), axes, nearest,
            fmt::format("lamp {} m aside",
                        shown_rounded(glm::distance(light.position, ray.origin + nearest * ray.direction), 3)),
            kKneeColor, 0);
  if (std::isfinite(ray.length)) {
    draw_mark(*ImGui::GetWindowDrawList(), axes, curve.end, curve.end < ray.length ? "" : "surface", kKneeColor, 1);
  }
}

}  // namespace

void draw_curve(const Session& session) try {
  const PlacedLight light = session.light_now(*session.picked);
  const drawing::DrawingOptions& options = session.settings[session.edited];
  const render::RenderSettings settings = options.settings();
  const Atmosphere air = options.atmosphere_of(session.scene(), options.visibility_in(session.scene()));
  if (settings.fog_lighting == render::FogLighting::peak || !options.fog) {
    draw_range_curve(light.light, session.fog(session.edited));
  } else {
    draw_airlight_curve(light, air, settings, session.ray);
  }
} catch (const CLI::Error& wrong) {
  ImGui::TextDisabled("%s", wrong.what());
}

}  // namespace litfog::window
