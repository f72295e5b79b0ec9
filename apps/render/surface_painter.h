// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "litfog/fog_light_block.h"
#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/program.h"
#include "litfog/solve.h"
#include "render/light_map_store.h"
#include "render/render_settings.h"
#include "render/scene_lights.h"

namespace litfog::render {

/// What a frame drew, and what it could leave out.
struct FrameCounts {
  std::size_t chunks_drawn = 0;
  std::size_t chunks_skipped = 0;  ///< out of view
  std::size_t lights_listed = 0;   ///< listed for all drawn chunks together
  std::size_t lights_skipped = 0;  ///< not listed, for all drawn chunks together
};

/// Draws a scene's surfaces by a lighting path. Needs a current GL context.
class SurfacePainter {
 public:
  /// scene, lights, fog_lights  have to outlive this
  /// throws  gl::Unsupported where this OpenGL cannot hold the scene's light lists or the path's light maps, or lays
  ///         FogLights out otherwise
  SurfacePainter(const scene::Scene& scene, const SceneLights& lights, const gl::FogLightBuffer& fog_lights,
                 const RenderSettings& settings);

  /// Takes the solutions of the carried lights, one each.
  void set_fog(std::span<const FogIntensity> solutions);
  FrameCounts draw(const LightingPath& path, const glm::mat4& clip_from_world);
  /// By their numbers, without their texels.
  std::vector<scene::Material> materials() const { return surfaces_.materials(); }

 private:
  static constexpr int kAnyProfile = -1;  // one that the shader has to ask for

  /// What a shader is compiled for, of lights handed over.
  struct HandedLights {
    std::size_t count = 0;
    int profile = kAnyProfile;  // that all of them have

    auto operator<=>(const HandedLights&) const = default;
  };
  /// A pass's shaders, compiled for a number of lights.
  struct Variant {
    const SurfacePass* pass;
    bool is_first = true;  // of the times that the pass draws a surface
    bool has_listed_lights = false;
    bool has_listed_fog_lights = false;
    HandedLights fog_lights = {};  // the first of those handed over
    HandedLights lights = {};      // the others
    bool shares_lights = false;    // the surface is lit by the fog's lights, too

    std::string constants() const;  // pass.glsl
    auto operator<=>(const Variant&) const = default;
  };
  struct SurfaceProgram {
    SurfaceProgram(const Variant& variant, const scene::Scene& scene, const RenderSettings& settings);

    gl::Program program;
    int world_from_model, bounds_low, bounds_high, light_list_range, handed_lights, cone_from_world;
    std::size_t frame = 0;                      // for which its uniforms were set last
    const SurfaceMaterial* material = nullptr;  // to which they were set
  };

  void draw_surface(const LightingPath& path, const Surface& surface);
  /// A light as shaders take it, with its fog intensity.
  FogLight light_handed_over(std::int32_t light) const;
  /// The lights handed over from one on, with black ones up to the number that a shader is compiled for.
  HandedLights round_up(std::size_t first);
  /// Draws a surface by the lights of its fog and a batch of its own; what the variant says of lights handed over is
  /// found here.
  void draw_pass(const Surface& surface, Variant variant, std::span<const std::int32_t> batch);
  SurfaceProgram& use(const Variant& variant, const SurfaceMaterial& material);
  /// The lights that can reach a surface: indices of scene lights, by kind; and the carried ones that can light the fog
  /// before it.
  void find_lights(const Surface& surface);
  void find_fog_lights(const Surface& surface);
  /// How many of the first lights make a batch: those that share their maps, at most so many.
  std::size_t batch_length(std::span<const std::int32_t> lights, int most) const;

  const scene::Scene& scene_;
  const SceneLights& lights_;
  const gl::FogLightBuffer& fog_light_buffer_;
  RenderSettings settings_;
  SurfaceList surfaces_;
  LightMapStore maps_;
  std::map<Variant, SurfaceProgram> programs_;
  std::vector<float> fog_intensities_;    // of the carried lights
  std::vector<std::int32_t> reaching_;    // what find_lights found
  std::vector<std::int32_t> fog_lights_;  // what find_fog_lights found
  std::vector<FogLight> handed_;          // over to a pass
  std::vector<glm::mat3> batch_cones_;
  std::size_t frame_ = 0;
  glm::mat4 clip_from_world_{1.0f};
  bool has_several_passes_ = false;  // the path being drawn
  int drawn_passes_ = 0;             // of the surface being drawn
  const SurfaceProgram* used_ = nullptr;
  const SurfaceMaterial* bound_ = nullptr;
};

}  // namespace litfog::render
