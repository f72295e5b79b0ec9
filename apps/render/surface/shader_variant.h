// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <span>
#include <string>

#include "render/light/scene_lights.h"
#include "render/plan/lighting_path.h"

namespace litfog::render {

/// The most lights that are passed as uniforms, for the fog as for the surface in a pass that takes all lights. More
/// lights are read through the light list.
inline constexpr std::size_t kMaxUniformLights = 16;

/// The number of lights that a shader for `lights` lights is compiled for: at least `lights`, at most
/// kMaxUniformLights.
std::size_t compiled_light_count(std::size_t lights);

/// The uniform lights that a shader is compiled for.
struct UniformLights {
  static constexpr int kAnyProfile = -1;  ///< one that the shader has to ask for

  std::size_t count = 0;
  int profile = kAnyProfile;  ///< that all of them have

  auto operator<=>(const UniformLights&) const = default;
};

/// A shader of compiled_light_count() lights for these.
UniformLights compiled_for(std::span<const PackedLight> lights);

/// What some materials and meshes have, or lack, beside others: only shaders compiled with a feature pay for it
/// (material.frag).
struct MaterialFeatures {
  bool is_flat = false;  ///< without a normal map, where the path has them
  bool is_masked = false;
  bool is_pane = false;
  bool is_unlit = false;
  bool has_emission_map = false;
  bool has_second_texture = false;
  bool has_details = false;  ///< its vertices: scene::VertexDetail

  auto operator<=>(const MaterialFeatures&) const = default;
};

/// What a pass's shaders are compiled for.
struct ShaderVariant {
  const SurfacePass* pass;
  MaterialFeatures material = {};
  bool is_first = true;  ///< of the times that the pass draws a surface
  bool has_listed_lights = false;
  bool has_listed_fog_lights = false;
  UniformLights fog_lights = {};               ///< the first of the uniform array
  UniformLights lights = {};                   ///< the others
  bool shares_lights = false;                  ///< the surface is lit by the fog's lights, too
  bool takes_constants_from_vertices = false;  ///< shaders/draw_constants.glsl
  std::size_t vertex_lights = 0;               ///< of the uniform lights, the first: those that vertices pass on
  bool tests_depth_late = false;               ///< shaders/depth_test.glsl

  auto operator<=>(const ShaderVariant&) const = default;
};

/// The text of pass.glsl for a variant.
std::string pass_constants(const ShaderVariant& variant);
/// The text of material.glsl for a material.
std::string material_constants(const MaterialFeatures& material);

}  // namespace litfog::render
