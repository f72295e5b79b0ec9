// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "litfog/gl/gl_name.h"
#include "window/picture_maker.h"
#include "window/session.h"

namespace litfog::window {

/// The picture in the current ImGui window, and how mouse and keyboard move in it. Needs a current GL context.
class PicturePanel {
 public:
  /// Takes pictures to show, of any size: they are stretched over the panel.
  void show(const Delivery& delivery, bool is_false_colored);

  /// Draws them over all of the window, and takes the mouse and the keyboard for the session.
  ///
  /// surfaces  of the scene; null: none is known yet
  /// hovered   a lamp to be marked besides the picked one
  void draw(Session& session, const measure::TriangleTree* surfaces, std::optional<std::size_t> hovered);

  /// Where the mouse is over the picture, as fractions of its width and height.
  std::optional<glm::dvec2> mouse() const { return mouse_; }
  // As of the last draw(), in pixels of the framebuffer.
  int width() const { return width_; }
  int height() const { return height_; }
  /// Whether something moves as long as time passes: a key is held.
  bool is_moving() const { return is_moving_; }

 private:
  void fly_by_keys(Session& session);

  std::array<gl::TextureName, 2> textures_;
  std::size_t shown_ = 0;  // how many of them
  std::optional<glm::dvec2> mouse_;
  glm::dvec2 pointed_{0.5};  // where the mouse was last: fractions of the picture
  glm::dvec3 pivot_{0.0};    // what a drag orbits about
  int width_ = 0;
  int height_ = 0;
  bool is_moving_ = false;
  bool drags_wipe_ = false;
};

}  // namespace litfog::window
