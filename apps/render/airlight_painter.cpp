// SPDX-License-Identifier: Apache-2.0
#include "render/airlight_painter.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "litfog/gl/unsupported.h"
#include "render/demo_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"
#include "render/renderer.h"

namespace litfog::render {
namespace {

/// What a light may leave out of a pixel: an eighth of a step of the display where it is darkest and sRGB has this slope.
constexpr double kDarkestSlope = 12.92;
constexpr double kBudget = 1 / (8 * 255 * kDarkestSlope);
constexpr int kGridSteps[] = {8, 4, 2, 1};  // pixels
constexpr GLint kFilled = 1;                // of the stencil, which is 0 elsewhere

void bind_texture(TextureUnit unit, const gl::TextureName& texture) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture.id());
}

/// Makes a texture of floats the bound framebuffer's.
void attach(GLenum attachment, const gl::TextureName& texture, glm::ivec2 size) {
  bind_texture(kAirlightUnit, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size.x, size.y, 0, GL_RGBA, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.id(), 0);
}

void check_framebuffer() {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE || glGetError() != GL_NO_ERROR) {
    throw gl::Unsupported("this driver cannot draw into textures of floats");
  }
}

constexpr int kCookieProfile = 3;  // of a light as shaders know it

/// The text of airlight_constants.glsl.
std::string light_constants(const scene::Scene& scene, FogMode fog_mode, int profile) {
  const bool has_knee = std::ranges::any_of(
      scene.lights, [](const PlacedLight& light) { return light.light.attenuation.constant < 1; });
  return fmt::format(
      "#define LITFOG_FOG_MODE {}.0\n"
      "{}"
      "const float profile = {}.0;  // of the lights to draw\n"
      "{}",
      int(fog_mode), has_knee ? "" : "#define LITFOG_NO_KNEE\n", profile,
      scene.phase_g == 0 ? "const float asymmetry = 0.0;\n" : "uniform float asymmetry;\n");
}

/// Reads that many depths a pixel.
gl::Program make_seen_program(int samples) {
  const std::string count = fmt::format("#define SAMPLE_COUNT {}\n", samples);
  std::vector<gl::ShaderSource> files(demo_shaders().begin(), demo_shaders().end());
  files.push_back({"sample_count.glsl", count});
  return gl::Program("whole_picture.vert", "airlight_seen.frag", files);
}

}  // namespace

AirlightPainter::AirlightPainter(const scene::Scene& scene, const SceneLights& lights,
                                 const gl::FogLightBuffer& fog_lights, const Framebuffer& framebuffer)
    : scene_(scene),
      fog_lights_(fog_lights),
      lights_(lights),
      picture_size_(framebuffer.width(), framebuffer.height()),
      seen_program_(make_seen_program(framebuffer.samples())),
      fill_program_("whole_picture.vert", "airlight_fill.frag", demo_shaders()),
      add_program_("whole_picture.vert", "airlight_add.frag", demo_shaders()) {
  glBindFramebuffer(GL_FRAMEBUFFER, seen_.id());
  attach(GL_COLOR_ATTACHMENT0, seen_texture_, picture_size_);
  check_framebuffer();
  for (const int step : kGridSteps) {
    Grid& grid = grids_.emplace_back();
    grid.step = step;
    grid.size = (picture_size_ + (step - 1)) / step + (step > 1 ? 1 : 0);
    glBindFramebuffer(GL_FRAMEBUFFER, grid.framebuffer.id());
    attach(GL_COLOR_ATTACHMENT0, grid.airlight, grid.size);
    if (step > 1) attach(GL_COLOR_ATTACHMENT1, grid.gain, grid.size);
    const GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(step > 1 ? 2 : 1, targets);
    glBindRenderbuffer(GL_RENDERBUFFER, grid.stencil.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, grid.size.x, grid.size.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, grid.stencil.id());
    check_framebuffer();
  }
}

AirlightList AirlightPainter::draw(const Framebuffer& framebuffer, const View& view, const Fog& fog) {
  AirlightList list =
      list_airlight(lights_, fog, {.asymmetry = scene_.phase_g}, scene_.camera.position, pixels_per_radian(), kBudget);
  if (list.entries.empty()) return list;
  entries_.emplace(list.entries.data(), list.entries.size() * sizeof(AirlightEntry), BufferTexture::Texel::float4);
  entries_->bind(kEntryUnit);
  const Frame frame{framebuffer, view, fog.mode, list.ranges};
  glBindVertexArray(vertex_array_.id());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glClearColor(0, 0, 0, 0);
  framebuffer.bind_depth(kDepthUnit);
  bind_texture(kSeenUnit, seen_texture_);

  glBindFramebuffer(GL_FRAMEBUFFER, seen_.id());
  use(seen_program_, frame, grids_.back());
  glDrawArrays(GL_TRIANGLES, 0, 3);

  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  for (std::size_t i = 0; i < grids_.size(); ++i) {
    const Grid& grid = grids_[i];
    glBindFramebuffer(GL_FRAMEBUFFER, grid.framebuffer.id());
    glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    if (i > 0) {
      glEnable(GL_STENCIL_TEST);
      fill(frame, grid, grids_[i - 1]);
      draw_lights(frame, grid, true);
    }
    draw_lights(frame, grid, false);
    glDisable(GL_STENCIL_TEST);
  }

  framebuffer.bind_resolved();
  add_program_.use();
  bind_texture(kAirlightUnit, grids_.back().airlight);
  set_uniform(add_program_, "airlight", kAirlightUnit);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
  return list;
}

/// Fills the texels for which the coarser grid is good enough, and marks them.
void AirlightPainter::fill(const Frame& frame, const Grid& grid, const Grid& coarse) {
  glStencilFunc(GL_ALWAYS, kFilled, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  use(fill_program_, frame, grid);
  bind_texture(kAirlightUnit, coarse.airlight);
  bind_texture(kGainUnit, coarse.gain);
  set_uniform(fill_program_, "grid", kAirlightUnit);
  set_uniform(fill_program_, "grid_gain", kGainUnit);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

/// Draws lights where the texels are filled, or where they are not.
void AirlightPainter::draw_lights(const Frame& frame, const Grid& grid, bool is_filled) {
  glStencilFunc(is_filled ? GL_EQUAL : GL_NOTEQUAL, kFilled, 0xff);
  for (const AirlightList::Range& range : frame.lights) {
    const bool is_cookie = range.profile == kCookieProfile;  // which may be finer than a grid: all at the end
    if (is_cookie && (grid.step > 1 || is_filled)) continue;
    if (is_cookie) glDisable(GL_STENCIL_TEST);
    const gl::Program& program = light_program(frame.fog_mode, range.profile);
    use(program, frame, grid);
    glUniform1i(program.uniform("first_entry"), GLint(range.first));
    set_uniform(program, "is_filled", unsigned{is_filled});
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(range.count));
  }
}

double AirlightPainter::pixels_per_radian() const {
  return picture_size_.y / (2 * std::tan(double(scene_.camera.field_of_view) / 2));
}

const gl::Program& AirlightPainter::light_program(FogMode fog_mode, int profile) {
  const std::pair key(fog_mode, profile);
  const auto found = light_programs_.find(key);
  if (found != light_programs_.end()) return found->second;
  const std::string constants = light_constants(scene_, fog_mode, profile);
  std::vector<gl::ShaderSource> files = scene_shaders(profile == kCookieProfile);
  files.push_back({"airlight_constants.glsl", constants});
  return light_programs_.emplace(key, gl::Program("airlight.vert", "airlight.frag", files)).first->second;
}

void AirlightPainter::use(const gl::Program& program, const Frame& frame, const Grid& grid) {
  glViewport(0, 0, grid.size.x, grid.size.y);
  program.use();
  fog_lights_.bind(program, kFogLightBinding);
  set_uniform(program, "depths", kDepthUnit);
  set_uniform(program, "seen_ranges", kSeenUnit);
  set_uniform(program, "cookies", kCookieUnit);
  set_uniform(program, "cookie_cones", kCookieConeUnit);
  set_uniform(program, "litfog_kind_buffer", kKindBufferUnit);
  set_uniform(program, "litfog_instance_buffer", kInstanceBufferUnit);
  set_uniform(program, "airlight_entries", kEntryUnit);
  set_uniform(program, "clip_from_world", frame.view.clip_from_world);
  set_uniform(program, "direction_from_clip", frame.view.direction_from_clip);
  set_uniform(program, "pixel_size", 2.0f / glm::vec2(picture_size_));
  set_uniform(program, "eye", scene_.camera.position);
  set_uniform(program, "forward", glm::normalize(scene_.camera.target - scene_.camera.position));
  set_uniform(program, "near_plane", frame.view.near_plane);
  set_uniform(program, "sky_distance", kSkyDistance);
  set_uniform(program, "fog_above_eye", frame.view.fog_above_eye);
  set_uniform(program, "asymmetry", float(scene_.phase_g));
  glUniform1i(program.uniform("pixel_step"), grid.step);
  // Texel i's middle is that of pixel i * step.
  const glm::vec2 scale = glm::vec2(picture_size_) / glm::vec2(grid.step * grid.size);
  const glm::vec2 offset = scale - 1.0f + (1.0f - 1.0f / float(grid.step)) / glm::vec2(grid.size);
  set_uniform(program, "target_from_picture", glm::vec4(scale, offset));
}

}  // namespace litfog::render
