// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/primitive.h"

namespace litfog::scene {

/// A house with a pitched roof; its door faces +Z, its ridge runs along X.
struct House {
  float width_m = 10.0f;
  float depth_m = 7.5f;
  int storeys = 1;
  float pitch_deg = 42.0f;
  int brick = 0;     ///< 1: brick walls, 0: plaster
  float lit = 0.5f;  ///< share of windows with light behind them
  int seed = 1;
};
Model make_house(const House& house);

/// Fills an opening of make_wall with a frame, glazing bars, a pane and a sill.
void add_window(Model& model, const Opening& opening, const glm::mat4& model_from_wall, bool lit);

/// Fills one with a panelled door.
void add_door(Model& model, const Opening& opening, const glm::mat4& model_from_wall, std::string_view paint);

}  // namespace litfog::scene
