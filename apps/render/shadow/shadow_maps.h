// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/gpu/data_texture.h"
#include "render/light/scene_lights.h"
#include "render/render_settings.h"
#include "render/shadow/moon_map.h"
#include "render/shadow/shadow_caster.h"
#include "render/surface/surface_list.h"

namespace litfog::render {

/// The shadow maps of a scene's lamps and directional light in one depth texture array. Needs a current GL context.
class ShadowMaps {
 public:
  static constexpr int kNoCaster = -1;
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 30;

  /// scene     must outlive this object
  /// surfaces  cast the shadows; must outlive this object
  /// aspect    width over height of the pictures
  /// settings  shadows is not Shadows::none
  /// throws    gl::Unsupported where the maps would take more than kMaxBytes, or this OpenGL has no such textures
  ShadowMaps(const scene::Scene& scene, const SceneLights& lights, const SurfaceList& surfaces, double aspect,
             const RenderSettings& settings);

  const std::vector<ShadowCaster>& casters() const { return casters_; }
  const std::vector<MoonMap>& moon_maps() const { return moon_maps_; }
  /// Number of the lamps' and the moon's maps.
  std::size_t map_count() const;
  /// The index of a light's caster in shaders, or kNoCaster.
  std::int32_t caster_of(std::size_t light) const { return caster_of_[light]; }
  std::span<const std::int32_t> caster_of_lights() const { return caster_of_; }

  /// Draws the lamps' maps at the first call only, since lamps and surfaces do not change during this object's life.
  /// Draws the directional light's maps whenever the scene's camera has changed. Returns the number of maps drawn.
  /// Changes the bound framebuffer.
  std::size_t draw(double aspect);
  /// Binds the maps and the casters to their units.
  void bind() const;
  /// Sets uniforms of the program in use: which casters are the directional light's maps.
  void set_moon_maps(const gl::Program& program) const;

 private:
  std::vector<MoonMap> fitted_moon_maps(double aspect) const;
  void upload_casters();
  void begin_map(std::size_t layer);
  void draw_map(const ShadowCaster& caster, int map);
  void draw_map(const MoonMap& map);
  void draw_surface(const Surface& surface);

  const scene::Scene& scene_;
  glm::dvec3 origin_;
  const SurfaceList& surfaces_;
  scene::Bounds bounds_;  // around all surfaces
  std::vector<ShadowCaster> casters_;
  std::vector<MoonMap> moon_maps_;
  std::vector<std::int32_t> caster_of_;  // one per light
  int size_;                             // texels along a side
  bool is_drawn_ = false;
  gl::Program program_;
  gl::Program mask_program_;  // for materials with a mask
  gl::FramebufferName framebuffer_;
  gl::TextureName maps_;
  std::optional<BufferTexture> caster_texture_;
  std::optional<BufferTexture> caster_of_texture_;
};

}  // namespace litfog::render
