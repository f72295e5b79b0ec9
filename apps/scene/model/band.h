// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/hash_random.h"
#include "scene/model/terrain.h"

namespace litfog::scene {

/// A strip of terrain beside the path on which things are scattered.
struct Band {
  float from_m = 0.0f;  ///< along the path
  float to_m = 150.0f;
  float clear_m = 8.0f;   ///< from the path's middle to the strip
  float reach_m = 30.0f;  ///< width of the strip
  int side = 0;           ///< -1: left only, 1: right only, 0: both
  int seed = 1;
  Terrain terrain;

  void describe(ParameterList& list) {
    list.add("from_m", from_m, -4000, 4000);
    list.add("to_m", to_m, -4000, 4000);
    list.add("clear_m", clear_m, 0, 1000);
    list.add("reach_m", reach_m, 0, 1000);
    list.add("side", side, -1, 1);
    list.add("seed", seed, 0, kMaxSeed);
    terrain.describe(list);
  }
};

/// A point of the strip, on the ground.
glm::vec3 random_point(const Band& band, HashRandom& random);

}  // namespace litfog::scene
