// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/plan/lighting_path.h"

namespace litfog::render {

/// Whether the renderer leaves out what cannot be visible: surfaces out of view, lights out of reach of a surface.
enum class Skipping { on, off };

/// How lamps light the fog.
enum class FogLighting {
  /// The papers' way: carried lights by the fog colour intensity, whatever the depth; others are seen as points only.
  peak,
  /// Every light by its airlight along the ray to each pixel. The fog dims lights on their way from the lamp, too.
  airlight,
};

inline const char* name_of(FogLighting lighting) { return lighting == FogLighting::airlight ? "airlight" : "peak"; }

/// What the shadows of lamps, and of the directional light, darken.
enum class Shadows {
  none,
  surfaces,
  /// Surfaces, and the fog that lamps' airlight lights. As drawn by default, shafts err by at most 2.5 steps of 1/255
  /// beside a road (reference_shadow_test.cpp): their edges lie between look-ups and between texels.
  shafts,
};

/// How the cube map of a light's cone covers its angles, in paths with light maps (light_map.h).
enum class ConeMaps {
  scaled,    ///< every cone below 90 degrees spans one face, as in the papers
  even,      ///< cones wider than 60 degrees extend over all faces, whose texels are evener
  one_disc,  ///< one white disc for every angle below 90 degrees by scale alone, as Frazier's spot light has it
};

/// The edge of a dual cone in the path `cg` (Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", 5.5.2).
enum class SpotEdge { hard, lerp, smoothstep };

/// How a renderer draws a scene.
struct RenderSettings {
  Skipping skipping = Skipping::on;
  const LightingPath* path = &lighting_paths().front();
  FogLighting fog_lighting = FogLighting::peak;  ///< airlight: with paths that light each fragment only
  /// Hales's paths shade the directional light by the faces' normals, else by the vertices' (his flat and smooth
  /// shading).
  bool is_flat_shaded = false;
  double light_ambient = 0;          ///< Hales's paths: a light's ambient colour as a fraction of its colour, [0, 1]
  bool has_infinite_viewer = false;  ///< the Basic model's highlights as seen from far away along the camera's axis
  int map_size = 128;                ///< texels a side of the light maps
  ConeMaps cone_maps = ConeMaps::scaled;
  SpotEdge spot_edge = SpotEdge::smoothstep;
  int samples = 4;                  ///< a pixel, at least: 1, 2, 4 or 8
  Shadows shadows = Shadows::none;  ///< others: with paths that light each fragment only
  int shadow_lamps = 8;             ///< that cast them, at most: choose_shadow_casters
  int shadow_map_size = 1024;       ///< texels a side, at least 16
  int shaft_steps = 64;             ///< along a pixel's ray, at which shadow maps are looked up: 1 to 1024

  friend bool operator==(const RenderSettings&, const RenderSettings&) = default;

  /// What the path allows of skipping.
  Skipping path_skipping() const { return path->pairs_lights ? Skipping::off : skipping; }
};

}  // namespace litfog::render
