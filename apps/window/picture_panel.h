// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "litfog/gl/gl_name.h"
#include "window/picture_maker.h"
#include "window/session.h"

namespace litfog::window {

/// The picture in the current ImGui window, and its mouse and keyboard control. Needs a current GL context.
class PicturePanel {
 public:
  /// Takes pictures of any size, which are stretched over the panel.
  void show(const Delivery& delivery, bool is_false_colored);
  /// Shows no picture until the next.
  void clear() { shown_ = 0; }

  /// Applies mouse and keyboard to the session, and draws the pictures over the whole window, moved by MovedPicture if
  /// the camera has moved since they were made.
  ///
  /// surfaces  the scene's; null: not yet known
  /// hovered   a lamp to mark besides the picked one
  void draw(Session& session, const measure::TriangleTree* surfaces, std::optional<std::size_t> hovered);

  /// The mouse's position in the picture, as fractions of its width and height; nothing outside.
  std::optional<glm::dvec2> mouse() const { return mouse_; }
  // As of the last draw(), in pixels of the framebuffer.
  int width() const { return width_; }
  int height() const { return height_; }
  /// Whether a held key moves the camera.
  bool is_moving() const { return is_moving_; }

 private:
  void fly_by_keys(Session& session);

  std::array<gl::TextureName, 2> textures_;
  std::size_t shown_ = 0;  // number of pictures shown
  scene::Camera camera_;   // by which they were drawn
  double aspect_ = 1;      // their width / height
  std::optional<glm::dvec2> mouse_;
  glm::dvec2 pointed_{0.5};  // the mouse's last position: fractions of the picture
  glm::dvec3 pivot_{0.0};    // a drag orbits about this point
  int width_ = 0;
  int height_ = 0;
  bool is_moving_ = false;
  bool drags_wipe_ = false;
};

}  // namespace litfog::window
