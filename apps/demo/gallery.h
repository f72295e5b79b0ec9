// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "demo/display_options.h"
#include "render/renderer.h"

namespace litfog::demo {

/// What the pictures of a gallery have in common.
struct GallerySettings {
  FogMode fog_mode = FogMode::exp;
  std::optional<double> phase_g = {};  ///< in place of the scenes' own
  int width = 1280;
  int height = 720;
  render::RenderSettings render;
  bool compares_peak = false;   ///< whether the first scene is drawn again by FogLighting::peak
  DisplayOptions display = {};  ///< an automatic exposure is each picture's own
};

/// Draws scenes clear and at each of their visibilities into a folder (made where missing), one PNG each, and
/// contact-sheet.png with a row for each scene. Reports every step, the solved table (light x visibility) and the times
/// on standard output. Needs a current GL context. Throws InputError before anything is drawn (read_scenes).
///
/// scenes  paths of scene files
void draw_gallery(const std::vector<std::string>& scenes, const std::string& folder, const GallerySettings& settings);

}  // namespace litfog::demo
