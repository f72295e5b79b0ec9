// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

// Lights of an airfield face +Z, towards a pilot who approaches along -Z.

/// One box of a precision approach path indicator; its light leaves from (0, 0.55, 0.42).
struct PapiBox {
  int white = 1;  ///< 1: seen white, 0: seen red

  void describe(ParameterList& list) { list.add("white", white, 0, 1); }
};
Model make_papi_box(const PapiBox& box);

/// Lamps on a bar on a frangible mast; their light leaves from height_m.
struct ApproachLight {
  float height_m = 2.0f;
  int lamps = 5;
  float spacing_m = 1.0f;
  int red = 0;  ///< 1: red lenses, for side rows

  void describe(ParameterList& list) {
    list.add("height_m", height_m, 0.4, 30);
    list.add("lamps", lamps, 1, 11);
    list.add("spacing_m", spacing_m, 0.3, 5);
    list.add("red", red, 0, 1);
  }
};
Model make_approach_light(const ApproachLight& light);

/// An elevated runway edge light; its light leaves from (0, 0.33, 0).
struct EdgeLight {
  int red = 0;  ///< 1: red, for the end of the runway

  void describe(ParameterList& list) { list.add("red", red, 0, 1); }
};
Model make_edge_light(const EdgeLight& light);

/// An arched hangar, its doors to +Z, its front wall at z = 0.
struct Hangar {
  float width_m = 26.0f;
  float depth_m = 32.0f;
  float height_m = 9.0f;
  int lit = 1;  ///< windows and the lamps over the doors

  void describe(ParameterList& list) {
    list.add("width_m", width_m, 8, 80);
    list.add("depth_m", depth_m, 5, 120);
    list.add("height_m", height_m, 4, 25);
    list.add("lit", lit, 0, 1);
  }
};
Model make_hangar(const Hangar& hangar);

/// A control tower.
struct Tower {
  float height_m = 18.0f;
  int lit = 1;

  void describe(ParameterList& list) {
    list.add("height_m", height_m, 10, 60);
    list.add("lit", lit, 0, 1);
  }
};
Model make_tower(const Tower& tower);

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
