// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"

namespace litfog::scene {

// Road signs on a galvanised post at the origin. They face +Z, towards a driver who looks along -Z.

struct Sign {
  float size_m = 0.75f;   ///< diameter, side or width of the plate
  float height_m = 2.2f;  ///< of the plate's middle
};

struct SpeedSign : Sign {
  int number = 50;
};
Model make_speed_sign(const SpeedSign& sign);  ///< round, red border, a number
Model make_warning_sign(const Sign& sign);     ///< triangle, red border, an exclamation mark
Model make_direction_sign(const Sign& sign);   ///< rectangle, blue with a white border and arrow

struct Chevron : Sign {
  int left = 0;  ///< 1: the bend goes left
};
Model make_chevron_sign(const Chevron& sign);  ///< red and white chevrons that point into a bend

}  // namespace litfog::scene
