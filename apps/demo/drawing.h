// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "demo/drawing_options.h"
#include "litfog/fog.h"
#include "measure/comparison.h"
#include "measure/frame_times.h"
#include "scene/scene.h"

namespace litfog::demo {

/// A scene drawn once or several times, and what there is to know about it.
struct Drawn {
  render::Picture picture;
  double visibility;  ///< metres
  measure::FrameTimes times;
  std::size_t shadow_lamps;  ///< that cast shadows, and their maps
  std::size_t shadow_maps;
  std::optional<measure::Comparison> comparison;  ///< with the reference, if asked for
  int samples;                                    ///< a pixel
  std::string gl_renderer;
  std::string gl_version;
};

/// Draws and times a scene. Throws gl::Unsupported if this machine cannot.
///
/// frames         to time, >= 1
/// has_reference  whether the last frame is compared with its reference
Drawn draw(const scene::Scene& scene, const DrawingOptions& options, int frames, bool has_reference);

/// The file of --stats.
///
/// display  of the picture's file; none for one that holds the scene's light
std::string stats_json(const scene::Scene& scene, const DrawingOptions& options, const Drawn& drawn,
                       const std::optional<render::Display>& display);

}  // namespace litfog::demo
