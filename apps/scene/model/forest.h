// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/terrain.h"

namespace litfog::scene {

/// A strip beside the path on which things are strewn: they stand on the ground, so the ground's parameters belong to
/// it.
struct Band : Ground {
  float from_m = 0.0f;  ///< along the path
  float to_m = 150.0f;
  float clear_m = 8.0f;   ///< nearest to the path's middle
  float reach_m = 30.0f;  ///< from there to the far side of the strip
  int side = 0;           ///< -1: left only, 1: right only, 0: both
  int seed = 1;
};

/// Spruces and broadleaf trees; those far from the path have fewer triangles.
struct Forest : Band {
  int trees = 60;
  float spacing_m = 2.5f;  ///< kept between trunks where there is room
  float least_height_m = 6.0f;
  float most_height_m = 13.0f;
  float broadleaf = 0.15f;  ///< share
  float leaves = 0.5f;      ///< on the broadleaf trees
};
Model make_forest(const Forest& forest);

/// Blades of grass in tufts.
struct Grass : Band {
  int tufts = 1500;
  int blades = 7;  ///< a tuft
  float height_m = 0.3f;
};
Model make_grass(const Grass& grass);

struct Rocks : Band {
  int rocks = 20;
  float least_size_m = 0.15f;
  float most_size_m = 0.7f;
};
Model make_rocks(const Rocks& rocks);

}  // namespace litfog::scene
