// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace litfog::render {

/// How a frame draws the sky.
enum class SkyDrawing {
  sky,         ///< through the fog
  fog,         ///< as fog alone, lit by carried lights, because fog hides the sky
  background,  ///< not at all: fog of one colour hides it
};

/// What a frame drew, and what it left out and why.
struct FrameCounts {
  std::size_t chunks_drawn = 0;
  std::size_t chunks_as_fog = 0;  ///< hidden by fog, but drawn as fog alone, because they hide what is behind them
  std::size_t chunks_outside_view = 0;
  std::size_t chunks_hidden = 0;  ///< by fog, and not drawn
  // Pairs of a drawn chunk and a light that is neither off nor at extent 0.
  std::size_t lights_listed = 0;
  std::size_t lights_out_of_reach = 0;
  std::size_t lights_hidden = 0;  ///< by fog
  // Points of local lights.
  std::size_t points_drawn = 0;
  std::size_t points_outside_view = 0;
  std::size_t points_hidden = 0;  ///< by fog, distance or cone
  // Airlight of lights.
  std::size_t airlights_drawn = 0;
  std::size_t airlights_invisible = 0;  ///< hidden by fog, or without fog to light
  std::size_t shadow_maps_drawn = 0;    ///< all in the first frame, then the moon's when the view has changed
  SkyDrawing sky = SkyDrawing::sky;
  std::size_t bytes_uploaded = 0;  ///< light lists when the view has changed, and uniforms of draw calls
};

/// A scene's lights, counted by how a frame uses them.
struct LightCounts {
  std::size_t off = 0;           ///< black lights, and local lights of extent 0
  std::size_t drawn = 0;         ///< on a surface, as a point or as airlight
  std::size_t hidden = 0;        ///< by fog or distance; so is all in view that they reach
  std::size_t outside_view = 0;  ///< so is all that they reach
  std::size_t out_of_reach = 0;  ///< outside the view, and too far from all surfaces
};

/// Wall time of each stage, milliseconds, measured by waiting for the GPU after each.
struct StageTimes {
  double plan = 0;  ///< choosing what to draw, on the CPU
  double surfaces = 0;
  double sky = 0;
  double points = 0;
  double panes = 0;
  double resolve = 0;  ///< averaging each pixel's samples
  double airlight = 0;
};

/// Statistics of one frame (Renderer::draw_and_measure).
struct FrameStatistics {
  FrameCounts counts;
  LightCounts lights;
  StageTimes times;
  /// Mean over visible surfaces; a surface that fog hides counts as 0.
  double lights_per_fragment = 0;
  std::size_t fog_bytes_uploaded = 0;  ///< by the last change of the fog
};

}  // namespace litfog::render
