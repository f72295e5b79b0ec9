// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/seen_ranges.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <string>
#include <vector>

#include "render/gpu/depth.h"
#include "render/gpu/render_shaders.h"
#include "render/plan/fog_top.h"

namespace litfog::render {
namespace {

gl::Program make_program(int samples) {
  const std::string count = fmt::format("#define SAMPLE_COUNT {}\n", samples);
  std::vector<gl::ShaderSource> files(render_shaders().begin(), render_shaders().end());
  files.push_back({"generated/sample_count.glsl", count});
  return gl::Program("sky.vert", "airlight/airlight_seen.frag", files);
}

}  // namespace

SeenRanges::SeenRanges(int samples) : program_(make_program(samples)) {}

void SeenRanges::set_size(glm::ivec2 size) {
  size_ = size;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  attach_texels(GL_COLOR_ATTACHMENT0, ranges_, size, GL_RGBA32F);
  check_float_framebuffer();
}

void SeenRanges::draw(const Framebuffer& framebuffer, const View& view) {
  pass_.begin();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glViewport(0, 0, size_.x, size_.y);
  program_.use();
  framebuffer.bind_depth(PassTextures(program_).unit("depths"));
  set_uniform(program_, "direction_from_clip", view.direction_from_clip);
  set_uniform(program_, "far_plane", 0.0f);  // arbitrary, because no depth is tested
  set_uniform(program_, "eye", view.eye);
  set_uniform(program_, "forward", view.forward);
  set_uniform(program_, "near_plane", kNearPlane);
  set_fog_top(program_, view.top_above_eye);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace litfog::render
