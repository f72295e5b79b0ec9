// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/geometry_buffer.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <iterator>

#include "litfog/gl/unsupported.h"
#include "render/gpu/depth.h"
#include "render/gpu/render_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"

namespace litfog::render {
namespace {

constexpr GLenum kAttachments[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2,
                                   GL_COLOR_ATTACHMENT3, GL_COLOR_ATTACHMENT4, GL_COLOR_ATTACHMENT5};

bool is_complete() { return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE; }

}  // namespace

bool GeometrySample::is_of_same_fragment(const GeometrySample& other) const {
  return position == other.position && material == other.material && normal_texel == other.normal_texel &&
         tangent == other.tangent && normal == other.normal && gloss == other.gloss && emission == other.emission &&
         opacity == other.opacity && albedo == other.albedo;
}

GeometryBuffer::GeometryBuffer(int width, int height, int samples)
    : width_(width),
      height_(height),
      samples_(samples),
      sample_program_("whole_picture.vert", "geometry_sample.frag", render_shaders()) {
  static_assert(sizeof(GeometrySample) == kTargets * sizeof(glm::vec4) && std::size(kAttachments) == kTargets);
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
  for (int i = 0; i < kTargets; ++i) {
    bind_texture(kUploadUnit, textures_[i], GL_TEXTURE_2D_MULTISAMPLE);
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples_, GL_RGBA32F, width, height, GL_TRUE);
    glFramebufferTexture2D(GL_FRAMEBUFFER, kAttachments[i], GL_TEXTURE_2D_MULTISAMPLE, textures_[i].id(), 0);
  }
  bind_texture(kUploadUnit, drawn_depth_, GL_TEXTURE_2D_MULTISAMPLE);
  glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples_, GL_DEPTH32F_STENCIL8, width, height, GL_TRUE);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D_MULTISAMPLE, drawn_depth_.id(), 0);
  glDrawBuffers(kTargets, kAttachments);
  const bool drawn_is_whole = is_complete();
  glBindFramebuffer(GL_FRAMEBUFFER, read_.id());
  glBindRenderbuffer(GL_RENDERBUFFER, read_color_.id());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, width, std::min(height, kMaxRows));
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, read_color_.id());
  if (!is_complete() || !drawn_is_whole || glGetError() != GL_NO_ERROR) {
    throw gl::Unsupported(
        fmt::format("this driver gives no float framebuffer of {}x{} pixels, {} samples each", width, height, samples));
  }
}

void GeometryBuffer::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
  glViewport(0, 0, width_, height_);
  if (samples_ == 1) glDisable(GL_MULTISAMPLE);  // the textures may have more samples than asked for
  begin_depths();
  constexpr float kSky[] = {0, 0, 0, -1};
  for (int i = 0; i < kTargets; ++i) glClearBufferfv(GL_COLOR, i, kSky);
}

void GeometryBuffer::begin_layer(int layer) const {
  assert(layer >= 0 && layer < kMaxLayers);
  begin();
  glDepthFunc(GL_ALWAYS);
  glClear(GL_STENCIL_BUFFER_BIT);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, layer, 0xff);
  glStencilOp(GL_INCR, GL_INCR, GL_INCR);  // counts the fragments drawn
}

void GeometryBuffer::end() const {
  end_depths();
  glDisable(GL_STENCIL_TEST);
  glEnable(GL_MULTISAMPLE);
}

std::vector<GeometrySample> GeometryBuffer::read_rows(int first, int count) const {
  assert(first >= 0 && count >= 1 && count <= kMaxRows && first + count <= height_);
  const auto pixels = std::size_t(width_) * std::size_t(count);
  const auto samples = std::size_t(samples_);
  std::vector<GeometrySample> rows(pixels * samples);
  std::vector<glm::vec4> texels(pixels);
  glBindFramebuffer(GL_FRAMEBUFFER, read_.id());
  glViewport(0, 0, width_, count);
  glBindVertexArray(vertex_array_.id());
  sample_program_.use();
  set_uniform(sample_program_, "target", 0);
  set_uniform(sample_program_, "depths", 1);
  set_uniform(sample_program_, "top_row", height_ - 1 - first);  // GL counts rows from the bottom
  bind_texture(1, drawn_depth_, GL_TEXTURE_2D_MULTISAMPLE);
  for (std::size_t i = 0; i < kTargets; ++i) {
    set_uniform(sample_program_, "ends_in_depth", i + 1 == kTargets);
    bind_texture(0, textures_[i], GL_TEXTURE_2D_MULTISAMPLE);
    for (std::size_t sample = 0; sample < samples; ++sample) {
      set_uniform(sample_program_, "sample_index", int(sample));
      glDrawArrays(GL_TRIANGLES, 0, 3);
      glReadPixels(0, 0, width_, count, GL_RGBA, GL_FLOAT, texels.data());
      for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        std::memcpy(reinterpret_cast<char*>(&rows[pixel * samples + sample]) + i * sizeof(glm::vec4), &texels[pixel],
                    sizeof(glm::vec4));
      }
    }
  }
  return rows;
}

}  // namespace litfog::render
