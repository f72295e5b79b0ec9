// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "litfog/atmosphere.h"
#include "litfog/light_bounds.h"
#include "render/light/scene_lights.h"

namespace litfog::render {

inline constexpr int kCoarsestGrid = 8;  ///< pixels between texels of the coarsest grid (AirlightPyramid)

/// Where a picture's rays can see the airlight of a light.
struct AirlightEntry {
  float light;  ///< of SceneLights
  /// Metres from the light. What a ray shows of it from beyond is left out (airlight_list_test.cpp).
  float reach;
  /// Metres from the light where its airlight, about k / h at a distance h, bends so that a grid of all pixels may
  /// miss an eighth of a step of the display. A grid of every g-th pixel may do so at g^(4/5) times that range.
  float bend_range;
  float width;  ///< metres, within which its airlight is flat; 0 for a beam, unless seen along its axis
};

/// What lights that are drawn by one program have in common.
struct AirlightKind {
  int profile;              ///< FogLightInstance
  bool has_shafts = false;  ///< cut out by shadows
  bool has_knee = false;    ///< a stretch of full brightness: their attenuation's constant is below 1

  auto operator<=>(const AirlightKind&) const = default;
};

/// The lights whose airlight a picture shows: those of a kind lie together.
struct AirlightList {
  struct Range {
    AirlightKind kind;
    unsigned first, count;
  };

  std::vector<AirlightEntry> entries;
  std::vector<LightBounds> bounds;  ///< of each entry: within its reach and its cone, if it has one
  std::vector<Range> ranges;
};

/// What fog hides is left out: of all lights together at most kAirlightShare of a step of the display in any pixel, of
/// each an equal part.
///
/// pixels_per_radian  of the picture, at its middle
/// exposure           EV at which it is shown
/// casters            of each light: its number among those that cut shafts, or below 0; empty: none cuts any
AirlightList list_airlight(const SceneLights& lights, const Atmosphere& atmosphere, const glm::dvec3& eye,
                           double pixels_per_radian, double exposure, std::span<const std::int32_t> casters = {});

}  // namespace litfog::render
