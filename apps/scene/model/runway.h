// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"

namespace litfog::scene {

/// A paved runway from its threshold at the origin to -Z, 45 m wide, with the markings of ICAO annex 14 for a code 4
/// precision approach runway at both ends.
struct Runway {
  float length_m = 1500.0f;
  int number = 27;          ///< designator of the end at the origin; the other end differs by 18
  float shoulder_m = 7.5f;  ///< asphalt beside the runway
  float lift_m = 0.03f;     ///< of the paint over the surface
};
inline constexpr float kRunwayWidth_m = 45.0f;
Model make_runway(const Runway& runway);

}  // namespace litfog::scene
