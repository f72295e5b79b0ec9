// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/framebuffer.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "litfog/gl/unsupported.h"
#include "render/gpu/texture_unit.h"

namespace litfog::render {

Framebuffer::Framebuffer(int width, int height, Passes passes, int samples)
    : width_(width), height_(height), depth_target_(samples == 1 ? GL_TEXTURE_2D : GL_TEXTURE_2D_MULTISAMPLE) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  if (std::max(width, height) > largest) {
    throw gl::Unsupported(fmt::format("this driver draws at most {} pixels a side", largest));
  }
  GLint most_samples = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most_samples);
  if (samples > most_samples) {
    throw gl::Unsupported(fmt::format("this driver draws at most {} samples a pixel, not {}", most_samples, samples));
  }
  const auto attach = [&](const gl::FramebufferName& framebuffer, const gl::RenderbufferName& buffer, GLenum attachment,
                          GLenum format, GLint count) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, count, format, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.id());
  };
  const bool is_summed = passes == Passes::several;
  const GLenum color = is_summed ? GL_RGBA32F : GL_RGBA16F;  // half floats would lose up to 1/2048 a pass
  attach(resolved_, resolved_color_, GL_COLOR_ATTACHMENT0, color, 0);
  const bool resolved_is_whole = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  attach(drawn_, drawn_color_, GL_COLOR_ATTACHMENT0, color, samples == 1 ? 0 : samples);  // drivers turn 1 into 2
  bind_texture(kUploadUnit, drawn_depth_, depth_target_);
  const GLenum depth = is_summed ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
  if (samples == 1) {
    const auto [layout, type] = is_summed ? std::pair{GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV}
                                          : std::pair{GL_DEPTH_COMPONENT, GL_FLOAT};
    glTexImage2D(depth_target_, 0, GLint(depth), width, height, 0, GLenum(layout), GLenum(type), nullptr);
    set_filter(depth_target_, GL_NEAREST);
  } else {
    glTexImage2DMultisample(depth_target_, samples, depth, width, height, GL_TRUE);
  }
  glFramebufferTexture2D(GL_FRAMEBUFFER, is_summed ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, depth_target_,
                         drawn_depth_.id(), 0);
  glGetIntegerv(GL_SAMPLES, &samples_);
  samples_ = std::max(samples_, 1);  // 0 without multisampling
  const bool drawn_is_whole = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (!resolved_is_whole || !drawn_is_whole || glGetError() != GL_NO_ERROR) {
    throw gl::Unsupported(
        fmt::format("this driver gives no float framebuffer of {}x{} pixels, {} samples each", width, height, samples));
  }
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
  glViewport(0, 0, width_, height_);
}

void Framebuffer::resolve() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id());
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  bind_resolved();
}

void Framebuffer::bind_resolved() const {
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
  glViewport(0, 0, width_, height_);
}

void Framebuffer::bind_depth(unsigned unit) const { bind_texture(unit, drawn_depth_, depth_target_); }

Picture Framebuffer::read() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
  Picture picture{width_, height_, std::vector<float>(std::size_t(width_) * std::size_t(height_) * 3)};
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGB, GL_FLOAT, picture.rgb.data());
  const auto row = std::ptrdiff_t(width_) * 3;  // GL's bottom row comes first
  for (std::ptrdiff_t low = 0, high = height_ - 1; low < high; ++low, --high) {
    std::swap_ranges(picture.rgb.begin() + low * row, picture.rgb.begin() + (low + 1) * row,
                     picture.rgb.begin() + high * row);
  }
  return picture;
}

void check_float_framebuffer() {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE || glGetError() != GL_NO_ERROR) {
    throw gl::Unsupported("this driver cannot draw into textures of floats");
  }
}

}  // namespace litfog::render
