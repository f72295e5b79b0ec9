// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace litfog::render {

/// How the cube map of a light's cone covers its angles, in paths with light maps (light_map.h).
enum class ConeMaps {
  scaled,    ///< every cone below 90 degrees spans one face, as in the papers
  even,      ///< cones wider than 60 degrees extend over all faces, where texels are more even
  one_disc,  ///< one white disc, scaled to every angle below 90 degrees, as Frazier's spot light
};

/// The edge of a dual cone in the path `cg` (Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", 5.5.2).
enum class SpotEdge { hard, lerp, smoothstep };

/// How hidden fragments of surfaces are rejected before they are shaded (Jason Lacroix 2005, "Let There Be Light!",
/// "Early rejection is key"), on paths of one pass. `litfog-bench rejection` compares them.
enum class EarlyRejection {
  none,           ///< surfaces in the order of their materials, so that OpenGL changes its state least
  front_to_back,  ///< surfaces in the order of their nearest points; may show another one of coplanar surfaces
  depth_pass,     ///< first the depths of all surfaces without masks, then shading of what passes, as by `none`
};

/// Settings that only re-enact a paper's listing, figure or exercise.
struct PaperSettings {
  /// Hales's paths: directional light by face normals instead of vertex normals (his flat and smooth shading).
  bool is_flat_shaded = false;
  double light_ambient = 0;          ///< Hales's paths: a light's ambient colour as a fraction of its colour, [0, 1]
  bool has_infinite_viewer = false;  ///< Basic model: highlights as seen from infinity along the camera's axis
  int map_size = 128;                ///< texels along a side of the light maps
  ConeMaps cone_maps = ConeMaps::scaled;
  SpotEdge spot_edge = SpotEdge::smoothstep;
  EarlyRejection early_rejection = EarlyRejection::none;

  friend bool operator==(const PaperSettings&, const PaperSettings&) = default;
};

}  // namespace litfog::render
