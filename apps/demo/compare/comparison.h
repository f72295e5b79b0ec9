// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "drawing/drawing_options.h"
#include "drawing/scene_options.h"
#include "scene/scene.h"

namespace litfog::demo {

inline constexpr std::size_t kMaxSettings = 8;  ///< in one comparison; its page has a heat map for each pair

/// One way to draw a picture.
struct Setting {
  std::string text;  ///< as given
  drawing::SceneOptions scene;
  drawing::DrawingOptions drawing;
};

/// The settings of a comparison: the command line's with the changes of each text. A single text is compared with the
/// base itself.
///
///     visibility=50 path=vertex  options of a single picture, with or without their dashes
///     no-skip                    flags, in the same way
///     lights[0].threshold=0.1    other members: as by --set
///     other.json                 another scene
///
/// throws  CLI::ValidationError naming --with, its text and what is wrong, or an option of the command line that
///         changes none of the pictures
std::vector<Setting> parse_settings(const CLI::App& app, const Setting& base, const std::vector<std::string>& texts);

/// Draws the settings, timed with interleaved frames, and writes index.html (settings_page) into a folder, made if
/// missing. Reports results on standard output. Needs a current GL context. Throws InputError, OutputError, the usage
/// error of an option without effect, and gl::Unsupported if a setting cannot be drawn here.
///
/// settings  of one size; the first picture with an automatic exposure sets it for all
/// machine   text: what draws the pictures
/// frames    number timed for each setting, >= 1
void compare_settings(const std::vector<Setting>& settings, const std::string& folder, const std::string& machine,
                      int frames);

inline constexpr int kComparedFrames = 5;  ///< default number of frames timed for each path

/// Draws scenes by every lighting path into a folder (made if missing): for each scene and path the picture, its heat
/// map and its reference as PNG, a contact sheet, and index.html, which shows all with times and errors. The paths of a
/// scene are timed with interleaved frames. Reports every result on standard output. Needs a current GL context. Throws
/// OutputError, and gl::Unsupported if a path cannot draw a scene here.
///
/// scenes   of different names
/// machine  text: what draws the pictures
/// options  the path is ignored; the first path's picture sets an automatic exposure for all
/// frames   number timed for each path, >= 1
void compare_paths(const std::vector<scene::Scene>& scenes, const std::string& folder, const std::string& machine,
                   const drawing::DrawingOptions& options, int frames);

}  // namespace litfog::demo
