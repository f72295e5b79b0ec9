// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/band.h"

namespace litfog::scene {

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

}  // namespace litfog::scene
