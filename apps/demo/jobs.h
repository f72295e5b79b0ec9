// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "command/table.h"
#include "drawing/drawing_options.h"
#include "scene/scene.h"

namespace litfog::demo {

/// Draws scenes in clear air and at each of their visibilities into a folder (made if missing), one PNG each, and
/// contact-sheet.png with a row for each scene. If airlight is the default, the first scene has a second row, drawn by
/// FogLighting::peak. Reports every step, the solved table (light x visibility) and the times on standard output.
/// Several scenes are drawn at once, each thread with its own GL context. Throws InputError before anything is drawn
/// (read_scenes).
///
/// scenes   paths of scene files
/// are_all  whether these are all scenes, not chosen ones: leaves out those with is_lit_at_vertices
/// options  without a visibility; an automatic exposure is chosen for each picture
void draw_gallery(const std::vector<std::string>& scenes, bool are_all, const std::string& folder,
                  const drawing::DrawingOptions& options);

/// A scene's lights: a row for each entry of its file's "lights", for each kind of a generated city's lights, and for
/// each light of a glTF file. Columns:
///
/// member                        as --set takes it: lights[3]; city.window
/// lights                        number of lights in the row
/// name                          the light's
/// x_m, y_m, z_m                 position of the first copy
/// constant, linear, quadratic   attenuation, 1, 1/m, 1/m^2
/// threshold, extent_m           the attenuation and the range at which the light ends
/// cone                          in words
/// density_scale
/// carried                       yes or no: by the eye's vehicle
command::Table list_lights(const scene::Scene& scene);

/// Executes litfog-window, the program beside this one, because windows need libraries that pictures do not.
///
/// throws  command::MissingCapability if it was not built, or one of these libraries is missing
[[noreturn]] void become_window(const std::vector<std::string>& arguments);

}  // namespace litfog::demo
