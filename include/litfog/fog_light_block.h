// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "litfog/atmosphere.h"
#include "litfog/light.h"
#include "litfog/solve.h"

namespace litfog {

// Shaders read lights from two tables (litfog/shaders/light.glsl), so that a change of the fog changes few numbers,
// however many lights there are. A kind holds what its lights have in common, including everything that the fog
// changes; an instance is one light. The same tables serve as uniform block, buffer textures and storage buffers: their
// members are all vec4, so std140, std430, texels and C++ agree. World space, metres.

/// The values that lights of a kind share. For airlight, shaders also need the fog's density, which they scale.
struct FogLightKind {
  /// x constant, y linear, z quadratic, w extent; infinite extents are stored as the largest float
  glm::vec4 attenuation_extent;
  /// xy cone parameters (litfog/shaders/cone_profile.glsl), z density scale, w fog colour intensity, 0 unless carried
  glm::vec4 cone_scale_intensity;
};

/// One light.
struct FogLightInstance {
  glm::vec4 position_kind;  ///< xyz position, w index of its kind
  /// xyz unit axis, w the cone's profile, or a cookie, which shaders evaluate (litfog/shaders/cone_profile.glsl)
  glm::vec4 axis_profile;
  glm::vec4 color;  ///< rgb linear colour, w 0; w of a cookie is free for shaders
};

/// The fog: the first members of the uniform block.
struct FogHeader {
  glm::vec4 fog;                         ///< x density (1/m), y FogMode, z number of instances in the block, w albedo
  glm::vec4 ambient_fog_color;           ///< rgb linear, w number of knots
  std::array<glm::vec4, 2> phase_lobes;  ///< litfog_packed_lobe() of litfog/shaders/phase.glsl makes them
  std::array<glm::vec4, kMaxDensityKnots> density_knots;  ///< x height (m), y density (1/m), zw 0
};

inline constexpr std::size_t kMaxFogLights =
    200;  ///< fits into the 16 KiB that OpenGL 3.3 guarantees, even if all kinds differ

/// The fog and the lights: the shaders' uniform block (std140).
struct FogLightBlock {
  FogHeader header;
  std::array<FogLightKind, kMaxFogLights> kinds;
  std::array<FogLightInstance, kMaxFogLights> instances;
};

static_assert(offsetof(FogLightKind, cone_scale_intensity) == 16 && sizeof(FogLightKind) == 32);
static_assert(offsetof(FogLightInstance, axis_profile) == 16 && offsetof(FogLightInstance, color) == 32 &&
              sizeof(FogLightInstance) == 48);
static_assert(offsetof(FogHeader, ambient_fog_color) == 16 && offsetof(FogHeader, phase_lobes) == 32 &&
              offsetof(FogHeader, density_knots) == 64 && sizeof(FogHeader) == 192);
static_assert(offsetof(FogLightBlock, kinds) == 192 && offsetof(FogLightBlock, instances) == 192 + kMaxFogLights * 32 &&
              sizeof(FogLightBlock) == 192 + kMaxFogLights * 80 && sizeof(FogLightBlock) <= 16384);

/// The kind of a light. The intensity is stored for carried lights only: Hales's term assumes a light near the eye.
///
/// solution  of this light in the fog
/// throws    std::invalid_argument naming field, value and rule of the light
FogLightKind pack_fog_light_kind(const PlacedLight& light, const FogIntensity& solution);

/// One light's entry.
///
/// kind    index among the kinds, at most 2^24: a float holds it
/// throws  std::invalid_argument naming field, value and rule of the light or of kind
FogLightInstance pack_fog_light_instance(const PlacedLight& light, std::size_t kind);

/// The fog's part of the block. An infinite density is stored as the largest float.
///
/// instances  number of lights in the block, at most kMaxFogLights; 0 if all lights are in buffers
/// throws     std::invalid_argument naming field, value and rule
FogHeader pack_fog_header(const Atmosphere& atmosphere, std::size_t instances);

/// The whole block from lights and their solutions, in order. Each light has its own kind; unused entries are zero.
/// For lights that do not change; others need a FogUpdater (litfog/updater.h).
///
/// throws  std::invalid_argument as pack_fog_header; also for more than kMaxFogLights lights, or if the numbers of
///         lights and solutions differ
FogLightBlock pack_fog_light_block(const Atmosphere& atmosphere, std::span<const PlacedLight> lights,
                                   std::span<const FogIntensity> solutions);

}  // namespace litfog
