// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "drawing/drawing_options.h"

namespace litfog::demo {

/// Draws scenes clear and at each of their visibilities into a folder (made where missing), one PNG each, and
/// contact-sheet.png with a row for each scene. Where airlight is the default, the first scene has a second row, drawn
/// by FogLighting::peak. Reports every step, the solved table (light x visibility) and the times on standard output.
/// Several scenes are drawn at once, each thread with a GL context of its own. Throws InputError before anything is
/// drawn (read_scenes).
///
/// scenes   paths of scene files
/// are_all  whether they are all there are and not chosen: is_lit_at_vertices ones are left out then
/// options  without a visibility; an automatic exposure is each picture's own
void draw_gallery(const std::vector<std::string>& scenes, bool are_all, const std::string& folder,
                  const drawing::DrawingOptions& options);

}  // namespace litfog::demo
