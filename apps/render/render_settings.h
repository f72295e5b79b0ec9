// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/lighting_path.h"

namespace litfog::render {

/// Whether the renderer leaves out what cannot be visible: surfaces out of view, lights out of reach of a surface.
enum class Skipping { on, off };

/// How a renderer draws a scene.
struct RenderSettings {
  Skipping skipping = Skipping::on;
  const LightingPath* path = &lighting_paths().front();
  /// Hales's paths shade the directional light by the faces' normals, else by the vertices' (his flat and smooth
  /// shading).
  bool is_flat_shaded = false;
  bool has_infinite_viewer = false;  ///< the Basic model's highlights as seen from far away along the camera's axis
  int map_size = 128;                ///< texels a side of the light maps
};

}  // namespace litfog::render
