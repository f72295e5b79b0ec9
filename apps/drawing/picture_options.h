// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drawing/drawing_options.h"
#include "drawing/scene_options.h"

namespace litfog::drawing {

/// Adds SCENE and every option that changes a single picture of it.
void add_picture_options(CLI::App& app, SceneOptions& scene, DrawingOptions& drawing);

/// Throws the usage error of a --time or --lights that changes nothing in the scene.
void check_scene_options(const CLI::App& app, const scene::Scene& scene);

}  // namespace litfog::drawing
