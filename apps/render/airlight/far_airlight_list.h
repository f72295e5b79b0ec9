// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "litfog/airlight.h"
#include "litfog/fog.h"
#include "render/light/scene_lights.h"

namespace litfog::render {

/// The lights whose airlight beyond their extents a picture shows: those of one profile (FogLightInstance) lie
/// together.
struct FarAirlightList {
  struct Range {
    int profile;
    int first, count;
  };

  std::vector<std::int32_t> lights;  ///< of SceneLights
  std::vector<Range> ranges;
  double depth = 0;  ///< metres from the eye, beyond which they add nothing that is visible; at most kSkyDistance
};

/// Of what lights add beyond their extents, at most kFarShare of a step of the display is left out in any pixel.
///
/// Proof. Beyond the extent E of a light a(r) is at most its threshold t, and f(r) at most f(E). The weights -f'(s) of
/// the eye's leg sum to at most 1. So the light adds at most c t f(E), c being its colour times the phase function,
/// both where they are largest. Where -f'(s) f(r) is at most w (litfog/shaders/glow.glsl, with the larger of L and E
/// for L, since r >= E), it also adds at most c w 2 / (Q E), because a(r) <= 1 / (Q r^2), on both sides of the closest
/// approach. From a distance S from the eye on, with the larger of E and S - L for E, what is left is also f(S) times
/// the first.
///
/// exposure  EV at which the picture is shown
/// casters   of each light whether it cuts shafts: at least 0; empty: none does. Those that do are left out
FarAirlightList list_far_airlight(const SceneLights& lights, const Fog& fog, const Scattering& scattering,
                                  const glm::dvec3& eye, double exposure, std::span<const std::int32_t> casters = {});

}  // namespace litfog::render
