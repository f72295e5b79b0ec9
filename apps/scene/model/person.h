// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

/// A person in a coat and a hat, facing -Z.
struct Person {
  float height_m = 1.75f;
  int coat = 0;   ///< index in kCarPaints
  int walks = 0;  ///< 1: in mid-step, 0: standing

  void describe(ParameterList& list) {
    list.add("height_m", height_m, 0.9, 2.1);
    list.add("coat", coat, 0, 4);
    list.add("walks", walks, 0, 1);
  }
};
Model make_person(const Person& person);

}  // namespace litfog::scene
