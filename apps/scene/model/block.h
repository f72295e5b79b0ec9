// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

/// A block of concrete.
struct Block {
  float width_m = 1.0f;
  float height_m = 1.0f;
  float depth_m = 1.0f;
  float bevel_m = 0.0f;  ///< cut off its edges, at most 0.45 of the smallest side

  void describe(ParameterList& list) {
    list.add("width_m", width_m, 0.01, 1000);
    list.add("height_m", height_m, 0.01, 1000);
    list.add("depth_m", depth_m, 0.01, 1000);
    list.add("bevel_m", bevel_m, 0, 1);
  }
};
Model make_block(const Block& block);

}  // namespace litfog::scene
