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
