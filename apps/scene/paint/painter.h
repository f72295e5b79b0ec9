// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/paint/field.h"

namespace litfog::scene {

/// The values that a painter sets per texel: height (metres; normals are computed from it), linear colour and gloss.
struct Canvas {
  Canvas(int texels, float metres)
      : size(texels), size_m(metres), height(texels), gloss(texels, 1.0f), color(height.texels(), glm::vec3(1.0f)) {}
  int size;
  float size_m;
  Field height;
  Field gloss;  ///< [0, 1]
  std::vector<glm::vec3> color;

  float texel_m() const { return size_m / float(size); }
};

// Painters of surfaces. Colours need only be right relative to each other: make_material (material_catalogue.h) scales
// each channel to the material's mean albedo. Every painter gives the same texels each time.

// painter_ground.cpp
void paint_asphalt(Canvas& canvas);
void paint_wet_asphalt(Canvas& canvas);
void paint_runway(Canvas& canvas);
void paint_road_paint(Canvas& canvas);
void paint_grass(Canvas& canvas);
void paint_gravel(Canvas& canvas);
void paint_concrete_slabs(Canvas& canvas);
void paint_water(Canvas& canvas);

// painter_building.cpp
void paint_concrete(Canvas& canvas);
void paint_brick(Canvas& canvas);
void paint_plaster(Canvas& canvas);
void paint_wood_floor(Canvas& canvas);
void paint_wood(Canvas& canvas);
void paint_roof_tiles(Canvas& canvas);
void paint_stone(Canvas& canvas);
void paint_corrugated(Canvas& canvas);

// painter_plant.cpp
void paint_bark(Canvas& canvas);
void paint_needles(Canvas& canvas);
void paint_leaves(Canvas& canvas);
void paint_blades(Canvas& canvas);

// painter_plain.cpp: paints, metals, glass, rubber, lamps
void paint_painted(Canvas& canvas);
void paint_galvanised(Canvas& canvas);
void paint_smooth(Canvas& canvas);
void paint_rubber(Canvas& canvas);
void paint_prisms(Canvas& canvas);

}  // namespace litfog::scene
