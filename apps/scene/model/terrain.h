// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/road_path.h"

namespace litfog::scene {

/// The height of the land, with an optional flat corridor at y = 0 along the path for a road or runway. The same
/// parameters give the same height everywhere, so models that stand on the ground (forest, grass) take them too.
struct Terrain {
  RoadPath path;
  float relief_m = 0.8f;          ///< height of the bumps, about +-
  float bank_m = 0.0f;            ///< how much higher the land is 60 m beside the corridor
  float corridor_m = 0.0f;        ///< full width of the flat part; 0: none
  float corridor_drop_m = 0.12f;  ///< how far the ground lies below y = 0 there, so that a road covers it
  int ground_seed = 1;

  void describe(ParameterList& list) {
    list.add("relief_m", relief_m, 0, 10);
    list.add("bank_m", bank_m, -10, 30);
    list.add("corridor_m", corridor_m, 0, 500);
    list.add("corridor_drop_m", corridor_drop_m, 0, 2);
    list.add("ground_seed", ground_seed, 0, kMaxSeed);
    path.describe(list);
  }
};

float height_at(const Terrain& terrain, float x, float z);

/// A rectangular patch of grass on the terrain.
struct Ground {
  float width_m = 400.0f;
  float depth_m = 400.0f;
  float centre_z_m = 0.0f;  ///< the middle of the patch
  float cell_m = 4.0f;
  Terrain terrain;

  void describe(ParameterList& list) {
    list.add("width_m", width_m, 1, 4000);
    list.add("depth_m", depth_m, 1, 4000);
    list.add("centre_z_m", centre_z_m, -4000, 4000);
    list.add("cell_m", cell_m, 0.25, 100);
    terrain.describe(list);
  }
};
Model make_ground(const Ground& ground);

}  // namespace litfog::scene
