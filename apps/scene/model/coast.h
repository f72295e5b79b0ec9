// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

/// Open water at y = 0. Its waves are those of its material.
struct Sea {
  float width_m = 2000.0f;
  float depth_m = 2000.0f;

  void describe(ParameterList& list) {
    list.add("width_m", width_m, 10, 20'000);
    list.add("depth_m", depth_m, 10, 20'000);
  }
};
Model make_sea(const Sea& sea);

/// A rocky island with grass on its top. The sea is at y = 0; the middle, level out to flat_m, is at height_m.
struct Island {
  float radius_m = 60.0f;  ///< about, of its foot
  float height_m = 8.0f;
  float flat_m = 10.0f;
  float relief_m = 2.0f;  ///< height of the crags, about +-
  int seed = 1;

  void describe(ParameterList& list) {
    list.add("radius_m", radius_m, 10, 500);
    list.add("height_m", height_m, 1, 60);
    list.add("flat_m", flat_m, 1, 100);
    list.add("relief_m", relief_m, 0, 10);
    list.add("seed", seed, 0, kMaxSeed);
  }
};
Model make_island(const Island& island);

/// A round white tower with a red band, its door to +Z; its light leaves from (0, height_m, 0), in an open lantern.
struct Lighthouse {
  float height_m = 25.0f;
  int lit = 1;  ///< the lens and the windows

  void describe(ParameterList& list) {
    list.add("height_m", height_m, 8, 60);
    list.add("lit", lit, 0, 1);
  }
};
Model make_lighthouse(const Lighthouse& lighthouse);

}  // namespace litfog::scene
