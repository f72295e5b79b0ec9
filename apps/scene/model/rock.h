// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"

namespace litfog::scene {

/// A boulder, sunk a little into the ground.
struct Rock {
  float size_m = 0.8f;
  int seed = 1;
};
Model make_rock(const Rock& rock);

}  // namespace litfog::scene
