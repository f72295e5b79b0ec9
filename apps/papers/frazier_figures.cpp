// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "papers/figure.h"
#include "scene/file/scene_file.h"

namespace litfog::papers {

using render::RenderSettings;
using scene::Scene;

Rows frazier_figures(const FigurePainter& painter) {
  Scene room = scene::read_scene(scene::bundled_scene_path("room"));
  for (PlacedLight& light : room.lights) light.light.color *= 0.3;  // his back buffer ends at 1
  Rows rows{{}, {}};
  rows[0].push_back(painter.draw(room, along("light-map"), {"dynamic multi-light light map, without texture"}));
  rows[0].push_back(painter.draw(room, along("accumulate"), {"multiplied by the base texture"}));
  for (const auto& [name, maps] : {std::pair{"one spot map for every angle, by its scale", render::ConeMaps::one_disc},
                                   {"a map of each light's own cone", render::ConeMaps::scaled}}) {
    rows[1].push_back(painter.draw(room, along("radial", {.papers = {.cone_maps = maps}}), {name}));
  }
  Scene points = room;
  points.lights = {lamp({0, 1.4, -1}, {1, 0, 1}), lamp({-2.4, 1.8, -3}, {1, 0, 0.6})};
  points.lights[0].light.color = {0.9, 0.1, 0.1};
  points.lights[1].light.color = {0.9, 0.8, 0.1};
  RenderSettings unlit;
  unlit.path = &render::unlit_path();
  rows.push_back(
      {painter.draw(points, unlit, {"base texture only"}),
       painter.draw(points, along("radial-plane"), {"two point lights in one pass", "z^2 of each a constant"}),
       painter.draw(room, along("accumulate", {.shadows = render::Shadows::surfaces}),
                    {"improvements: \"depth buffer shadow casting\""})});
  return rows;
}

}  // namespace litfog::papers
