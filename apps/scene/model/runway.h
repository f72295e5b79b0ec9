// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

/// A paved runway from its threshold at the origin to -Z, 45 m wide, with the markings at both ends of a code 4
/// precision approach runway (ICAO Annex 14, "Aerodromes", volume I).
struct Runway {
  float length_m = 1500.0f;
  int number = 27;          ///< designator of the end at the origin; the other end differs by 18
  float shoulder_m = 7.5f;  ///< asphalt beside the runway
  float lift_m = 0.03f;     ///< height of the paint over the surface

  void describe(ParameterList& list) {
    list.add("length_m", length_m, 900, 4000);
    list.add("number", number, 1, 36);
    list.add("shoulder_m", shoulder_m, 1, 30);
    list.add("lift_m", lift_m, 0.005, 0.2);
  }
};
inline constexpr float kRunwayWidth_m = 45.0f;
Model make_runway(const Runway& runway);

}  // namespace litfog::scene
