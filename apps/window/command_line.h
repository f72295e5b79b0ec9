// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/drawing_options.h"
#include "scene/file/scene_file.h"
#include "scene/scene.h"

namespace litfog::window {

/// A picture as litfog-demo draws it.
struct DrawingCommand {
  std::string scene;  ///< as litfog-demo takes it: a bundled scene's name or a file
  drawing::DrawingOptions options = {};
  std::optional<scene::Camera> camera = {};  ///< replaces the scene's
  std::vector<scene::SceneChange> changes = {};
  bool is_lit_by_lamps_alone = false;
};

/// Its command line for a shell, without options that are at their defaults.
std::string to_string(const DrawingCommand& command);

}  // namespace litfog::window
