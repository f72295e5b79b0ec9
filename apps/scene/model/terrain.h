// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/path.h"

namespace litfog::scene {

/// A flat strip at y = 0 that the ground leaves free for a road or runway. Starts at the origin.
struct Corridor : Path {
  float corridor_m = 0.0f;        ///< full width of the flat part; 0: none
  float corridor_drop_m = 0.12f;  ///< how far the ground lies below y = 0 there, so that a road covers it
};

/// Ground in the middle of which, at (0, 0), a road may start. Same parameters, same height everywhere: things placed
/// on it (forest, grass) take them too.
struct Ground : Corridor {
  float width_m = 400.0f;
  float depth_m = 400.0f;
  float centre_z_m = 0.0f;  ///< the middle of the patch
  float cell_m = 4.0f;
  float relief_m = 0.8f;  ///< height of the bumps, about +-
  float bank_m = 0.0f;    ///< how much higher the land is 60 m beside the corridor
  int ground_seed = 1;
};

float ground_height(const Ground& ground, float x, float z);
Model make_ground(const Ground& ground);

struct Road : Path {
  float width_m = 7.0f;
  float shoulder_m = 1.2f;  ///< gravel beside the asphalt; below it a verge falls off into the ground
  float camber = 0.025f;    ///< slope from the crown to either edge
};

/// Height of the road's surface over the path, `offset` metres from the middle (asphalt only).
float road_height(const Road& road, float offset);
Model make_road(const Road& road);

struct RoadMarkings : Road {
  float dash_m = 3.0f;
  float gap_m = 6.0f;  ///< 0: a solid centre line
  float line_m = 0.12f;
  float lift_m = 0.012f;
};
Model make_road_markings(const RoadMarkings& markings);

/// Adds paint: a strip of the given width `lift` over the road.
void add_stripe(Mesh& mesh, const Road& road, float from, float to, float offset, float width, float lift);

}  // namespace litfog::scene
