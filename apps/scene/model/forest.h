// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/band.h"

namespace litfog::scene {

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

}  // namespace litfog::scene
