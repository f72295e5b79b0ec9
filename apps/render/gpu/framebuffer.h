// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/gl_name.h"
#include "render/picture.h"

namespace litfog::render {

/// How often a surface is drawn at most.
enum class Passes { one, several };

/// What a renderer draws into: linear RGBA half floats and depth. Several passes draw into floats, because their sums
/// round less, and have a stencil too.
class Framebuffer {
 public:
  /// samples  a pixel: some drivers take more than that
  /// throws   gl::Unsupported where the driver has no framebuffer of that size or fewer samples
  Framebuffer(int width, int height, Passes passes, int samples);

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }  ///< that the driver took
  double aspect() const { return double(width_) / height_; }
  /// Makes it the target of drawing.
  void bind() const;
  /// Averages the samples. What is drawn from then on, until bind(), is drawn over their averages.
  void resolve() const;
  /// Makes the averages the target of drawing again.
  void bind_resolved() const;
  /// Binds the samples' depths as a multisample texture, as a plain one if a pixel has one sample.
  void bind_depth(unsigned unit) const;
  /// Reads the averages back, from the last resolve() on.
  Picture read() const;

 private:
  int width_;
  int height_;
  int samples_;
  gl::FramebufferName drawn_;
  gl::FramebufferName resolved_;
  gl::RenderbufferName drawn_color_;
  unsigned depth_target_;
  gl::TextureName drawn_depth_;  // and stencil
  gl::RenderbufferName resolved_color_;
};

/// Throws gl::Unsupported where the driver cannot draw into the bound framebuffer, which is of textures of floats.
void check_float_framebuffer();

}  // namespace litfog::render
