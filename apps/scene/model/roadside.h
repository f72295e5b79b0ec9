// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/path.h"

namespace litfog::scene {

/// Things in a row along a path, beside it by offset_m (to the right; negative: left).
struct Row : Path {
  float offset_m = 5.0f;
  float spacing_m = 25.0f;
};

struct Fence : Row {
  Fence() {
    offset_m = 9.0f;
    spacing_m = 2.5f;
  }
  float height_m = 1.2f;
  int rails = 3;
  int seed = 1;
};
Model make_fence(const Fence& fence);

/// A steel barrier with its W-shaped beam towards the path's middle.
struct GuardRail : Row {
  GuardRail() {
    offset_m = 4.6f;
    spacing_m = 2.0f;
  }
};
Model make_guard_rail(const GuardRail& rail);

/// A marker post: white, slanted top, black band, reflectors on both faces (+Z, towards the driver, and -Z).
struct Delineator {
  float height_m = 1.0f;
};
Model make_delineator(const Delineator& delineator);

/// Marker posts on both sides, at +-offset_m.
struct Delineators : Row {
  float height_m = 1.0f;
};
Model make_delineators(const Delineators& delineators);

/// A lamp over the road: its light leaves from (arm_m, height_m - 0.15, 0).
struct StreetLamp {
  float height_m = 7.0f;
  float arm_m = 1.8f;  ///< to +X
};
Model make_street_lamp(const StreetLamp& lamp);

/// A wooden pole with a cross-arm and insulators.
struct UtilityPole {
  float height_m = 8.5f;
};
Model make_utility_pole(const UtilityPole& pole);

/// Such poles in a row with three sagging wires.
struct PowerLine : Row {
  PowerLine() {
    offset_m = 11.0f;
    spacing_m = 45.0f;
  }
  float height_m = 8.5f;
};
Model make_power_line(const PowerLine& line);

}  // namespace litfog::scene
