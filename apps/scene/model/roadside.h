// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"
#include "scene/model/road_path.h"

namespace litfog::scene {

/// Things at equal distances along a path, beside it by offset_m (to the right; negative: left).
struct RoadsideRow {
  float offset_m = 5.0f;
  float spacing_m = 25.0f;
  RoadPath path;

  void describe(ParameterList& list, double least_spacing_m) {
    list.add("offset_m", offset_m, -80, 80);
    list.add("spacing_m", spacing_m, least_spacing_m, 500);
    path.describe(list);
  }
};

/// A wooden fence.
struct Fence {
  float height_m = 1.2f;
  int rails = 3;
  int seed = 1;
  RoadsideRow row{.offset_m = 9.0f, .spacing_m = 2.5f, .path = {}};

  void describe(ParameterList& list) {
    list.add("height_m", height_m, 0.4, 3);
    list.add("rails", rails, 1, 6);
    list.add("seed", seed, 0, kMaxSeed);
    row.describe(list, 1);
  }
};
Model make_fence(const Fence& fence);

/// A marker post: white, slanted top, black band, reflectors on both faces (+Z, towards the driver, and -Z).
struct Delineator {
  float height_m = 1.0f;

  void describe(ParameterList& list) { list.add("height_m", height_m, 0.4, 2); }
};
Model make_delineator(const Delineator& delineator);

/// Marker posts on both sides, at +-offset_m.
struct Delineators {
  Delineator post;
  RoadsideRow row;

  void describe(ParameterList& list) {
    post.describe(list);
    row.describe(list, 2);
  }
};
Model make_delineators(const Delineators& delineators);

/// A lamp over the road: its light leaves from (arm_m, height_m - 0.15, 0).
struct StreetLamp {
  float height_m = 7.0f;
  float arm_m = 1.8f;  ///< to +X
  int sodium = 0;      ///< 1: its lens shines orange, 0: white

  void describe(ParameterList& list) {
    list.add("height_m", height_m, 3, 15);
    list.add("arm_m", arm_m, 0.6, 4);
    list.add("sodium", sodium, 0, 1);
  }
};
Model make_street_lamp(const StreetLamp& lamp);

/// A wooden pole with a cross-arm and insulators.
struct UtilityPole {
  float height_m = 8.5f;

  void describe(ParameterList& list) { list.add("height_m", height_m, 4, 15); }
};
Model make_utility_pole(const UtilityPole& pole);

/// A row of utility poles with three sagging wires.
struct PowerLine {
  UtilityPole pole;
  RoadsideRow row{.offset_m = 11.0f, .spacing_m = 45.0f, .path = {}};

  void describe(ParameterList& list) {
    pole.describe(list);
    row.describe(list, 10);
  }
};
Model make_power_line(const PowerLine& line);

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
