// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

/// A house with a pitched roof; its door faces +Z, its ridge runs along X.
struct House {
  float width_m = 10.0f;
  float depth_m = 7.5f;
  int storeys = 1;
  float pitch_deg = 42.0f;
  int brick = 0;     ///< 1: brick walls, 0: plaster
  float lit = 0.5f;  ///< fraction of windows with light behind them
  int seed = 1;

  void describe(ParameterList& list) {
    list.add("width_m", width_m, 4, 40);
    list.add("depth_m", depth_m, 4, 20);
    list.add("storeys", storeys, 1, 4);
    list.add("pitch_deg", pitch_deg, 15, 60);
    list.add("brick", brick, 0, 1);
    list.add("lit", lit, 0, 1);
    list.add("seed", seed, 0, kMaxSeed);
  }
};
Model make_house(const House& house);

/// A flat-roofed town house with windows on all sides; shops on its front, towards +Z.
struct ApartmentHouse {
  float width_m = 22.0f;
  float depth_m = 14.0f;
  int storeys = 6;   ///< over the ground floor
  int brick = 0;     ///< 1: brick walls, 0: plaster
  float lit = 0.5f;  ///< fraction of windows with light behind them
  int seed = 1;

  void describe(ParameterList& list) {
    list.add("width_m", width_m, 6, 60);
    list.add("depth_m", depth_m, 6, 60);
    list.add("storeys", storeys, 1, 30);
    list.add("brick", brick, 0, 1);
    list.add("lit", lit, 0, 1);
    list.add("seed", seed, 0, kMaxSeed);
  }
};
Model make_apartment_house(const ApartmentHouse& house);

/// Where light leaves a house: the middle of a bright pane.
struct BrightPane {
  glm::vec3 position;
  glm::vec3 normal;  ///< out of the house
  bool is_shop;
};
/// The bright panes of the model with the same parameters.
std::vector<BrightPane> bright_panes(const ApartmentHouse& house);

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
