// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <tuple>

#include "litfog/fog.h"
#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/airlight/far_airlight_list.h"
#include "render/gpu/data_texture.h"
#include "render/light/scene_lights.h"
#include "scene/scene.h"

namespace litfog::render {

/// What lights add to the fog beyond their extents. One light adds little there, but hundreds in view made pictures
/// darker by tens of steps of the display. It changes slowly over a picture and along its rays, so that all lights
/// together are summed up at few places: in slabs of the rays through some hundreds of pixels
/// (shaders/far_airlight.frag), between which pixels look it up. Needs a current GL context.
class FarAirlight {
 public:
  /// scene, lights, fog_lights  have to outlive this
  FarAirlight(const scene::Scene& scene, const SceneLights& lights, const gl::FogLightBuffer& fog_lights)
      : scene_(scene), lights_(lights), fog_lights_(fog_lights) {}

  /// Sums it up for a frame. The lights and the cookies are bound to their units.
  ///
  /// pixels_per_radian  of the picture, at its middle
  /// exposure           EV at which the picture is shown
  /// casters            of list_far_airlight
  /// throws             gl::Unsupported where the driver cannot draw into textures of floats
  void draw(glm::ivec2 picture_size, double pixels_per_radian, const glm::mat4& direction_from_clip, const Fog& fog,
            double exposure, std::span<const std::int32_t> casters);

  bool is_empty() const { return depth_ == 0; }
  /// Lets the program in use, one of shaders/far_airlight_at.glsl, look up what has been drawn.
  void bind(const gl::Program& program) const;

 private:
  void set_size(glm::ivec2 size);
  const gl::Program& light_program(FogMode fog_mode, int profile);

  const scene::Scene& scene_;
  const SceneLights& lights_;
  const gl::FogLightBuffer& fog_lights_;
  double depth_ = 0;  // FarAirlightList::depth
  int step_ = 1;      // pixels between texels
  glm::ivec2 size_{0};
  std::optional<BufferTexture> listed_;
  std::map<std::tuple<FogMode, int, bool>, gl::Program> light_programs_;  // by profile, and whether fog is isotropic
  std::optional<gl::Program> sum_program_;
  gl::FramebufferName slabs_framebuffer_;
  gl::TextureName slabs_;
  gl::FramebufferName sums_framebuffer_;
  gl::TextureName sums_;
  gl::VertexArrayName vertex_array_;  // of no attributes
};

}  // namespace litfog::render
