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

struct Crate {
  float size_m = 0.8f;

  void describe(ParameterList& list) { list.add("size_m", size_m, 0.2, 3); }
};
Model make_crate(const Crate& crate);

struct Barrel {
  float height_m = 0.9f;

  void describe(ParameterList& list) { list.add("height_m", height_m, 0.3, 3); }
};
Model make_barrel(const Barrel& barrel);

struct DiningTable {
  float length_m = 1.8f;
  float width_m = 0.85f;
  float height_m = 0.75f;

  void describe(ParameterList& list) {
    list.add("length_m", length_m, 0.5, 5);
    list.add("width_m", width_m, 0.4, 2);
    list.add("height_m", height_m, 0.4, 1.2);
  }
};
Model make_dining_table(const DiningTable& table);

/// Its back is at +Z: a person on it looks along -Z.
struct Chair {
  float seat_m = 0.45f;

  void describe(ParameterList& list) { list.add("seat_m", seat_m, 0.3, 0.8); }
};
Model make_chair(const Chair& chair);

/// An open shelf with books, its front at +Z, its back at z = 0.
struct Shelf {
  float width_m = 1.0f;
  float height_m = 1.9f;
  float books = 0.8f;  ///< fraction of each board that is filled
  int seed = 1;

  void describe(ParameterList& list) {
    list.add("width_m", width_m, 0.4, 4);
    list.add("height_m", height_m, 0.6, 3);
    list.add("books", books, 0, 1);
    list.add("seed", seed, 0, kMaxSeed);
  }
};
Model make_shelf(const Shelf& shelf);

}  // namespace litfog::scene
