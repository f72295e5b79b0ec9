// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "litfog/airlight.h"
#include "litfog/fog.h"
#include "render/scene_lights.h"

namespace litfog::render {

/// Where a picture's rays can see the airlight of a light.
struct AirlightEntry {
  float light;  ///< of SceneLights
  /// Metres from the light within which a ray must pass to show more of it than the budget (airlight_list_test.cpp).
  float reach;
  /// Metres from the light where k / h, which its airlight at a distance h is at most, bends so that straight lines between
  /// pixels miss it by kMostBend. Between every g-th pixel that is so at g^(2/3) of it.
  float bend_range;
  float width;  ///< metres, within which its airlight is flat
};

/// The lights whose airlight a picture shows: those of one profile (FogLightInstance) lie together.
struct AirlightList {
  struct Range {
    int profile;
    unsigned first, count;
  };

  std::vector<AirlightEntry> entries;
  std::vector<Range> ranges;
};

/// What fog hides is left out.
///
/// budget             of linear values, below which the airlight of a light is left out
/// pixels_per_radian  of the picture, at its middle
AirlightList list_airlight(const SceneLights& lights, const Fog& fog, const Scattering& scattering,
                           const glm::dvec3& eye, double pixels_per_radian, double budget);

}  // namespace litfog::render
