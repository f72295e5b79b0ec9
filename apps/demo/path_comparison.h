// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "demo/display_options.h"
#include "render/renderer.h"

namespace litfog::demo {

/// What the pictures of a comparison have in common.
struct PathComparisonSettings {
  FogMode fog_mode = FogMode::exp;
  std::optional<double> visibility = {};  ///< metres; default: what each scene suggests
  int width = 1280;
  int height = 720;
  int frames = 5;                 ///< timed of each path, >= 1
  render::RenderSettings render;  ///< but the path
  DisplayOptions display = {};    ///< an automatic exposure is that of the first path's picture, for all
};

/// Draws scenes by every lighting path into a folder (made where missing): of each scene and path the picture, its heat
/// map and its reference as PNG, a contact sheet, and index.html, which shows all with times and errors. All paths of a
/// scene are timed interleaved. Reports every result on standard output. Needs a current GL context. Throws OutputError, and
/// gl::Unsupported where a path cannot draw a scene here.
///
/// scenes   of different names
/// machine  text: what draws the pictures
void compare_paths(const std::vector<scene::Scene>& scenes, const std::string& folder, const std::string& machine,
                   const PathComparisonSettings& settings);

}  // namespace litfog::demo
