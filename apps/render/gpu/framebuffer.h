// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/gl_name.h"
#include "render/picture.h"

namespace litfog::render {

/// How many times a surface may be drawn.
enum class Passes { one, several };

/// A renderer's target: linear RGBA half floats and depth. For several passes it has floats, which lose less in sums,
/// and a stencil.
class Framebuffer {
 public:
  /// samples  per pixel; some drivers take more
  /// throws   gl::Unsupported where the driver has no framebuffer of that size or fewer samples
  Framebuffer(int width, int height, Passes passes, int samples);

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }  ///< per pixel, as allocated by the driver
  double aspect() const { return double(width_) / height_; }
  /// Makes this the target of drawing.
  void bind() const;
  /// Averages the samples of each pixel. Until the next bind(), drawing changes the averages.
  void resolve() const;
  /// Makes the averages the target of drawing again.
  void bind_resolved() const;
  /// Binds the samples' depths as a multisample texture, or as a plain texture if a pixel has one sample.
  void bind_depth(unsigned unit) const;
  /// Reads back the averages of the last resolve() and what was drawn over them.
  Picture read() const;

 private:
  int width_;
  int height_;
  int samples_;
  gl::FramebufferName drawn_;
  gl::FramebufferName resolved_;
  gl::RenderbufferName drawn_color_;
  unsigned depth_target_;
  gl::TextureName drawn_depth_;  // depth and stencil
  gl::RenderbufferName resolved_color_;
};

/// Throws gl::Unsupported where the driver cannot draw into the bound framebuffer of float textures.
void check_float_framebuffer();

}  // namespace litfog::render
