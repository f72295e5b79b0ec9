// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

/// A room seen from inside, after the "room with a curved ceiling" of Ronald Frazier 2000, "Real-Time Per-Pixel Point
/// Lights and Spot Lights in OpenGL": a barrel vault with ribs along Z, piers and niches at the sides, a door in the
/// wall at -Z. The floor is y = 0, its middle the origin.
struct Room {
  float width_m = 7.0f;
  float depth_m = 11.0f;
  float wall_m = 2.6f;  ///< height of the walls, at which the vault starts
  float rise_m = 1.7f;  ///< height of the vault over the walls
  int bays = 4;         ///< between the ribs

  void describe(ParameterList& list) {
    list.add("width_m", width_m, 3, 30);
    list.add("depth_m", depth_m, 4, 60);
    list.add("wall_m", wall_m, 2.4, 10);
    list.add("rise_m", rise_m, 0.3, 10);
    list.add("bays", bays, 1, 40);
  }
};
Model make_room(const Room& room);

}  // namespace litfog::scene
