// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/far_airlight.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "render/gpu/framebuffer.h"
#include "render/gpu/light_uniforms.h"
#include "render/gpu/render_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"

namespace litfog::render {
namespace {

constexpr double kApart = 0.04;  // radians between texels
constexpr double kApartInLayers = 0.03;
constexpr int kMaxRows = 120;    // and one more row, so that kSlabs + 1 pictures fit into 4096
constexpr int kSlabs = 32;       // far_slabs and, below, slabs_at_once of far_airlight.glsl
constexpr int kFarLightsAtOnce = 1024;  // 33 turns of loops each, of llvmpipe's 65535 (airlight_pyramid.cpp)
constexpr int kSlabsAtOnce = kSlabs / FarAirlightList::kSections;

}  // namespace

void FarAirlight::set_size(glm::ivec2 size) {
  if (size == size_) return;
  size_ = size;
  bind_texture(kUploadUnit, slabs_, GL_TEXTURE_2D_ARRAY);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA32F, size.x, size.y * FarAirlightList::kSections, kSlabsAtOnce, 0,
               GL_RGBA, GL_FLOAT, nullptr);
  set_filter(GL_TEXTURE_2D_ARRAY, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, slabs_framebuffer_.id());
  GLenum targets[kSlabsAtOnce];
  for (int i = 0; i < kSlabsAtOnce; ++i) {
    targets[i] = GLenum(GL_COLOR_ATTACHMENT0 + i);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, targets[i], slabs_.id(), 0, i);
  }
  glDrawBuffers(kSlabsAtOnce, targets);
  check_float_framebuffer();
  bind_texture(kUploadUnit, sums_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size.x, size.y * (kSlabs + 1), 0, GL_RGBA, GL_FLOAT, nullptr);
  interpolate_within_edges(GL_TEXTURE_2D);
  glBindFramebuffer(GL_FRAMEBUFFER, sums_framebuffer_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, sums_.id(), 0);
  check_float_framebuffer();
}

void FarAirlight::set_list(const FarAirlightList& list, const HigherOrderTextures& higher_orders) {
  higher_orders_ = &higher_orders;
  depth_ = list.depth;
  visible_step_ = float(list.visible_step);
  light_count_ = int(list.lights.size());
  ranges_ = list.ranges;
  if (is_empty()) return;
  listed_.emplace(list.lights.data(), list.lights.size() * sizeof(list.lights[0]), BufferTexture::Texel::int1);
}

int FarAirlight::bind_list(PassTextures& textures) const {
  listed_->bind(textures.unit("far_lights"));
  return light_count_;
}

void FarAirlight::draw(glm::ivec2 picture_size, const View& view, const Atmosphere& atmosphere) {
  if (is_empty()) return;
  const double apart = atmosphere.profile.count > 0 ? kApartInLayers : kApart;
  step_ = std::max({1, int(apart * view.pixels_per_radian), (picture_size.y + kMaxRows - 1) / kMaxRows});
  set_size((picture_size + (step_ - 1)) / step_ + 1);
  pass_.begin();

  glBindFramebuffer(GL_FRAMEBUFFER, slabs_framebuffer_.id());
  glViewport(0, 0, size_.x, size_.y * FarAirlightList::kSections);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  for (const FarAirlightList::Range& range : ranges_) {
    const gl::Program& program = light_programs_.program(
        atmosphere, {.has_higher_orders = !higher_orders_->is_empty(), .profile = range.profile});
    program.use();
    bind_lights(program, fog_lights_);
    PassTextures textures(program);
    bind_list(textures);
    higher_orders_->bind(textures);
    set_uniform(program, "direction_from_clip", view.direction_from_clip);
    set_uniform(program, "pixel_size", 2.0f / glm::vec2(picture_size));
    set_uniform(program, "eye", view.eye);
    set_uniform(program, "far_depth", float(depth_));
    set_uniform(program, "far_step", step_);
    set_uniform(program, "visible_step", visible_step_);
    set_uniform(program, "row_count", size_.y);
    glEnable(GL_SCISSOR_TEST);
    for (int section = 0; section < FarAirlightList::kSections; ++section) {
      const int count = range.counts[std::size_t(section)];
      glScissor(0, section * size_.y, size_.x, size_.y);
      for (int first = 0; first < count; first += kFarLightsAtOnce) {
        set_uniform(program, "first_light", range.first + first);
        set_uniform(program, "light_count", std::min(count - first, kFarLightsAtOnce));
        glDrawArrays(GL_TRIANGLES, 0, 3);
      }
    }
    glDisable(GL_SCISSOR_TEST);
  }
  glDisable(GL_BLEND);

  glBindFramebuffer(GL_FRAMEBUFFER, sums_framebuffer_.id());
  glViewport(0, 0, size_.x, size_.y * (kSlabs + 1));
  if (!sum_program_) sum_program_.emplace("whole_picture.vert", "airlight/far_airlight_sum.frag", render_shaders());
  sum_program_->use();
  PassTextures(*sum_program_).bind("far_slab_sums", slabs_, GL_TEXTURE_2D_ARRAY);
  set_uniform(*sum_program_, "row_count", size_.y);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void FarAirlight::bind(const gl::Program& program, PassTextures& textures) const {
  bind_lights(program, fog_lights_);
  textures.bind("far_airlight", sums_, GL_TEXTURE_2D);
  set_uniform(program, "far_depth", float(depth_));
  set_uniform(program, "far_step", step_);
}

}  // namespace litfog::render
