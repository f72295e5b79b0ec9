// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "litfog/updater.h"
#include "render/display.h"
#include "render/gpu/texture.h"
#include "render/plan/view.h"
#include "render/render_settings.h"
#include "render/surface/mesh_store.h"
#include "render/surface/sky_painter.h"
#include "scene/scene.h"

namespace litfog::browser {

inline constexpr double kMaxExposure = 12;  ///< EV, either way, of the page's slider

/// What a frame did.
struct FrameReport {
  std::size_t surfaces = 0;        ///< drawn; the others are out of view
  std::size_t bytes_uploaded = 0;  ///< of the light tables
  double exposure = 0;             ///< EV, at which it is shown
};

/// Draws a scene's surfaces, sky, lamps and lit fog by WebGL 2 into the current context's canvas: litfog's core and
/// shaders, and what of the demo's renderer WebGL 2 can hold. No shadows.
class View {
 public:
  /// Needs float framebuffers (EXT_color_buffer_float).
  ///
  /// scene  has to outlive this; may change its camera and, followed by set_light(), its lights
  explicit View(const scene::Scene& scene);

  /// Pixels.
  void set_size(int width, int height);
  /// Takes a change of a light of the scene.
  void set_light(std::size_t light);
  void set_fog_lighting(render::FogLighting fog_lighting);

  /// display  an automatic exposure is chosen by every so many of the frame's pixels, as render::auto_exposure does
  FrameReport draw(const Fog& fog, const render::Display& display);

 private:
  struct SurfaceMaterial {
    scene::Material material;
    render::Texture albedo;
    render::Texture normal;
  };
  /// What is drawn to, several samples a pixel.
  struct Samples {
    gl::FramebufferName framebuffer;
    gl::RenderbufferName color;
    gl::RenderbufferName depth;
  };
  /// A picture of one sample a pixel.
  struct Target {
    explicit Target(glm::ivec2 target_size);

    glm::ivec2 size;
    gl::FramebufferName framebuffer;
    gl::TextureName color;
  };

  PlacedLight drawn_light(std::size_t light) const;
  /// Makes a program current, with the uniforms that most have.
  void use(const gl::Program& program, const render::View& view) const;
  /// Returns how many.
  std::size_t draw_surfaces(const render::View& view);
  /// Composes resolved_ and the airlight before it.
  void draw_airlight(const render::View& view);
  /// All of a framebuffer, scaled.
  static void copy(const gl::FramebufferName& from, glm::ivec2 size, const Target& to);
  /// EV, chosen by a picture.
  double measured_exposure(const Target& picture);

  const scene::Scene& scene_;
  unsigned carried_count_ = 0;
  render::FogLighting fog_lighting_ = render::FogLighting::airlight;
  glm::ivec2 size_{0};
  FogUpdater updater_;
  std::vector<FogLightHandle> handles_;  // of the scene's lights
  gl::FogLightBuffer light_block_;
  render::MeshStore meshes_;
  std::map<std::string, SurfaceMaterial> materials_;
  render::SkyPainter sky_;
  gl::Program surface_program_;
  std::array<gl::Program, 2> point_programs_;  // one a FogLighting
  gl::Program airlight_program_;
  gl::Program shown_program_;
  gl::VertexArrayName no_vertices_;
  std::optional<Samples> drawn_;
  std::optional<Target> resolved_;  // the means of the samples
  std::optional<Target> composed_;  // with airlight
  std::optional<Target> measured_;  // every so many of its pixels
};

}  // namespace litfog::browser
