// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

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
