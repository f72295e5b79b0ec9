// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/drawing_options.h"
#include "scene/file/scene_file.h"
#include "scene/scene.h"

namespace litfog::window {

/// A picture that litfog-demo can draw.
struct DrawingCommand {
  std::string scene;  ///< a bundled scene's name or a file
  drawing::DrawingOptions options = {};
  std::optional<scene::Camera> camera = {};  ///< replaces the scene's
  std::vector<scene::SceneChange> changes = {};
  bool is_lit_by_lamps_alone = false;
};

/// The command line for a shell, without options at their defaults.
std::string to_string(const DrawingCommand& command);

}  // namespace litfog::window
