// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/scattered_light.h"

#include <epoxy/gl.h>

#include "render/gpu/framebuffer.h"
#include "render/gpu/light_uniforms.h"
#include "render/gpu/render_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"

namespace litfog::render {
namespace {

// Texels for few lamps and for many, which vary less from texel to texel, as most of them are far away.
constexpr glm::ivec3 kFine{48, 32, 48}, kCoarse{28, 18, 36};
constexpr int kFewLamps = 8;

void make_grid(const gl::TextureName& texture, glm::ivec3 size) {
  bind_texture(kUploadUnit, texture, GL_TEXTURE_3D);
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA32F, size.x, size.y, size.z, 0, GL_RGBA, GL_FLOAT, nullptr);
  interpolate_within_edges(GL_TEXTURE_3D);
}

}  // namespace

void ScatteredLight::set_size(glm::ivec3 size) {
  if (size == size_) return;
  size_ = size;
  make_grid(all_, size);
  make_grid(flow_, size);
}

void ScatteredLight::draw(glm::ivec2 picture_size, const View& view, const Atmosphere& atmosphere,
                          const FarAirlight& far, const HigherOrderTextures& higher_orders) {
  depth_ = higher_orders.is_empty() ? 0 : float(far.depth());
  picture_size_ = picture_size;
  if (depth_ == 0) return;
  const gl::Program& program = programs_.program(atmosphere, {.profile = int(LITFOG_PROFILE_NONE)});
  pass_.begin();
  program.use();
  bind_lights(program, fog_lights_);
  PassTextures textures(program);
  const int lamps = far.bind_list(textures);
  set_size(lamps <= kFewLamps ? kFine : kCoarse);
  set_uniform(program, "light_count", lamps);
  higher_orders.bind(textures);
  set_uniform(program, "direction_from_clip", view.direction_from_clip);
  set_uniform(program, "pixel_size", 2.0f / glm::vec2(size_));
  set_uniform(program, "eye", view.eye);
  set_uniform(program, "grid_depth", depth_);
  set_uniform(program, "slice_count", size_.z);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glViewport(0, 0, size_.x, size_.y);
  constexpr GLenum kTargets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glDrawBuffers(2, kTargets);
  for (int slice = 0; slice < size_.z; ++slice) {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, kTargets[0], all_.id(), 0, slice);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, kTargets[1], flow_.id(), 0, slice);
    if (slice == 0) check_float_framebuffer();
    set_uniform(program, "slice", slice);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
}

void ScatteredLight::bind(const gl::Program& program) const {
  set_uniform(program, "scattered_all", kScatteredAllUnit);
  set_uniform(program, "scattered_flow", kScatteredFlowUnit);
  set_uniform(program, "scattered_depth", depth_);
  set_uniform(program, "picture_size", picture_size_);
  bind_texture(kScatteredAllUnit, all_, GL_TEXTURE_3D);
  bind_texture(kScatteredFlowUnit, flow_, GL_TEXTURE_3D);
}

}  // namespace litfog::render
