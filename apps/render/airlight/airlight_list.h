// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "litfog/atmosphere.h"
#include "litfog/light_bounds.h"
#include "render/airlight/higher_orders.h"
#include "render/light/scene_lights.h"

namespace litfog::render {

inline constexpr int kCoarsestGrid = 8;  ///< pixels between texels of the coarsest grid (AirlightPyramid)

/// Where a picture's rays can see the airlight of a light.
struct AirlightEntry {
  float light;  ///< index in SceneLights
  /// Metres from the light, beyond which its airlight is left out (airlight_list_test.cpp).
  float reach;
  /// Metres from the light, within which its airlight, about k / h at a distance h, bends so sharply that a grid of all
  /// pixels may miss an eighth of a step of the display. For a grid of every g-th pixel this range is g^(4/5) times as
  /// large.
  float bend_range;
  float width;  ///< metres from the light, within which its airlight is flat; 0 for a beam not seen along its axis
};

/// Lights of one kind are drawn by one program. What a light scatters once and the peak of its higher orders are
/// entries of two kinds, for the peak bends far less.
struct AirlightKind {
  bool has_higher_orders = false;  ///< shaders/airlight/higher_orders.glsl; an entry is their peak and nothing else
  int profile;                     ///< FogLightInstance; of a peak that of a point or of any cone
  bool has_shafts = false;         ///< shadows cut shafts into the airlight
  bool has_knee = false;           ///< attenuation's constant below 1: full brightness up to a range
  bool has_far_peak = false;       ///< litfog/shaders/far_airlight.glsl

  auto operator<=>(const AirlightKind&) const = default;
};

/// The lights whose airlight a picture shows, grouped by kind, peaks of higher orders last.
struct AirlightList {
  struct Range {
    AirlightKind kind;
    unsigned first, count;
  };

  std::vector<AirlightEntry> entries;
  std::vector<LightBounds> bounds;  ///< one an entry: its reach, cut to its cone if it has one and is no peak
  std::vector<Range> ranges;
  std::size_t light_count = 0;  ///< of an entry or of two
};

/// Leaves out airlight that fog hides: at most kAirlightShare of a step of the display in any pixel for all lights
/// together, an equal part for each.
///
/// pixels_per_radian  of the picture, at its middle
/// exposure           EV at which it is shown
/// higher_orders      of the lights
/// casters            of each light: its number among those that cut shafts, or below 0; empty: none cuts any
/// beyond_extents     whether lights without shafts light the fog beyond their extents
AirlightList list_airlight(const SceneLights& lights, const Atmosphere& atmosphere, const glm::dvec3& eye,
                           double pixels_per_radian, double exposure, const HigherOrders& higher_orders = {},
                           std::span<const std::int32_t> casters = {}, bool beyond_extents = true);

}  // namespace litfog::render
