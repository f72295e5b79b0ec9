// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "litfog/gl/fog_light_buffer.h"
#include "render/light_map_store.h"
#include "render/light_selection.h"
#include "render/render_settings.h"
#include "render/scene_lights.h"
#include "render/shadow_maps.h"
#include "render/surface_list.h"
#include "render/surface_programs.h"

namespace litfog::render {

/// What a frame drew, and what it could leave out.
struct FrameCounts {
  std::size_t chunks_drawn = 0;
  std::size_t chunks_skipped = 0;  ///< out of view
  std::size_t lights_listed = 0;   ///< in the light lists of all drawn chunks together
  std::size_t lights_skipped = 0;  ///< not in them
  std::size_t shadow_maps_drawn = 0;  ///< all in the first frame, none later
};

/// Draws a scene's surfaces by a lighting path. Needs a current GL context.
class SurfacePainter {
 public:
  /// scene, lights, fog_lights  have to outlive this
  /// throws  gl::Unsupported where this OpenGL cannot hold the scene's light lists or the path's light maps
  SurfacePainter(const scene::Scene& scene, const SceneLights& lights, const gl::FogLightBuffer& fog_lights,
                 const RenderSettings& settings);

  /// shadows  of the lamps; drawn and bound. Null: none
  FrameCounts draw(const LightingPath& path, const glm::mat4& clip_from_world, const ShadowMaps* shadows);
  const SurfaceList& surfaces() const { return surfaces_; }

 private:
  struct Frame;

  void draw_surface(Frame& frame, const Surface& surface);
  /// Draws a surface by the lights of its fog and a batch of its own. Fills in the variant's uniform lights.
  void draw_pass(Frame& frame, const Surface& surface, ShaderVariant variant, std::span<const std::int32_t> fog_lights,
                 std::span<const std::int32_t> batch);
  SurfaceProgram& use(Frame& frame, const ShaderVariant& variant, const SurfaceMaterial& material);

  const scene::Scene& scene_;
  const SceneLights& lights_;
  const gl::FogLightBuffer& fog_light_buffer_;
  RenderSettings settings_;
  SurfaceList surfaces_;
  LightMapStore maps_;
  SurfacePrograms programs_;
  std::size_t frames_ = 0;
};

}  // namespace litfog::render
