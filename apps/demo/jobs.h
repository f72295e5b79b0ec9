// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "command/table.h"
#include "drawing/drawing_options.h"
#include "scene/scene.h"

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

/// A scene's lights: a row for each entry of its file's "lights", with the position of its first copy, for each kind of
/// a generated city's, and for each light of a glTF file. Its columns:
///
/// member                        as --set takes it: lights[3]; city; empty of a glTF file
/// lights                        how many the row stands for
/// name                          of the light
/// x_m, y_m, z_m                 where the first of them is
/// constant, linear, quadratic   of the attenuation, 1, 1/m, 1/m^2
/// threshold, extent_m           the attenuation at which the light ends, and where that is
/// cone                          in words
/// density_scale
/// carried                       yes or no: by the eye's vehicle
command::Table list_lights(const scene::Scene& scene);

/// Becomes litfog-window, the program beside this one: windows need libraries that pictures do not.
///
/// throws  command::MissingCapability where it was not built, or one of those libraries is missing
[[noreturn]] void become_window(const std::vector<std::string>& arguments);

}  // namespace litfog::demo
