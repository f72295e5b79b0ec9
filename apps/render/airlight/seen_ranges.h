// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/gpu/framebuffer.h"
#include "render/gpu/pass_textures.h"
#include "render/gpu/texel_target.h"
#include "render/plan/view.h"

namespace litfog::render {

/// How far the eye sees through each pixel: four ranges stand for the depths of its samples
/// (shaders/airlight/airlight_seen.frag). Needs a current GL context.
class SeenRanges {
 public:
  /// samples  of each pixel
  explicit SeenRanges(int samples);

  /// Sets the size of the pictures.
  ///
  /// throws  gl::Unsupported where the driver cannot draw into textures of floats of that size
  void set_size(glm::ivec2 size);
  /// Computes the ranges from a framebuffer's depths.
  void draw(const Framebuffer& framebuffer, const View& view);
  /// Lets a pass read the ranges (shaders/airlight/seen.glsl).
  void bind(PassTextures& textures) const { textures.bind("seen_ranges", ranges_, GL_TEXTURE_RECTANGLE); }

 private:
  glm::ivec2 size_{0};
  TexelPass pass_;
  gl::Program program_;
  gl::FramebufferName framebuffer_;
  gl::TextureName ranges_;
};

}  // namespace litfog::render
