// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "litfog/gl/fog_light_buffer.h"
#include "render/airlight/scattered_light.h"
#include "render/compose/compositor.h"
#include "render/interruption.h"
#include "render/light/light_map_store.h"
#include "render/light/light_selection.h"
#include "render/light/scene_lights.h"
#include "render/plan/frame_plan.h"
#include "render/plan/view.h"
#include "render/render_settings.h"
#include "render/shadow/shadow_maps.h"
#include "render/surface/surface_list.h"
#include "render/surface/surface_programs.h"

namespace litfog::render {

/// What lights surfaces apart from lamps themselves, drawn for the frame.
struct FrameLight {
  const ShadowMaps* shadows = nullptr;        ///< of the lamps, bound; null: none
  const ScatteredLight* scattered = nullptr;  ///< null: none
};

/// Draws a scene's surfaces by a lighting path. Needs a current GL context.
class SurfacePainter {
 public:
  /// scene, lights, fog_lights  have to outlive this
  /// throws  gl::Unsupported where this OpenGL cannot hold the scene's light lists or the path's light maps
  SurfacePainter(const scene::Scene& scene, const SceneLights& lights, const gl::FogLightBuffer& fog_lights,
                 const RenderSettings& settings);

  /// Takes a change of the scene's objects; set_lights() has to follow.
  ///
  /// throws  as the constructor
  void set_objects() { surfaces_.set_objects(scene_); }
  /// Takes a change of the lights; one of the fog has to follow.
  ///
  /// throws  gl::Unsupported as the constructor
  void set_lights();
  /// Takes a change of the ambient light or the moon's. The first one compiles all programs anew, further ones none.
  void set_environment_light() { programs_.make_environment_light_uniform(); }
  /// Takes a change of the fog, which the lights have taken. knots: of its density profile.
  void set_fog(std::size_t knots);
  /// Draws the surfaces of a plan but for its panes. Its light list is bound to its unit.
  ///
  /// interruption  after which it draws no more
  /// returns       bytes that the draws were passed
  std::size_t draw(const LightingPath& path, const FramePlan& plan, const View& view, const FrameLight& light,
                   Interruption& interruption);
  /// Whether there are panes that draw() leaves out.
  bool has_panes() const { return settings_.path->draws_panes() && surfaces_.has_panes(); }
  /// Draws a plan's panes likewise, triangle by triangle from the farthest to the nearest. Premultiplied by their
  /// opacity, which is alpha; how they are blended is the caller's to set.
  ///
  /// airlight  before the panes; null: none
  std::size_t draw_panes(const LightingPath& path, const FramePlan& plan, const View& view, const FrameLight& light,
                         const PaneAirlight* airlight);
  const SurfaceList& surfaces() const { return surfaces_; }

 private:
  struct Frame;
  struct LightUniforms;

  /// Draws the depths of a plan's surfaces that have neither masks nor panes.
  void draw_depths(Frame& frame, const FramePlan& plan);
  bool has_maps() const { return !maps_.kinds().empty(); }  // which hold the cones
  /// Draws surfaces that differ in their places only; of several passes all, so that there may be but one surface.
  void draw_surfaces(Frame& frame, std::span<const PlannedSurface> alike, std::span<const std::int32_t> lights);
  /// Draws them by the lights of their fog and a batch of their own. Fills in what the variant is compiled for.
  void draw_pass(Frame& frame, std::span<const PlannedSurface> alike, ShaderVariant variant,
                 std::span<const std::int32_t> fog_lights, std::span<const std::int32_t> batch);
  /// Draws them by such a variant and its uniforms, which hold the batch's lights.
  void draw_variant(Frame& frame, std::span<const PlannedSurface> alike, const ShaderVariant& variant,
                    const LightUniforms& uniforms, std::span<const std::int32_t> batch);
  void draw_triangles(Frame& frame, std::span<const PlannedSurface> alike, const SurfaceProgram& program,
                      TriangleOrder order);
  SurfaceProgram& use(Frame& frame, const ShaderVariant& variant, const SurfaceMaterial& material);
  /// Sets what stays the same in a frame, for the program in use.
  void set_frame_uniforms(const Frame& frame, const ShaderVariant& variant, const gl::Program& program) const;

  const scene::Scene& scene_;
  const SceneLights& lights_;
  const gl::FogLightBuffer& fog_light_buffer_;
  RenderSettings settings_;
  SurfaceList surfaces_;
  LightMapStore maps_;
  SurfacePrograms programs_;
  std::vector<std::int32_t> fog_lights_;
  std::size_t knots_ = 0;  // of the density profile
  std::size_t frames_ = 0;
};

}  // namespace litfog::render
