// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/plan/lighting_path.h"
#include "render/plan/paper_settings.h"

namespace litfog::render {

/// Whether the renderer leaves out invisible surfaces and lights: out of view, or out of reach of a surface.
enum class Skipping { on, off };

/// How lamps light the fog.
enum class FogLighting {
  /// As in the papers: carried lights by the fog colour intensity, whatever the depth; other lights only as points.
  peak,
  /// Every light by its airlight along the ray to each pixel. Fog also dims light between lamp and surface.
  airlight,
};

/// By airlight: the orders of scattering that reach the eye.
enum class Scattering {
  single,  ///< light scattered once
  all,     ///< light scattered once or more often, in atmospheres without a find_scattering_error()
};

inline const char* name_of(FogLighting lighting) { return lighting == FogLighting::airlight ? "airlight" : "peak"; }

/// What shadows of lamps and of the directional light darken.
enum class Shadows {
  none,
  surfaces,
  /// Surfaces and airlight. By default, shafts beside a road err by at most 2.5 steps of 1/255
  /// (reference_shadow_test.cpp), because their edges lie between look-ups and between texels.
  shafts,
};

/// How a renderer draws a scene.
struct RenderSettings {
  Skipping skipping = Skipping::on;
  const LightingPath* path = &lighting_paths().front();
  FogLighting fog_lighting = FogLighting::peak;  ///< airlight: only on paths that light each fragment
  Scattering scattering = Scattering::single;
  PaperSettings papers = {};
  int samples = 4;                  ///< least number per pixel: 1, 2, 4 or 8
  bool has_eye_threshold = false;   ///< by airlight: leaves out points of lamps that no eye would see
  Shadows shadows = Shadows::none;  ///< others only on paths that light each fragment
  int shadow_lamps = 8;             ///< at most this many lamps cast shadows: choose_shadow_casters
  int shadow_map_size = 1024;       ///< texels along a side, at least 16
  int shaft_steps = 64;             ///< look-ups of shadow maps along a pixel's ray: 1 to 1024

  friend bool operator==(const RenderSettings&, const RenderSettings&) = default;

  /// The skipping that the path allows.
  Skipping path_skipping() const { return path->pairs_lights ? Skipping::off : skipping; }
};

}  // namespace litfog::render
