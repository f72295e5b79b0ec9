// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

/// A broadleaf tree: a forking trunk, and leaves in sprays at the ends of its twigs.
struct BroadleafTree {
  float height_m = 7.0f;
  float spread = 0.55f;  ///< reach of the lowest boughs as a fraction of the height
  float leaves = 0.7f;   ///< 0: bare as in winter, 1: full summer
  float leaf_m = 0.16f;  ///< length of a spray
  int forks = 3;         ///< levels of forks from the stem to the twigs; 2 suits trees far away
  int seed = 1;

  void describe(ParameterList& list) {
    list.add("height_m", height_m, 1, 30);
    list.add("spread", spread, 0.2, 1);
    list.add("leaves", leaves, 0, 1);
    list.add("leaf_m", leaf_m, 0.05, 0.5);
    list.add("forks", forks, 2, 3);
    list.add("seed", seed, 0, kMaxSeed);
  }
};
Model make_broadleaf_tree(const BroadleafTree& tree);

/// A broadleaf without a trunk: stems from the ground.
struct Bush {
  float height_m = 1.4f;
  float leaves = 0.8f;
  float leaf_m = 0.11f;
  int stems = 7;
  int seed = 1;

  void describe(ParameterList& list) {
    list.add("height_m", height_m, 0.3, 4);
    list.add("leaves", leaves, 0, 1);
    list.add("leaf_m", leaf_m, 0.05, 0.5);
    list.add("stems", stems, 1, 16);
    list.add("seed", seed, 0, kMaxSeed);
  }
};
Model make_bush(const Bush& bush);

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
