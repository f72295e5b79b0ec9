// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

// Road signs on a galvanised post at the origin. They face +Z, towards a driver who looks along -Z.

struct Sign {
  float size_m = 0.75f;   ///< diameter, side or width of the plate
  float height_m = 2.2f;  ///< height of the plate's middle

  void describe(ParameterList& list) {
    list.add("size_m", size_m, 0.2, 3);
    list.add("height_m", height_m, 0.5, 8);
  }
};

/// Triangle, red border, an exclamation mark.
Model make_warning_sign(const Sign& sign);

/// Round, red border, a number.
struct SpeedSign {
  int number = 50;
  Sign sign;

  void describe(ParameterList& list) {
    list.add("number", number, 1, 99);
    sign.describe(list);
  }
};
Model make_speed_sign(const SpeedSign& speed);

}  // namespace litfog::scene
