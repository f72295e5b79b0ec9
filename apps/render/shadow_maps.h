// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/gpu/texture.h"
#include "render/render_settings.h"
#include "render/scene_lights.h"
#include "render/shadow_caster.h"
#include "render/surface_list.h"

namespace litfog::render {

/// The shadow maps of a scene's lamps in one array of depth textures. Needs a current GL context.
class ShadowMaps {
 public:
  static constexpr int kNoCaster = -1;
  static constexpr std::size_t kMostBytes = std::size_t{1} << 30;

  /// surfaces  that cast shadows; have to outlive this
  /// settings  of which the shadows are not none
  /// throws    gl::Unsupported where the maps would take more than kMostBytes, or this OpenGL has no such textures
  ShadowMaps(const SceneLights& lights, const SurfaceList& surfaces, const glm::dvec3& eye,
             const RenderSettings& settings);

  const std::vector<ShadowCaster>& casters() const { return casters_; }
  std::size_t map_count() const;
  /// A light's caster as the shaders number them, or kNoCaster.
  std::int32_t caster_of(std::size_t light) const { return caster_of_[light]; }
  std::span<const std::int32_t> caster_of_lights() const { return caster_of_; }

  /// Draws the maps the first time that it is called. Lamps and surfaces stay as they are as long as this, so the maps
  /// do. Returns how many were drawn. Changes the bound framebuffer.
  std::size_t draw();
  /// Binds the maps and the casters to their units.
  void bind() const;

 private:
  void draw_map(const ShadowCaster& caster, int map);

  const SurfaceList& surfaces_;
  std::vector<ShadowCaster> casters_;
  std::vector<std::int32_t> caster_of_;  // of each light
  int size_;                             // texels a side
  bool is_drawn_ = false;
  gl::Program program_;
  gl::Program mask_program_;  // of materials with a mask
  gl::FramebufferName framebuffer_;
  gl::TextureName maps_;
  std::optional<BufferTexture> caster_texture_;
  std::optional<BufferTexture> caster_of_texture_;
};

}  // namespace litfog::render
