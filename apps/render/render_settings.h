// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/plan/lighting_path.h"

namespace litfog::render {

/// Whether the renderer leaves out what is invisible: surfaces out of view, lights out of a surface's reach.
enum class Skipping { on, off };

/// How lamps light the fog.
enum class FogLighting {
  /// As in the papers: carried lights by the fog colour intensity, whatever the depth; other lights only as points.
  peak,
  /// Every light by its airlight along the ray to each pixel. Fog also dims light between lamp and surface.
  airlight,
};

inline const char* name_of(FogLighting lighting) { return lighting == FogLighting::airlight ? "airlight" : "peak"; }

/// What the shadows of lamps and of the directional light darken.
enum class Shadows {
  none,
  surfaces,
  /// Surfaces and airlight. By default, shafts beside a road err by at most 2.5 steps of 1/255
  /// (reference_shadow_test.cpp), because their edges lie between look-ups and between texels.
  shafts,
};

/// How the cube map of a light's cone covers its angles, in paths with light maps (light_map.h).
enum class ConeMaps {
  scaled,    ///< every cone below 90 degrees spans one face, as in the papers
  even,      ///< cones wider than 60 degrees extend over all faces, where texels are more even
  one_disc,  ///< one white disc, scaled to every angle below 90 degrees, as Frazier's spot light
};

/// The edge of a dual cone in the path `cg` (Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", 5.5.2).
enum class SpotEdge { hard, lerp, smoothstep };

/// How a renderer draws a scene.
struct RenderSettings {
  Skipping skipping = Skipping::on;
  const LightingPath* path = &lighting_paths().front();
  FogLighting fog_lighting = FogLighting::peak;  ///< airlight: only on paths that light each fragment
  /// Hales's paths: directional light by face normals instead of vertex normals (his flat and smooth shading).
  bool is_flat_shaded = false;
  double light_ambient = 0;          ///< Hales's paths: a light's ambient colour as a fraction of its colour, [0, 1]
  bool has_infinite_viewer = false;  ///< Basic model: highlights as seen from infinity along the camera's axis
  int map_size = 128;                ///< texels a side of the light maps
  ConeMaps cone_maps = ConeMaps::scaled;
  SpotEdge spot_edge = SpotEdge::smoothstep;
  int samples = 4;                  ///< a pixel, at least: 1, 2, 4 or 8
  Shadows shadows = Shadows::none;  ///< others: only on paths that light each fragment
  int shadow_lamps = 8;             ///< at most this many lamps cast shadows: choose_shadow_casters
  int shadow_map_size = 1024;       ///< texels a side, at least 16
  int shaft_steps = 64;             ///< look-ups of shadow maps along a pixel's ray: 1 to 1024

  friend bool operator==(const RenderSettings&, const RenderSettings&) = default;

  /// The skipping that the path allows.
  Skipping path_skipping() const { return path->pairs_lights ? Skipping::off : skipping; }
};

}  // namespace litfog::render
