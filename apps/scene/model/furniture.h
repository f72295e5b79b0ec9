// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"

namespace litfog::scene {

struct Crate {
  float size_m = 0.8f;
};
Model make_crate(const Crate& crate);

struct Barrel {
  float height_m = 0.9f;
};
Model make_barrel(const Barrel& barrel);

struct Table {
  float length_m = 1.8f;
  float width_m = 0.85f;
  float height_m = 0.75f;
};
Model make_table(const Table& table);

/// Its back is at +Z: who sits on it looks along -Z.
struct Chair {
  float seat_m = 0.45f;
};
Model make_chair(const Chair& chair);

/// An open shelf with books, its front at +Z, its back at z = 0.
struct Shelf {
  float width_m = 1.0f;
  float height_m = 1.9f;
  float books = 0.8f;  ///< share of each board that is filled
  int seed = 1;
};
Model make_shelf(const Shelf& shelf);

}  // namespace litfog::scene
