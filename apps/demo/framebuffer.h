// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture.h"

namespace litfog::demo {

/// What the demo draws into: linear RGBA half floats and depth, four samples a pixel where the driver has them.
class Framebuffer {
 public:
  /// throws gl::Unsupported where the driver has no framebuffer of that size
  Framebuffer(int width, int height);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  /// Makes it the target of drawing.
  void bind() const;
  /// Averages the samples and reads the picture back.
  Picture read() const;

 private:
  int width_;
  int height_;
  unsigned drawn_ = 0;
  unsigned resolved_ = 0;
  unsigned buffers_[3] = {};  // drawn colour, drawn depth, resolved colour
};

}  // namespace litfog::demo
