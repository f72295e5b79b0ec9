// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"

namespace litfog::scene {

// Lights of an airfield face +Z, towards who approaches looking along -Z.

/// One box of a precision approach path indicator; its light leaves from (0, 0.55, 0.42).
struct PapiBox {
  int white = 1;  ///< 1: seen white, 0: red
};
Model make_papi_box(const PapiBox& box);

/// Lamps on a bar on a frangible mast; their light leaves from height_m.
struct ApproachLight {
  float height_m = 2.0f;
  int lamps = 5;
  float spacing_m = 1.0f;
  int red = 0;  ///< 1: red, for side rows
};
Model make_approach_light(const ApproachLight& light);

/// An elevated runway edge light; its light leaves from (0, 0.33, 0).
struct EdgeLight {
  int red = 0;  ///< 1: red, for the end of the runway
};
Model make_edge_light(const EdgeLight& light);

/// An arched hangar, its doors to +Z, its front wall at z = 0.
struct Hangar {
  float width_m = 26.0f;
  float depth_m = 32.0f;
  float height_m = 9.0f;
  int lit = 1;  ///< windows and the lamps over the doors
};
Model make_hangar(const Hangar& hangar);

/// A control tower.
struct Tower {
  float height_m = 18.0f;
  int lit = 1;
};
Model make_tower(const Tower& tower);

}  // namespace litfog::scene
