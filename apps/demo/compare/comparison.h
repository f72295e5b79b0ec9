// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "drawing/drawing_options.h"
#include "drawing/scene_options.h"
#include "scene/scene.h"

namespace litfog::demo {

inline constexpr std::size_t kMaxSettings = 8;  ///< in one comparison, whose page has a heat map for each pair

/// One way to draw a picture.
struct Setting {
  std::string text;  ///< as given
  drawing::SceneOptions scene;
  drawing::DrawingOptions drawing;
};

/// The settings of a comparison: those of the command line, each time with the changes that a text states. One text is
/// compared with the base itself.
///
///     visibility=50 path=vertex         options of a single picture, with or without their dashes
///     no-skip flags, in the same way lights[0].threshold=0.1 other members: as by --set
///     other.json                        another scene
///
/// throws  CLI::ValidationError that names --with, its text and what is wrong, or an option of the command line that
///         changes none of the pictures
std::vector<Setting> parse_settings(const CLI::App& app, const Setting& base, const std::vector<std::string>& texts);

/// Draws the settings, their frames timed interleaved, and writes index.html (settings_page) into a folder, which is
/// made where missing. Reports what it found on standard output. Needs a current GL context. Throws InputError,
/// OutputError, the usage error of an option without effect, and gl::Unsupported where a setting cannot be drawn here.
///
/// settings  of one size; an automatic exposure is that of the first picture that has one, for all
/// machine   text: what draws the pictures
/// frames    timed of each setting, >= 1
void compare_settings(const std::vector<Setting>& settings, const std::string& folder, const std::string& machine,
                      int frames);

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
