// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "drawing/drawing_options.h"
#include "drawing/scene_options.h"

namespace litfog::demo {

inline constexpr std::size_t kMaxSettings = 8;  ///< of one comparison: each pair has a heat map in its page

/// One way to draw a picture.
struct Setting {
  std::string words;  ///< in which it was given
  drawing::SceneOptions scene;
  drawing::DrawingOptions drawing;
};

/// The settings of a comparison: the base, which a command line states, with what each text says in place of its own.
/// One text is compared with the base itself.
///
///     visibility=50 path=vertex         options of a single picture, with or without their dashes
///     no-skip                           flags, likewise
///     lights[0].threshold=0.1           other members: as by --set
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

}  // namespace litfog::demo
