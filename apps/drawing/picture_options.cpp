// SPDX-License-Identifier: Apache-2.0
#include "drawing/picture_options.h"

#include "command/option_rule.h"

namespace litfog::drawing {

void add_picture_options(CLI::App& app, SceneOptions& scene, DrawingOptions& drawing) {
  add_scene(app, scene);
  add_changes(app, scene);
  add_city_lights(app, scene);
  add_time(app, drawing);
  add_view(app, scene);
  add_fog_and_visibility(app, drawing);
  add_drawing(app, drawing);
}

void check_scene_options(const CLI::App& app, const scene::Scene& scene) {
  command::check_options(app,
                         {{scene.name, !changes_with_time(scene), {"--time"}, "none of its lights turns or flashes"},
                          {scene.name, !scene.has_city, {"--lights"}, "it has no generated city"}});
}

}  // namespace litfog::drawing
