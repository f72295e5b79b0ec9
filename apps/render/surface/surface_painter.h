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

/// A frame's shadows, and its scattered light on surfaces.
struct FrameLight {
  const ShadowMaps* shadows = nullptr;        ///< bound; null: none
  const ScatteredLight* scattered = nullptr;  ///< null: none
};

/// Draws a scene's surfaces by a lighting path. Needs a current GL context.
class SurfacePainter {
 public:
  /// scene, lights, fog_lights  must outlive this object
  /// throws  gl::Unsupported where this OpenGL cannot hold the scene's light lists or the path's light maps
  SurfacePainter(const scene::Scene& scene, const SceneLights& lights, const gl::FogLightBuffer& fog_lights,
                 const RenderSettings& settings);

  /// Applies a change of the scene's objects; set_lights() must follow.
  ///
  /// throws  like the constructor
  void set_objects() { surfaces_.set_objects(scene_); }
  /// Applies a change of the lights; set_fog() must follow.
  ///
  /// throws  gl::Unsupported like the constructor
  void set_lights();
  /// Applies a change of the fog, after the lights. knots: number in its density profile.
  void set_fog(std::size_t knots);
  /// Draws the surfaces of a plan without its panes. The plan's light list must be bound to its unit.
  ///
  /// interruption  stops drawing
  /// returns       bytes uploaded
  std::size_t draw(const LightingPath& path, const FramePlan& plan, const View& view, const FrameLight& light,
                   Interruption& interruption);
  /// Whether there are panes that draw() leaves out.
  bool has_panes() const { return settings_.path->draws_panes() && surfaces_.has_panes(); }
  /// Draws a plan's panes, triangle by triangle from the farthest to the nearest. Colours are premultiplied by alpha,
  /// the panes' opacity; the caller sets the blending.
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
  bool has_maps() const { return !maps_.kinds().empty(); }
  /// Draws all passes of surfaces that differ only in their transforms. With several passes there must be one surface.
  void draw_surfaces(Frame& frame, std::span<const PlannedSurface> alike, std::span<const std::int32_t> lights);
  /// Draws a pass with the fog's lights and a batch of the surfaces' lights. Completes the variant.
  void draw_pass(Frame& frame, std::span<const PlannedSurface> alike, ShaderVariant variant,
                 std::span<const std::int32_t> fog_lights, std::span<const std::int32_t> batch);
  /// Draws a pass with a complete variant and its uniforms, which hold the batch's lights.
  void draw_variant(Frame& frame, std::span<const PlannedSurface> alike, const ShaderVariant& variant,
                    const LightUniforms& uniforms, std::span<const std::int32_t> batch);
  void draw_triangles(Frame& frame, std::span<const PlannedSurface> alike, const SurfaceProgram& program,
                      TriangleOrder order);
  SurfaceProgram& use(Frame& frame, const ShaderVariant& variant, const SurfaceMaterial& material);
  /// Sets the uniforms of the program in use that stay the same within a frame.
  void set_frame_uniforms(const Frame& frame, const ShaderVariant& variant, const gl::Program& program) const;

  const scene::Scene& scene_;
  const SceneLights& lights_;
  const gl::FogLightBuffer& fog_light_buffer_;
  RenderSettings settings_;
  SurfaceList surfaces_;
  LightMapStore maps_;
  SurfacePrograms programs_;
  std::vector<std::int32_t> fog_lights_;
  std::size_t knots_ = 0;  // the density profile's
  std::size_t frames_ = 0;
};

}  // namespace litfog::render
