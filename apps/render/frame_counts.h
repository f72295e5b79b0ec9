// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace litfog::render {

/// How a frame's sky is drawn.
enum class SkyDrawing {
  sky,         ///< through the fog
  fog,         ///< as fog alone, lit by carried lights, because fog hides the sky
  background,  ///< not at all: fog of one colour hides it
};

/// What a frame drew, and what it left out for which reason.
struct FrameCounts {
  std::size_t chunks_drawn = 0;
  std::size_t chunks_as_fog = 0;  ///< hidden by fog, but drawn as fog alone for what is seen before and behind them
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
  std::size_t airlights_hidden = 0;  ///< by fog
  SkyDrawing sky = SkyDrawing::sky;
  std::size_t bytes_uploaded = 0;  ///< lights, light lists and what is passed for each draw
};

}  // namespace litfog::render
