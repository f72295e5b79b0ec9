// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

/// A parked hatchback of 4.3 m. It faces -Z, so a viewer who looks along -Z sees its back.
struct Car {
  int paint = 0;   ///< index in kCarPaints
  int lights = 0;  ///< 1: tail lamps and headlamps are on
  int number = 47;

  void describe(ParameterList& list) {
    list.add("paint", paint, 0, 4);
    list.add("lights", lights, 0, 1);
    list.add("number", number, 0, 99);
  }
};
inline constexpr std::string_view kCarPaints[] = {"paint_blue", "paint_red", "paint_white", "paint_grey",
                                                  "paint_green"};
Model make_car(const Car& car);

}  // namespace litfog::scene
