// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "drawing/drawing_options.h"
#include "scene/scene.h"

namespace litfog::demo {

inline constexpr int kComparedFrames = 5;  ///< that are timed of each path unless told otherwise

/// Draws scenes by every lighting path into a folder (made where missing): of each scene and path the picture, its heat
/// map and its reference as PNG, a contact sheet, and index.html, which shows all with times and errors. All paths of a
/// scene are timed interleaved. Reports every result on standard output. Needs a current GL context. Throws
/// OutputError, and gl::Unsupported where a path cannot draw a scene here.
///
/// scenes   of different names
/// machine  text: what draws the pictures
/// options  but the path; an automatic exposure is that of the first path's picture, for all
/// frames   timed of each path, >= 1
void compare_paths(const std::vector<scene::Scene>& scenes, const std::string& folder, const std::string& machine,
                   const drawing::DrawingOptions& options, int frames);

}  // namespace litfog::demo
