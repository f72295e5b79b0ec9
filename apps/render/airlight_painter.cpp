// SPDX-License-Identifier: Apache-2.0
#include "render/airlight_painter.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "litfog/airlight.h"
#include "litfog/gl/unsupported.h"
#include "render/demo_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"
#include "render/renderer.h"

namespace litfog::render {
namespace {

/// What a light may leave out of a pixel: an eighth of a step of the display where it is darkest and sRGB has this slope.
constexpr float kDarkestSlope = 12.92f;
constexpr float kBudget = 1 / (8 * 255 * kDarkestSlope);
constexpr int kGridStep = 4;  // pixels

// Of the stencil, which is 0 elsewhere.
constexpr GLint kFilled = 1;
constexpr GLint kCore = 2;

void bind_texture(const gl::TextureName& texture) {
  glActiveTexture(GL_TEXTURE0 + kGridUnit);
  glBindTexture(GL_TEXTURE_2D, texture.id());
}

/// A program that reads that many depths a pixel.
gl::Program make_program(const char* vertex, const char* fragment, const scene::Scene& scene, int samples) {
  const std::string count = fmt::format("#define SAMPLE_COUNT {}\n", samples);
  std::vector<gl::ShaderSource> files = scene_shaders(!scene.cookies.empty());
  files.push_back({"sample_count.glsl", count});
  return gl::Program(vertex, fragment, files);
}

}  // namespace

AirlightPainter::AirlightPainter(const scene::Scene& scene, const gl::FogLightBuffer& fog_lights,
                                 const Framebuffer& framebuffer)
    : scene_(scene),
      fog_lights_(fog_lights),
      picture_size_(framebuffer.width(), framebuffer.height()),
      grid_size_((picture_size_ + (kGridStep - 1)) / kGridStep + 1),
      light_program_(make_program("airlight.vert", "airlight.frag", scene, framebuffer.samples())),
      core_program_(make_program("airlight.vert", "nothing.frag", scene, framebuffer.samples())),
      fill_program_(make_program("whole_picture.vert", "airlight_fill.frag", scene, framebuffer.samples())),
      add_program_("whole_picture.vert", "airlight_add.frag", demo_shaders()) {
  const auto attach = [](const gl::FramebufferName& target, const gl::TextureName& texture, glm::ivec2 size) {
    bind_texture(texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size.x, size.y, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, target.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  };
  const bool grid_is_whole = attach(grid_, grid_texture_, grid_size_);
  glBindRenderbuffer(GL_RENDERBUFFER, sum_stencil_.id());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, picture_size_.x, picture_size_.y);
  glBindFramebuffer(GL_FRAMEBUFFER, sum_.id());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, sum_stencil_.id());
  if (!attach(sum_, sum_texture_, picture_size_) || !grid_is_whole || glGetError() != GL_NO_ERROR) {
    throw gl::Unsupported("this driver cannot draw into textures of floats");
  }
}

void AirlightPainter::draw(const Framebuffer& framebuffer, const View& view, unsigned lights, unsigned carried) {
  glBindVertexArray(vertex_array_.id());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  const auto draw_lights = [&](const gl::Program& program) {
    use(program, framebuffer, view, carried);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(lights));
  };

  glBindFramebuffer(GL_FRAMEBUFFER, grid_.id());
  glViewport(0, 0, grid_size_.x, grid_size_.y);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  light_program_.use();
  glUniform1i(light_program_.uniform("pixel_step"), kGridStep);
  // Texel i's middle is that of pixel i * kGridStep.
  const glm::vec2 scale = glm::vec2(picture_size_) / glm::vec2(kGridStep * grid_size_);
  const glm::vec2 offset = scale - 1.0f + (1.0f - 1.0f / kGridStep) / glm::vec2(grid_size_);
  set_uniform(light_program_, "target_from_picture", glm::vec4(scale, offset));
  draw_lights(light_program_);

  glBindFramebuffer(GL_FRAMEBUFFER, sum_.id());
  glViewport(0, 0, picture_size_.x, picture_size_.y);
  glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, kCore, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  core_program_.use();
  set_uniform(core_program_, "target_from_picture", glm::vec4(1, 1, 0, 0));
  set_uniform(core_program_, "is_core", 1u);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_lights(core_program_);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

  glStencilFunc(GL_EQUAL, 0, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);  // to kFilled
  use(fill_program_, framebuffer, view, carried);
  bind_texture(grid_texture_);
  set_uniform(fill_program_, "grid", kGridUnit);
  glUniform1i(fill_program_.uniform("pixel_step"), kGridStep);
  glDrawArrays(GL_TRIANGLES, 0, 3);

  glStencilFunc(GL_NOTEQUAL, kFilled, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  light_program_.use();
  glUniform1i(light_program_.uniform("pixel_step"), 1);
  set_uniform(light_program_, "target_from_picture", glm::vec4(1, 1, 0, 0));
  draw_lights(light_program_);
  glDisable(GL_STENCIL_TEST);
  if (!scene_.cookies.empty()) {
    set_uniform(light_program_, "takes_cookies", 1u);
    draw_lights(light_program_);
    set_uniform(light_program_, "takes_cookies", 0u);
  }

  framebuffer.bind_resolved();
  add_program_.use();
  bind_texture(sum_texture_);
  set_uniform(add_program_, "airlight", kGridUnit);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
}

void AirlightPainter::use(const gl::Program& program, const Framebuffer& framebuffer, const View& view,
                          unsigned carried) {
  program.use();
  fog_lights_.bind(program, kFogLightBinding);
  framebuffer.bind_depth(kDepthUnit);
  set_uniform(program, "depths", kDepthUnit);
  set_uniform(program, "cookies", kCookieUnit);
  set_uniform(program, "cookie_cones", kCookieConeUnit);
  set_uniform(program, "litfog_kind_buffer", kKindBufferUnit);
  set_uniform(program, "litfog_instance_buffer", kInstanceBufferUnit);
  set_uniform(program, "light_list", kLightListUnit);
  set_uniform(program, "carried_count", carried);
  set_uniform(program, "clip_from_world", view.clip_from_world);
  set_uniform(program, "direction_from_clip", view.direction_from_clip);
  set_uniform(program, "pixel_size", 2.0f / glm::vec2(picture_size_));
  set_uniform(program, "pixels_per_radian",
              float(picture_size_.y) / (2 * std::tan(scene_.camera.field_of_view / 2)));
  set_uniform(program, "eye", scene_.camera.position);
  set_uniform(program, "forward", glm::normalize(scene_.camera.target - scene_.camera.position));
  set_uniform(program, "near_plane", view.near_plane);
  set_uniform(program, "sky_distance", kSkyDistance);
  set_uniform(program, "fog_above_eye", view.fog_above_eye);
  set_uniform(program, "budget", kBudget);
  set_uniform(program, "largest_phase", float(largest_phase({.asymmetry = scene_.phase_g})));
  set_uniform(program, "asymmetry", float(scene_.phase_g));
}

}  // namespace litfog::render
