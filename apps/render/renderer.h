// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/fog_light_tables.h"
#include "litfog/gl/program.h"
#include "render/airlight/airlight_lights.h"
#include "render/airlight/airlight_pyramid.h"
#include "render/airlight/far_airlight.h"
#include "render/airlight/scattered_light.h"
#include "render/airlight/seen_ranges.h"
#include "render/compose/compositor.h"
#include "render/display.h"
#include "render/gpu/data_texture.h"
#include "render/gpu/depth.h"
#include "render/gpu/framebuffer.h"
#include "render/gpu/geometry_buffer.h"
#include "render/gpu/sampler_states.h"
#include "render/light/scene_lights.h"
#include "render/plan/frame_plan.h"
#include "render/shadow/shadow_maps.h"
#include "render/surface/sky_painter.h"
#include "render/surface/surface_painter.h"
#include "scene/scene.h"

namespace litfog::render {

/// Whether lamps are drawn as points over the surfaces.
enum class LightPoints { on, off };

/// Whether a picture reaches the largest half float, at which the framebuffer of one pass clips it.
bool is_cut_off(const Picture& picture);

/// Draws a scene by a lighting path into a framebuffer. Needs a current GL 3.3 core context. The scene's camera, sky,
/// ambient light and moon may change from frame to frame; if the moon casts shadows, set_lights() must follow. The lamps
/// that cast shadows are chosen for the camera at set_lights().
///
/// Scenes are in doubles, shaders in floats. Shaders take positions relative to origin(), so that pictures 10,000 km
/// from the world's origin are as exact as at it. A camera that moves kilometres away causes a new set_lights().
class Renderer {
 public:
  /// scene   must outlive this object
  /// throws  gl::Unsupported where this OpenGL cannot hold the scene's light lists, or where the path's light maps or
  ///         the shadow maps would take more than 1 GiB; std::invalid_argument where the scene lacks a part's material
  Renderer(const scene::Scene& scene, int width, int height, const RenderSettings& settings);
  Renderer(const Renderer&) = delete;  // its members refer to each other
  Renderer& operator=(const Renderer&) = delete;

  /// Sets the size of the pictures.
  ///
  /// throws  gl::Unsupported where the driver has no framebuffer of that size
  void set_size(int width, int height);
  /// Applies a change of the scene's objects, models and materials, except that a material whose name has been used
  /// before stays as it was. Must be followed by set_lights().
  ///
  /// throws  like the constructor
  void set_objects() { surfaces_.set_objects(); }
  /// Applies a change of the scene's lights: solves and uploads them all.
  ///
  /// throws  gl::Unsupported like the constructor
  void set_lights();
  /// Replaces the scene's atmosphere: solves the carried lights and uploads the changes. In layered air carried lights
  /// are solved for the fog at the eye, and again when a frame finds the camera in other fog.
  ///
  /// throws  std::invalid_argument naming field, value and rule
  void set_atmosphere(const Atmosphere& atmosphere);
  /// Sets the exposure at which frames will be shown, 0 EV by default. Frames themselves are not exposed, but leave out
  /// what makes less than a step of the display. With `is_auto`, draws a frame in the present fog without the lamps'
  /// points and meters it. By airlight an exposure above 0 EV moves the lights' ends outwards.
  ///
  /// returns  the exposure used
  Exposure set_exposure(const Exposure& exposure);
  /// Makes draw() and set_exposure() throw Interrupted as soon as the function returns true. Polling slows drawing a
  /// little. An empty function never interrupts.
  void interrupt_when(std::function<bool()> is_unwanted) { is_unwanted_ = std::move(is_unwanted); }
  /// Draws a frame and waits for it.
  FrameCounts draw(LightPoints light_points = LightPoints::on) {
    return draw_for({exposure_, exposure_}, light_points);
  }
  /// Draws a frame that leaves out what makes less than a step at these exposures; at kMaxExposure it leaves out
  /// nothing. The lights' ends stay as set_exposure() chose them.
  FrameCounts draw_for(const FrameExposures& exposures, LightPoints light_points = LightPoints::on) {
    return draw_stages(exposures, light_points, nullptr);
  }
  /// Draws a frame stage by stage, as if the view had changed, and measures each. Takes longer than draw().
  FrameStatistics draw_and_measure();
  Picture read() const { return framebuffer_.read(); }
  /// Draws a frame in floats, for a picture that is_cut_off(), and reads it.
  ///
  /// throws  gl::Unsupported where the driver has no float framebuffer of that size
  Picture draw_in_floats();

  const scene::Scene& scene() const { return scene_; }
  /// The origin of all float positions, also in geometry buffers and shadow maps.
  const glm::dvec3& origin() const { return lights_.origin(); }
  const Atmosphere& atmosphere() const { return atmosphere_; }
  double exposure() const { return exposure_; }                ///< EV
  double ends_exposure() const { return lights_.exposure(); }  ///< EV that chooses the lights' ends (drawn_light)
  const RenderSettings& settings() const { return settings_; }
  int width() const { return framebuffer_.width(); }
  int height() const { return framebuffer_.height(); }
  int samples() const { return framebuffer_.samples(); }  ///< per pixel; some drivers take more than asked for
  /// Null for Shadows::none.
  const ShadowMaps* shadows() const { return shadows_ ? &*shadows_ : nullptr; }

  /// Draws a frame's surfaces, without panes, into a geometry buffer of the same size.
  void draw_geometry(const GeometryBuffer& geometry);
  bool has_panes() const { return surfaces_.has_panes(); }
  /// Draws a layer of a frame's panes: in each sample the pane that the frame draws after `layer` others, even if a
  /// surface hides it.
  void draw_pane_geometry(const GeometryBuffer& geometry, int layer);
  /// The surfaces' materials without their texels, indexed by GeometrySample::material.
  std::vector<scene::Material> materials() const { return surfaces_.surfaces().materials(); }

 private:
  View view() const;
  FrameLight frame_light() const;
  FrameView frame_view(const View& view, const FrameExposures& exposures) const;
  Passes passes() const { return settings_.path->has_several_passes() ? Passes::several : Passes::one; }
  /// What FogLighting::airlight needs: the lights drawn, where rays end, and the airlight within and beyond extents.
  struct Airlight {
    AirlightLights lights;
    HigherOrderTextures higher_orders;
    FarAirlight far;
    std::optional<ScatteredLight> scattered;  // on surfaces
    SeenRanges seen;
    AirlightPyramid pyramid;

    Airlight(const gl::FogLightBuffer& fog, const SamplerStates& states, int samples, const RenderSettings& settings)
        : far(fog), seen(samples), pyramid(fog, states, settings) {
      if (has_scattered_light(settings)) scattered.emplace(fog);
    }
    void set_size(glm::ivec2 size);
  };

  void set_lights_for(double ends_exposure);
  /// Sets the lights again if the camera has moved far from origin(), and the fog if it has entered other fog.
  void follow_camera();
  Fog fog_at_eye() const { return atmosphere_.fog_at(scene_.camera.position.y); }
  void set_framebuffer(int width, int height, Passes passes);
  void begin_frame(const Framebuffer& framebuffer, const glm::vec3& background);
  double count_lights_per_fragment();
  /// Uploads a new plan's lists. Returns the bytes uploaded.
  std::size_t upload_lists(const FramePlan& plan);
  FrameCounts draw_stages(const FrameExposures& exposures, LightPoints light_points, FrameStatistics* statistics);
  void draw_light_points(const View& view, const FramePlan& plan);
  std::size_t draw_panes(const View& view, const FramePlan& plan);
  void draw_airlight(const View& view, double exposure, Interruption& interruption);

  const scene::Scene& scene_;
  RenderSettings settings_;
  Atmosphere atmosphere_;
  Fog solved_fog_;  // for which carried lights are solved
  std::function<bool()> is_unwanted_;
  double exposure_ = 0;
  std::size_t fog_bytes_ = 0;  // uploaded by the last change of the fog
  Framebuffer framebuffer_;
  SceneLights lights_;
  gl::FogLightTables light_tables_;
  std::optional<LayeredTexture> cookies_;
  BufferTexture cookie_cones_;
  gl::FogLightBuffer fog_block_;  // holds no lights
  SurfacePainter surfaces_;
  std::optional<ShadowMaps> shadows_;
  FramePlanner planner_;
  std::optional<BufferTexture> light_list_;  // FramePlan::light_list
  SamplerStates sampler_states_;
  SkyPainter sky_;
  gl::Program light_point_program_;
  std::optional<Airlight> airlight_;
  Compositor compositor_;
};

}  // namespace litfog::render
