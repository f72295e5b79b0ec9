// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/gl_name.h"
#include "render/picture.h"

namespace litfog::render {

/// How often a surface is drawn at most.
enum class Passes { one, several };

/// What the demo draws into: linear RGBA half floats and depth. Several passes draw into floats, because their sums
/// round less, and have a stencil too. Four samples a pixel where the driver has them.
class Framebuffer {
 public:
  /// throws gl::Unsupported where the driver has no framebuffer of that size
  Framebuffer(int width, int height, Passes passes);

  /// Samples a pixel that this context draws with: four, or fewer where it has no more.
  static int samples();

  int width() const { return width_; }
  int height() const { return height_; }
  double aspect() const { return double(width_) / height_; }
  /// Makes it the target of drawing.
  void bind() const;
  /// Averages the samples. What is drawn from then on, until bind(), is drawn over their averages.
  void resolve() const;
  /// Makes the averages the target of drawing again.
  void bind_resolved() const;
  /// Binds the samples' depths as a multisample texture.
  void bind_depth(unsigned unit) const;
  /// Reads the averages back, from the last resolve() on.
  Picture read() const;

 private:
  int width_;
  int height_;
  gl::FramebufferName drawn_;
  gl::FramebufferName resolved_;
  gl::RenderbufferName drawn_color_;
  gl::TextureName drawn_depth_;  // and stencil
  gl::RenderbufferName resolved_color_;
};

}  // namespace litfog::render
