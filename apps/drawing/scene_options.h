// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/file/scene_file.h"

namespace CLI {
class App;
}

namespace litfog::command {
struct NumberRule;
}

namespace litfog::drawing {

extern const command::NumberRule kFieldOfView;  ///< for --fov-deg

/// A scene as the command line states it.
struct SceneOptions {
  std::string scene;                             ///< the name of a bundled scene, or a file's path
  std::vector<scene::SceneChange> changes = {};  ///< changes of its file's members
  std::optional<glm::dvec3> camera = {};         ///< metres; default: the scene's own, like the two that follow
  std::optional<glm::dvec3> target = {};         ///< metres
  std::optional<double> field_of_view_deg = {};  ///< vertical
  bool is_lit_by_lamps_alone = false;            ///< without ambient light, sky, stars, moon and fog colour
  int city_lights = 0;                           ///< number of lights in a generated city; 0: the scene's
};

/// Adds SCENE.
void add_scene(CLI::App& app, SceneOptions& options);
/// Adds --set, which may be repeated, and --lamps-only.
void add_changes(CLI::App& app, SceneOptions& options);
/// Adds --lights.
void add_city_lights(CLI::App& app, SceneOptions& options);
/// Adds --camera, --target and --fov-deg.
void add_view(CLI::App& app, SceneOptions& options);

/// Reads the scene, changes it and sets its camera. Throws InputError, and the usage error of a view that a scene file
/// may not have.
///
/// kept  as in scene::read_scene
scene::Scene read_scene(const SceneOptions& options, scene::SceneParts* kept = nullptr);

/// Parses the MEMBER=VALUE of --set. Throws its usage error.
scene::SceneChange parse_change(const std::string& text);

/// Parses an option's X,Y,Z as a point of a scene. Throws its usage error.
glm::dvec3 parse_point(const std::string& option, const std::string& text);

/// The file of SceneOptions::scene. Throws InputError if there is none.
std::string scene_path(const std::string& scene);

/// Whether --time has an effect on a scene.
bool changes_with_time(const scene::Scene& scene);

}  // namespace litfog::drawing
