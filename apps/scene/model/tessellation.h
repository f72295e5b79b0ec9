// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"
#include "scene/model/parameter_list.h"

namespace litfog::scene {

// One shape in finer and finer triangles, which lighting at the vertices needs (Randima Fernando and Mark Kilgard 2003,
// "The Cg Tutorial", figure 5-16).

/// A square wall standing on y = 0, facing +Z, of cells x cells squares.
struct Panel {
  float size_m = 2.0f;
  int cells = 1;
  int wire = 0;  ///< 1: only the edges of its triangles

  void describe(ParameterList& list) {
    list.add("size_m", size_m, 0.1, 100);
    list.add("cells", cells, 1, 256);
    list.add("wire", wire, 0, 1);
  }
};
Model make_panel_model(const Panel& panel);

/// An upright cylinder without lids, standing on y = 0.
struct Drum {
  float radius_m = 0.75f;
  float height_m = 2.0f;
  int segments = 8;
  int rings = 1;
  int wire = 0;  ///< 1: only the edges of its triangles

  void describe(ParameterList& list) {
    list.add("radius_m", radius_m, 0.1, 50);
    list.add("height_m", height_m, 0.1, 100);
    list.add("segments", segments, 3, 256);
    list.add("rings", rings, 1, 256);
    list.add("wire", wire, 0, 1);
  }
};
Model make_drum_model(const Drum& drum);

}  // namespace litfog::scene
