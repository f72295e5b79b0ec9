// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

/// A spruce: whorls of drooping branches, long below and short above, with hanging twigs; no two alike.
struct Spruce {
  float height_m = 9.0f;
  float spread = 0.22f;  ///< radius of the lowest branches as a fraction of the height
  float bare = 0.06f;    ///< fraction of the trunk without branches
  int whorls = 18;
  int branches = 7;  ///< per whorl
  int twigs = 6;     ///< per side of a branch
  int seed = 1;

  void describe(ParameterList& list) {
    list.add("height_m", height_m, 1, 40);
    list.add("spread", spread, 0.1, 0.5);
    list.add("bare", bare, 0, 0.6);
    list.add("whorls", whorls, 4, 40);
    list.add("branches", branches, 3, 12);
    list.add("twigs", twigs, 2, 8);
    list.add("seed", seed, 0, kMaxSeed);
  }
};
Model make_spruce(const Spruce& spruce);

}  // namespace litfog::scene
