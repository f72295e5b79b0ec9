// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <string>

#include "render/plan/lighting_path.h"

namespace litfog::render {

/// The most lights that a shader takes as uniforms, for the fog and for the surface each.
inline constexpr std::size_t kMaxUniformLights = 16;
/// The most lights that a pass of LightFeed::Kind::all without flags takes as uniforms; it reads more from the light
/// list. Drivers compile each light of an unrolled loop: with 16, the street's first picture took twice as long on
/// llvmpipe, and a frame as long as with 4.
inline constexpr std::size_t kMaxUnrolledLights = 4;

/// The number of lights that a shader for `lights` lights is compiled for: at least `lights`, at most
/// kMaxUniformLights.
std::size_t compiled_light_count(std::size_t lights);

/// Features of materials and meshes. Only shaders compiled with a feature pay for it (material.frag).
struct MaterialFeatures {
  bool is_flat = false;  ///< without a normal map, where the path has them
  bool is_masked = false;
  bool is_pane = false;
  bool is_unlit = false;
  bool has_emission_map = false;
  bool has_second_texture = false;
  bool has_ambient = false;  ///< has its own Ka, on paths of the Basic model
  bool has_details = false;  ///< its vertices have scene::VertexDetail

  auto operator<=>(const MaterialFeatures&) const = default;
};

/// What a pass's shaders are compiled for.
struct ShaderVariant {
  const SurfacePass* pass;
  MaterialFeatures material = {};
  bool is_first = true;  ///< the pass draws the surface for the first time
  bool has_listed_lights = false;
  bool has_listed_fog_lights = false;
  std::size_t fog_light_count = 0;  ///< the first lights of the uniform array
  std::size_t light_count = 0;      ///< the other lights
  bool shares_lights = false;       ///< the fog's lights also light the surface
  bool tests_depth_late = false;    ///< shaders/depth_test.glsl
  std::size_t knot_count = 0;       ///< the density profile's

  auto operator<=>(const ShaderVariant&) const = default;
};

/// The text of pass.glsl for a variant.
std::string pass_constants(const ShaderVariant& variant);
/// The text of material.glsl for a material.
std::string material_constants(const MaterialFeatures& material);

}  // namespace litfog::render
