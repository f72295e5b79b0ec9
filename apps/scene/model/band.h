// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/hash_random.h"
#include "scene/mesh.h"
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

/// Spruces and broadleaf trees; those far from the path have fewer triangles.
struct Forest {
  int trees = 60;
  float spacing_m = 2.5f;  ///< kept between trunks if there is room
  float least_height_m = 6.0f;
  float most_height_m = 13.0f;
  float broadleaf = 0.15f;  ///< fraction of the trees
  float leaves = 0.5f;      ///< on the broadleaf trees
  Band band;

  void describe(ParameterList& list) {
    list.add("trees", trees, 0, 300);
    list.add("spacing_m", spacing_m, 0, 20);
    list.add("least_height_m", least_height_m, 1, 40);
    list.add("most_height_m", most_height_m, 1, 40);
    list.add("broadleaf", broadleaf, 0, 1);
    list.add("leaves", leaves, 0, 1);
    band.describe(list);
  }
};
Model make_forest(const Forest& forest);

/// Blades of grass in tufts.
struct Grass {
  int tufts = 1500;
  int blades = 7;  ///< per tuft
  float height_m = 0.3f;
  Band band;

  void describe(ParameterList& list) {
    list.add("tufts", tufts, 0, 20000);
    list.add("blades", blades, 1, 16);
    list.add("height_m", height_m, 0.03, 2);
    band.describe(list);
  }
};
Model make_grass(const Grass& grass);

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
