// SPDX-License-Identifier: Apache-2.0
#include "render/shadow/shadow_maps.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "litfog/gl/unsupported.h"
#include "render/gpu/depth.h"
#include "render/gpu/render_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"

namespace litfog::render {
namespace {

/// A caster for shadow_caster.glsl.
struct PackedCaster {
  glm::vec4 position_layer;
  glm::vec4 axis_half_size;  // 0: a cube
  glm::vec4 up_reach;
};

/// caster  a ShadowCaster or MoonMap whose maps begin at a layer
template <typename Caster>
PackedCaster pack(const Caster& caster, double half_size, int layer) {
  const glm::dmat3 world_from_frame = glm::transpose(caster.frame_from_world);
  return {.position_layer = glm::vec4(caster.position, layer),
          .axis_half_size = glm::vec4(-world_from_frame[2], half_size),
          .up_reach = glm::vec4(world_from_frame[1], caster.reach)};
}

scene::Bounds bounds_of_all(const std::vector<Surface>& surfaces) {
  if (surfaces.empty()) return {glm::vec3(0), glm::vec3(0)};
  scene::Bounds whole = surfaces.front().bounds;
  for (const Surface& surface : surfaces) whole = united(whole, surface.bounds);
  return whole;
}

/// whose  "3 lamps"
void expect_room(const std::string& whose, std::size_t layers, int size) {
  const std::size_t bytes = layers * std::size_t(size) * std::size_t(size) * sizeof(float);
  if (bytes > ShadowMaps::kMaxBytes) {
    throw gl::Unsupported(
        fmt::format("the shadows of {} need {} maps of {} texels a side, {:.1f} GiB; at most 1 GiB is taken for "
                    "them, so fewer lamps have to cast shadows, or by smaller maps",
                    whose, layers, size, double(bytes) / double(ShadowMaps::kMaxBytes)));
  }
  GLint most = 0;
  GLint largest = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (layers > std::size_t(most) || size > largest) {
    throw gl::Unsupported(
        fmt::format("the shadows of {} need {} maps of {} texels a side; this OpenGL has at "
                    "most {} of {}",
                    whose, layers, size, most, largest));
  }
}

/// Leaves the program in use. The caster is a ShadowCaster or MoonMap.
template <typename Caster>
void set_frame(const gl::Program& program, const Caster& caster, int map) {
  program.use();
  set_uniform(program, "frame_from_world", glm::mat4(glm::dmat4(caster.frame_from_world)));
  set_uniform(program, "lamp_position", glm::vec3(caster.position));
  set_uniform(program, "map", map);
  set_uniform(program, "half_size", float(caster.half_size));
  set_uniform(program, "reach", float(caster.reach));
}

void set_map(const gl::Program& program, const ShadowCaster& caster, int map) {
  // The corner of a map is where the lamp's sphere is nearest to the lamp's plane.
  const double near_plane = kLampRadius / std::sqrt(1 + 2 * caster.half_size * caster.half_size);
  set_frame(program, caster, map);
  set_uniform(program, "near_plane", float(near_plane));
  set_uniform(program, "lamp_radius", float(kLampRadius));
  set_uniform(program, "is_parallel", false);
}

void set_map(const gl::Program& program, const MoonMap& map) {
  set_frame(program, map, 0);
  set_uniform(program, "lamp_radius", 0.0f);
  set_uniform(program, "is_parallel", true);
}

}  // namespace

ShadowMaps::ShadowMaps(const scene::Scene& scene, const SceneLights& lights, const SurfaceList& surfaces, double aspect,
                       const RenderSettings& settings)
    : scene_(scene),
      origin_(lights.origin()),
      surfaces_(surfaces),
      bounds_(bounds_of_all(surfaces.surfaces())),
      casters_(choose_shadow_casters(lights, bounds_, scene.camera.position - origin_,
                                     std::size_t(settings.shadow_lamps), settings.shadow_map_size)),
      caster_of_(lights.size(), kNoCaster),
      size_(settings.shadow_map_size),
      program_("shadow/shadow_caster.vert", "shadow/shadow_caster.frag", render_shaders()),
      mask_program_("shadow/shadow_caster.vert", "shadow/shadow_caster_mask.frag", render_shaders()) {
  moon_maps_ = fitted_moon_maps(aspect);
  const std::size_t layers = map_count();
  expect_room(fmt::format("{} lamps{}", casters_.size(), moon_maps_.empty() ? "" : " and the moon"), layers, size_);
  for (std::size_t i = 0; i < casters_.size(); ++i) caster_of_[std::size_t(casters_[i].light)] = std::int32_t(i);
  upload_casters();
  caster_of_texture_.emplace(caster_of_.data(), caster_of_.size() * sizeof(std::int32_t), BufferTexture::Texel::int1);
  bind_texture(kShadowMapUnit, maps_, GL_TEXTURE_2D_ARRAY);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, size_, size_, std::max(GLsizei(layers), 1), 0,
               GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  interpolate_within_edges(GL_TEXTURE_2D_ARRAY);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps_.id(), 0, 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE || glGetError() != GL_NO_ERROR) {
    throw gl::Unsupported(fmt::format("this driver gives no {} shadow maps of {} texels a side", layers, size_));
  }
}

std::size_t ShadowMaps::map_count() const {
  std::size_t count = moon_maps_.size();
  for (const ShadowCaster& caster : casters_) count += std::size_t(caster.map_count);
  return count;
}

std::vector<MoonMap> ShadowMaps::fitted_moon_maps(double aspect) const {
  return fit_moon_maps(scene_.environment, relative_to(origin_, scene_.camera), bounds_, aspect, size_);
}

void ShadowMaps::upload_casters() {
  std::vector<PackedCaster> packed;
  int layer = 0;
  for (const ShadowCaster& caster : casters_) {
    packed.push_back(pack(caster, caster.is_cube ? 0 : caster.half_size, layer));
    layer += caster.map_count;
  }
  for (const MoonMap& map : moon_maps_) packed.push_back(pack(map, map.half_size, layer++));
  caster_texture_.emplace(packed.data(), packed.size() * sizeof(PackedCaster), BufferTexture::Texel::float4);
}

std::size_t ShadowMaps::draw(double aspect) {
  std::vector<MoonMap> moon_maps = fitted_moon_maps(aspect);
  const bool draws_lamps = !is_drawn_;
  const bool draws_moon = !is_drawn_ || moon_maps != moon_maps_;
  if (!draws_lamps && !draws_moon) return 0;
  if (moon_maps != moon_maps_) {
    moon_maps_ = std::move(moon_maps);
    upload_casters();
  }
  is_drawn_ = true;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glViewport(0, 0, size_, size_);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE);  // ground and leaves have no thickness
  surfaces_.meshes().bind();
  std::size_t layer = 0;
  if (draws_lamps) {
    for (const ShadowCaster& caster : casters_) {
      for (int map = 0; map < caster.map_count; ++map) {
        begin_map(layer++);
        draw_map(caster, map);
      }
    }
  }
  layer = map_count() - moon_maps_.size();
  for (const MoonMap& map : moon_maps_) {
    begin_map(layer++);
    draw_map(map);
  }
  end_depths();
  return draws_lamps ? map_count() : moon_maps_.size();
}

void ShadowMaps::begin_map(std::size_t layer) {
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps_.id(), 0, GLint(layer));
  glClear(GL_DEPTH_BUFFER_BIT);
}

void ShadowMaps::draw_map(const ShadowCaster& caster, int map) {
  set_map(program_, caster, map);
  set_map(mask_program_, caster, map);
  const LightBounds seen = bounds_of_map(caster, map);
  for (const Surface& surface : surfaces_.surfaces()) {
    if (can_light(seen, surface.bounds.low, surface.bounds.high)) draw_surface(surface);
  }
}

void ShadowMaps::draw_map(const MoonMap& map) {
  set_map(program_, map);
  set_map(mask_program_, map);
  for (const Surface& surface : surfaces_.surfaces()) {
    if (can_cast(surface.bounds, map)) draw_surface(surface);
  }
}

void ShadowMaps::draw_surface(const Surface& surface) {
  const scene::Material& material = surface.material->material;
  const gl::Program& program = material.least_coverage ? mask_program_ : program_;
  program.use();
  set_uniform(program, "world_from_model", surface.world_from_model);
  if (material.least_coverage) {
    set_uniform(program, "albedo_map", kAlbedoUnit);
    set_uniform(program, "tile_size", material.size_m);
    set_uniform(program, "least_coverage", *material.least_coverage);
    surface.material->albedo->bind(kAlbedoUnit);
  }
  surfaces_.meshes().draw(surface.chunk->first_index, std::size_t(surface.chunk->index_count), TriangleOrder::stored);
}

void ShadowMaps::bind() const {
  bind_texture(kShadowMapUnit, maps_, GL_TEXTURE_2D_ARRAY);
  caster_texture_->bind(kShadowCasterUnit);
  caster_of_texture_->bind(kCasterOfLightUnit);
}

void ShadowMaps::set_moon_maps(const gl::Program& program) const {
  set_uniform(program, "first_moon_map", int(casters_.size()));
  set_uniform(program, "end_of_moon_maps", int(casters_.size() + moon_maps_.size()));
}

}  // namespace litfog::render
