// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/band.h"

namespace litfog::scene {

/// A boulder, sunk a little into the ground.
struct Rock {
  float size_m = 0.8f;
  int seed = 1;

  void describe(ParameterList& list) {
    list.add("size_m", size_m, 0.05, 10);
    list.add("seed", seed, 0, kMaxSeed);
  }
};
Model make_rock(const Rock& rock);

/// Boulders, the small ones more frequent.
struct Rocks {
  int rocks = 20;
  float least_size_m = 0.15f;
  float most_size_m = 0.7f;
  Band band;

  void describe(ParameterList& list) {
    list.add("rocks", rocks, 0, 200);
    list.add("least_size_m", least_size_m, 0.05, 10);
    list.add("most_size_m", most_size_m, 0.05, 10);
    band.describe(list);
  }
};
Model make_rocks(const Rocks& rocks);

}  // namespace litfog::scene
