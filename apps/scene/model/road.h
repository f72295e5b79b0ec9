// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/road_path.h"

namespace litfog::scene {

/// The asphalt that a road and its markings share: highest along the path, sloping to both edges at y = 0.
struct Carriageway {
  float width_m = 7.0f;
  float camber = 0.025f;  ///< slope from the crown to either edge
  RoadPath path;

  void describe(ParameterList& list) {
    list.add("width_m", width_m, 3, 20);
    list.add("camber", camber, 0, 0.08);
    path.describe(list);
  }
};

/// Height of the asphalt `offset` metres beside the path.
float height_at(const Carriageway& carriageway, float offset);

struct Road {
  float shoulder_m = 1.2f;  ///< gravel beside the asphalt; below it a verge falls off into the ground
  int wet = 0;              ///< 1: rain stands on the asphalt and mirrors the lamps
  Carriageway carriageway;

  void describe(ParameterList& list) {
    list.add("shoulder_m", shoulder_m, 0.2, 5);
    list.add("wet", wet, 0, 1);
    carriageway.describe(list);
  }
};
Model make_road(const Road& road);

/// Edge lines and a dashed centre line.
struct RoadMarkings {
  float dash_m = 3.0f;
  float gap_m = 6.0f;  ///< 0: a solid centre line
  float line_m = 0.12f;
  float lift_m = 0.012f;  ///< height of the paint over the asphalt
  Carriageway carriageway;

  void describe(ParameterList& list) {
    list.add("dash_m", dash_m, 1, 30);
    list.add("gap_m", gap_m, 0, 30);
    list.add("line_m", line_m, 0.05, 0.5);
    list.add("lift_m", lift_m, 0.002, 0.1);
    carriageway.describe(list);
  }
};
Model make_road_markings(const RoadMarkings& markings);

/// The bars of a pedestrian crossing over a level road along Z, from x = -width_m / 2 to width_m / 2.
struct ZebraCrossing {
  float width_m = 7.0f;
  float length_m = 4.0f;  ///< length of the bars, along the road
  float bar_m = 0.5f;     ///< width of a bar and of the gap to the next
  float lift_m = 0.012f;

  void describe(ParameterList& list) {
    list.add("width_m", width_m, 3, 30);
    list.add("length_m", length_m, 1, 10);
    list.add("bar_m", bar_m, 0.2, 1);
    list.add("lift_m", lift_m, 0.002, 0.1);
  }
};
Model make_zebra_crossing(const ZebraCrossing& crossing);

}  // namespace litfog::scene
