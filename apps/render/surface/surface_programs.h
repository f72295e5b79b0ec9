// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <span>
#include <string>
#include <utility>

#include "litfog/gl/program.h"
#include "render/render_settings.h"
#include "render/surface/shader_variant.h"
#include "render/surface/surface_list.h"
#include "scene/scene.h"

namespace litfog::render {

/// A variant's program, and the last values of its uniforms.
struct SurfaceProgram {
  explicit SurfaceProgram(gl::Program linked);

  gl::Program program;
  int world_from_model, bounds_low, bounds_high, light_list_range, uniform_lights, light_flags, uniform_casters,
      cone_from_world;
  std::size_t frame = 0;
  const SurfaceMaterial* material = nullptr;
};

/// The programs that draw a scene's surfaces, each compiled on first use. Needs a current GL context.
class SurfacePrograms {
 public:
  SurfacePrograms(const scene::Scene& scene, const RenderSettings& settings);

  /// The program of a variant, with or without a moon as the scene is now, valid as long as this object.
  SurfaceProgram& program(const ShaderVariant& variant);
  bool should_test_depth_late() const { return should_test_depth_late_; }  ///< render::should_test_depth_late()

 private:
  const scene::Scene& scene_;
  bool has_cookies_;
  bool has_shadows_;
  bool should_test_depth_late_;
  std::string samples_;   // the beginning of material.glsl, which every reader of a fragment's position includes
  std::string settings_;  // the rest of environment.glsl
  std::span<const gl::ShaderSource> path_shaders_;
  std::map<std::pair<ShaderVariant, bool>, SurfaceProgram> programs_;  // by variant and whether there is a moon
};

}  // namespace litfog::render
