// SPDX-License-Identifier: Apache-2.0
#include "window/picture_panel.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "text/shown_number.h"
#include "window/camera_motion.h"
#include "window/light_levels.h"
#include "window/light_pick.h"
#include "window/moved_picture.h"

namespace litfog::window {
namespace {

constexpr double kPickReach = 0.04;        // fraction of the height
constexpr double kTurnPerHeight = 1.5;     // radians for a drag over the picture's height
constexpr double kZoomPerNotch = 0.85;     // factor of the target's distance
constexpr double kTargetsPerSecond = 0.5;  // flying speed in distances to the target
constexpr double kMinSpeed = 1;            // metres a second
constexpr float kWipeReach = 7;            // pixels

void* texture_id(const gl::TextureName& texture) {
  return reinterpret_cast<void*>(std::uintptr_t{texture.id()});  // NOLINT: how ImGui takes OpenGL's names
}

void upload(const gl::TextureName& texture, const render::Picture& picture, const std::vector<std::uint8_t>& pixels) {
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, picture.width, picture.height, 0, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

/// Draws text on the picture.
void draw_words(ImDrawList& draw, ImVec2 at, const std::string& words) {
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  draw.AddRectFilled({at.x - 5, at.y - 3}, {at.x + size.x + 5, at.y + size.y + 3}, IM_COL32(0, 0, 0, 150), 3);
  draw.AddText(at, IM_COL32(230, 230, 230, 255), words.c_str());
}

/// "A: unified, airlight, exp, 150 m"
std::string settings_in_words(char letter, const drawing::DrawingOptions& options) {
  const std::string fog =
      options.fog ? fmt::format("{}, {} m", name_of(*options.fog), shown_rounded(*options.visibility, 4)) : "clear";
  return fmt::format("{}: {}, {}, {}", letter, options.render.path->name, name_of(options.settings().fog_lighting),
                     fog);
}

/// The panel's rectangle on the screen.
struct Area {
  ImVec2 corner;
  ImVec2 size;

  ImVec2 end() const { return {corner.x + size.x, corner.y + size.y}; }
  ImVec2 at(const glm::dvec2& fraction) const {
    return {corner.x + float(fraction.x) * size.x, corner.y + float(fraction.y) * size.y};
  }
  glm::dvec2 fraction_of(ImVec2 point) const { return {(point.x - corner.x) / size.x, (point.y - corner.y) / size.y}; }
  /// Where A ends and B begins.
  float wipe_x(const Session& session) const { return corner.x + std::round(float(session.wipe) * size.x); }
};

void draw_moved(ImDrawList& draw, const Area& area, const gl::TextureName& texture, const MovedPicture& moved) {
  for (int row = 0; row < MovedPicture::kRows; ++row) {
    for (int column = 0; column < MovedPicture::kColumns; ++column) {
      ImVec2 corners[4], sources[4];
      bool is_known = true;
      for (int i = 0; i < 4; ++i) {  // around the cell
        const int x = column + (i == 1 || i == 2), y = row + i / 2;
        const auto source = moved.source(x, y);
        is_known = is_known && source;
        corners[i] = area.at(MovedPicture::place(x, y));
        if (source) sources[i] = {float(source->x), float(source->y)};
      }
      if (!is_known) continue;
      draw.AddImageQuad(texture_id(texture), corners[0], corners[1], corners[2], corners[3], sources[0], sources[1],
                        sources[2], sources[3]);
    }
  }
}

/// Moves the picked lamp at its distance from the camera's plane.
void drag_lamp(Session& session, const Area& area) {
  PlacedLight light = session.lights()[*session.picked];
  const scene::CameraAxes axes = axes_of(session.camera);
  const double depth = glm::dot(light.position - session.camera.position, axes.forward);
  const double metres = 2 * depth * std::tan(double(session.camera.field_of_view) / 2) / double(area.size.y);
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  light.position += metres * (double(delta.x) * axes.right - double(delta.y) * axes.up);
  if (!find_error(light)) session.change(*session.picked, light);
}

/// Turns the camera as the left button drags, about a pivot if it orbits, and shifts it as the right button drags.
void drag_camera(Session& session, const Area& area, const glm::dvec3& pivot) {
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  const double right = -double(delta.x / area.size.y);
  const double up = double(delta.y / area.size.y);
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
    if (session.motion == CameraMotion::orbit)
      orbit(session.camera, pivot, right * kTurnPerHeight, up * kTurnPerHeight);
    else
      look(session.camera, right * kTurnPerHeight, up * kTurnPerHeight);
  } else if (ImGui::IsMouseDragging(ImGuiMouseButton_Right)) {
    const double metres = 2 * target_distance(session.camera) * std::tan(double(session.camera.field_of_view) / 2);
    fly(session.camera, right * metres, up * metres, 0);
  }
}

/// The point under the mouse, or else the camera's target.
glm::dvec3 pointed_at(const Session& session) {
  const EyeRay& ray = session.ray;
  return std::isfinite(ray.length) ? ray.origin + ray.length * ray.direction : session.camera.target;
}

void zoom(Session& session, const glm::dvec3& pivot, double notches) {
  const double factor = std::pow(kZoomPerNotch, notches);
  if (session.motion == CameraMotion::orbit)
    approach(session.camera, pivot, factor);
  else
    fly(session.camera, 0, 0, (1 - factor) * target_distance(session.camera));
}

/// Draws a lamp's reach: circles at its extent, and lines along the edge of its cone.
void draw_reach(ImDrawList& draw, const Area& area, double aspect, const scene::Camera& camera,
                const PlacedLight& light) {
  constexpr int kPieces = 48;
  constexpr int kEdges = 8;
  constexpr double kTurn = 2 * std::numbers::pi;
  const double range = std::min(compute_extent(light.light.attenuation, light.light.threshold), kFarthestSurface);
  const auto trace = [&](const auto& point_at) {
    std::optional<glm::dvec2> last;
    for (int i = 0; i <= kPieces; ++i) {
      const auto place = place_in_picture(camera, aspect, point_at(double(i) / kPieces));
      if (last && place) draw.AddLine(area.at(*last), area.at(*place), IM_COL32(255, 180, 80, 120));
      last = place;
    }
  };
  const auto circle = [&](const glm::dvec3& middle, const glm::dvec3& a, const glm::dvec3& b) {
    trace([&](double t) { return middle + std::cos(kTurn * t) * a + std::sin(kTurn * t) * b; });
  };
  const glm::dvec3& at = light.position;
  const glm::dvec3 axis = range * light.direction;
  const glm::dvec3 aside = std::abs(light.direction.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = range * glm::normalize(glm::cross(light.direction, aside));
  const glm::dvec3 v = glm::cross(light.direction, u);
  if (light.light.cone == Cone{}) {
    circle(at, u, v);
    circle(at, v, axis);
    circle(at, axis, u);
    return;
  }
  const double edge = cutoff_angle(light.light.cone);
  for (const double angle : {edge, angle_at_level(light.light.cone, 0.5)}) {
    circle(at + std::cos(angle) * axis, std::sin(angle) * u, std::sin(angle) * v);
  }
  for (int i = 0; i < kEdges; ++i) {
    const glm::dvec3 out = std::cos(kTurn * i / kEdges) * u + std::sin(kTurn * i / kEdges) * v;
    trace([&](double t) { return at + t * (std::cos(edge) * axis + std::sin(edge) * out); });
  }
}

/// Draws the scale of false colours in the picture's lower left corner.
void draw_scale(ImDrawList& draw, const Area& area) {
  constexpr int kLevels = int(kMostLevel - kLeastLevel);
  const float font = ImGui::GetFontSize();
  const float step = 2 * font;
  const ImVec2 corner{area.corner.x + 12, area.end().y - 3 * font};
  draw_words(draw, {corner.x, corner.y - 1.4f * font}, "EV above white");
  for (int i = 0; i <= kLevels; ++i) {
    const float level = float(kLeastLevel) + float(i);
    const float luminance = std::exp2(level);
    const auto color = false_colors({.width = 1, .height = 1, .rgb = {luminance, luminance, luminance}}, 0);
    const ImVec2 at{corner.x + float(i) * step, corner.y};
    draw.AddRectFilled(at, {at.x + step, at.y + font}, IM_COL32(color[0], color[1], color[2], 255));
    if (i % 2 == 0) draw_words(draw, {at.x, at.y + font}, fmt::format("{:+}", level));
  }
}

/// Marks the ray of the curve.
void draw_cross(ImDrawList& draw, ImVec2 at) {
  const ImU32 color = IM_COL32(255, 255, 255, 160);
  draw.AddLine({at.x - 6, at.y}, {at.x + 7, at.y}, color);
  draw.AddLine({at.x, at.y - 6}, {at.x, at.y + 7}, color);
}

/// Draws rings around the picked lamp, its copies and the lamp under the mouse, with that lamp's name.
void mark_lamps(ImDrawList& draw, const Area& area, double aspect, const Session& session,
                std::optional<std::size_t> hovered) {
  const auto mark = [&](std::size_t light, ImU32 color, float radius) {
    const auto place = place_in_picture(session.camera, aspect, session.lights()[light].position);
    if (place) draw.AddCircle(area.at(*place), radius, color, 0, 1.5f);
    return place;
  };
  for (std::size_t i = 0; session.picked && i < session.lights().size(); ++i) {
    if (i == session.picked)
      mark(i, IM_COL32(255, 180, 80, 255), 9);
    else if (session.are_copies(*session.picked, i))
      mark(i, IM_COL32(255, 180, 80, 70), 4);
  }
  if (!hovered) return;
  const auto place = mark(*hovered, IM_COL32(255, 255, 255, 200), 9);
  if (!place) return;
  const ImVec2 at = area.at(*place);
  draw_words(draw, {at.x + 16, at.y - 8}, session.lights()[*hovered].light.name);
}

/// Draws the line between two settings' pictures, and their names.
void draw_wipe(ImDrawList& draw, const Area& area, const Session& session) {
  const float x = area.wipe_x(session);
  const ImVec2 end = area.end();
  draw.AddLine({x, area.corner.y}, {x, end.y}, IM_COL32(255, 255, 255, 200));
  draw.AddCircleFilled({x, (area.corner.y + end.y) / 2}, 5, IM_COL32(255, 255, 255, 255));
  const std::string right = settings_in_words('B', session.settings[1]);
  draw_words(draw, {area.corner.x + 12, area.corner.y + 10}, settings_in_words('A', session.settings[0]));
  draw_words(draw, {end.x - 12 - ImGui::CalcTextSize(right.c_str()).x, area.corner.y + 10}, right);
}

}  // namespace

void PicturePanel::show(const Delivery& delivery, bool is_false_colored) {
  shown_ = delivery.pictures.size();
  camera_ = delivery.order.camera;
  aspect_ = double(delivery.order.width) / delivery.order.height;
  for (std::size_t i = 0; i < shown_; ++i) {
    const DrawnPicture& drawn = delivery.pictures[i];
    upload(textures_[i], drawn.light,
           is_false_colored ? false_colors(drawn.light, drawn.display.exposure.ev) : drawn.pixels);
  }
}

void PicturePanel::draw(Session& session, const measure::TriangleTree* surfaces, std::optional<std::size_t> hovered) {
  const Area area{ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail()};
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  width_ = std::max(int(area.size.x * scale.x), 1);
  height_ = std::max(int(area.size.y * scale.y), 1);
  const double aspect = double(width_) / height_;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const bool is_split = session.is_split && shown_ > 1;
  ImGui::InvisibleButton("picture", {std::max(area.size.x, 1.0f), std::max(area.size.y, 1.0f)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const ImGuiIO& io = ImGui::GetIO();
  const bool is_over = ImGui::IsItemHovered();
  const scene::Camera before = session.camera;
  const glm::dvec2 mouse = area.fraction_of(io.MousePos);
  mouse_.reset();
  if (is_over) pointed_ = *(mouse_ = mouse);
  session.ray = ray_through(session.camera, aspect, pointed_);
  const auto hit =
      surfaces ? surfaces->nearest(session.ray.origin, session.ray.direction, 0, kFarthestSurface) : std::nullopt;
  if (hit) session.ray.length = hit->distance;
  const bool is_at_wipe = is_split && is_over && std::abs(io.MousePos.x - area.wipe_x(session)) < kWipeReach;
  if (ImGui::IsItemActivated()) {
    drags_wipe_ = is_at_wipe;
    pivot_ = pointed_at(session);
  }
  if (is_at_wipe || (drags_wipe_ && ImGui::IsItemActive())) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActive() && drags_wipe_)
    session.wipe = std::clamp(mouse.x, 0.0, 1.0);
  else if (ImGui::IsItemActive() && io.KeyCtrl && session.picked && session.is_movable(*session.picked))
    drag_lamp(session, area);
  else if (ImGui::IsItemActive())
    drag_camera(session, area, pivot_);
  const auto under_mouse = light_at(session.camera, aspect, session.lights(), mouse, kPickReach);
  const bool is_click = ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) && !drags_wipe_ &&
                        io.MouseDragMaxDistanceSqr[0] < io.MouseDragThreshold * io.MouseDragThreshold;
  if (is_click) session.picked = under_mouse;
  if (is_over && !is_at_wipe && !ImGui::IsItemActive()) hovered = under_mouse;
  if (is_over && io.MouseWheel != 0) zoom(session, pointed_at(session), double(io.MouseWheel));
  fly_by_keys(session);
  if (surfaces) stay_before_surfaces(session.camera, before, *surfaces);

  draw.PushClipRect(area.corner, area.end(), true);
  std::optional<MovedPicture> moved;
  if (shown_ > 0 && session.camera != camera_) moved.emplace(camera_, aspect_, session.camera, aspect, surfaces);
  const auto draw_picture = [&](const gl::TextureName& texture) {
    if (moved)
      draw_moved(draw, area, texture, *moved);
    else
      draw.AddImage(texture_id(texture), area.corner, area.end());
  };
  if (shown_ > 0) draw_picture(textures_[0]);
  if (is_split) {
    draw.PushClipRect({area.wipe_x(session), area.corner.y}, area.end(), true);
    draw_picture(textures_[1]);
    draw.PopClipRect();
  }
  mark_lamps(draw, area, aspect, session, hovered);
  if (session.picked) draw_reach(draw, area, aspect, session.camera, session.light_now(*session.picked));
  if (session.picked && !is_over) draw_cross(draw, area.at(pointed_));
  if (is_split) draw_wipe(draw, area, session);
  if (session.is_false_colored) draw_scale(draw, area);
  draw.PopClipRect();
}

void PicturePanel::fly_by_keys(Session& session) {
  const ImGuiIO& io = ImGui::GetIO();
  is_moving_ = false;
  if (io.WantTextInput || io.KeyCtrl) return;
  const auto key = [](char letter) { return double(ImGui::IsKeyDown(letter)); };  // GLFW's letters are ASCII's
  const glm::dvec3 step(key('D') - key('A'), key('E') - key('Q'), key('W') - key('S'));
  if (step == glm::dvec3(0)) return;
  is_moving_ = true;
  const double speed = std::max(kTargetsPerSecond * target_distance(session.camera), kMinSpeed);
  const double metres = speed * std::min(double(io.DeltaTime), 0.1) * (io.KeyShift ? 4 : 1);
  fly(session.camera, step.x * metres, step.y * metres, step.z * metres);
}

}  // namespace litfog::window
