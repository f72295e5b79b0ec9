// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "litfog/fog.h"
#include "litfog/light.h"
#include "litfog/solve.h"

namespace litfog {

/// Parameters of one light for the shaders (litfog/shaders/light.glsl). World space, metres; vec4 members only, so that
/// std140, std430 and C++ agree.
struct FogLight {
  glm::vec4 position_extent;  ///< xyz position, w extent; infinite extents are stored as the largest float
  glm::vec4 axis_profile;     ///< xyz unit axis, w profile: 0 none, 1 cosine, 2 smoothstep; 3 is left to shaders
  glm::vec4 color_intensity;  ///< rgb linear colour, w fog colour intensity (0 where the light is not carried)
  glm::vec4 attenuation;      ///< x constant, y linear, z quadratic, w density scale
  glm::vec4 cone;             ///< cosine: x cos half angle, y exponent; smoothstep: x cos outer, y cos inner; none: 0
};

inline constexpr std::size_t kMaxFogLights = 128;  ///< keeps the block below OpenGL 3.3's guaranteed 16 KiB

/// The fog and the lights that light it: the uniform block of the shaders (std140).
struct FogLightBlock {
  glm::vec4 fog;                ///< x density (1/m), y mode: 0 exp, 1 exp2, z number of lights, w 0
  glm::vec4 ambient_fog_color;  ///< rgb linear, w 0
  std::array<FogLight, kMaxFogLights> lights;
};

static_assert(offsetof(FogLight, axis_profile) == 16 && offsetof(FogLight, color_intensity) == 32 &&
              offsetof(FogLight, attenuation) == 48 && offsetof(FogLight, cone) == 64 && sizeof(FogLight) == 80);
static_assert(offsetof(FogLightBlock, ambient_fog_color) == 16 && offsetof(FogLightBlock, lights) == 32 &&
              sizeof(FogLightBlock) == 32 + kMaxFogLights * 80 && sizeof(FogLightBlock) <= 16384);

/// One light's parameters. The intensity is stored for carried lights only: Hales's term presumes a light near the eye.
///
/// solution  of this light in the fog of the block
/// throws    std::invalid_argument naming field, value and rule of the light
FogLight pack_fog_light(const PlacedLight& light, const FogIntensity& solution);

/// The whole block from lights and their solutions, in order; unused entries are zero.
/// An infinite density is stored as the largest float.
///
/// ambient_fog_color  linear RGB, finite, >= 0
/// throws             std::invalid_argument naming field, value and rule; also for more than kMaxFogLights lights, or
///                    not one solution a light
FogLightBlock pack_fog_light_block(const Fog& fog, const glm::dvec3& ambient_fog_color,
                                   std::span<const PlacedLight> lights, std::span<const FogIntensity> solutions);

}  // namespace litfog
