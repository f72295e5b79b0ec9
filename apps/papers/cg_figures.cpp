// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "papers/figure.h"
#include "scene/file/scene_file.h"
#include "scene/model/primitive.h"
#include "scene/model/tessellation.h"
#include "scene/paint/material_catalogue.h"

namespace litfog::papers {
namespace {

using render::RenderSettings;
using scene::Scene;

scene::Mesh drum(int segments) {
  const scene::Model model = scene::make_drum_model({.radius_m = 0.6f, .height_m = 1.6f, .segments = segments});
  scene::Mesh mesh;
  scene::append(mesh, model.front().mesh, glm::translate(glm::mat4(1), glm::vec3(0, -0.8f, 0)));
  return mesh;
}

}  // namespace

Rows cg_figures(const FigurePainter& painter) {
  const glm::vec3 none(0.0f), ka(0.06f, 0.09f, 0.06f), kd(0.2f, 0.4f, 0.2f), ks(0.8f);
  const auto ball = [](const Finish& finish) { return figure(scene::make_sphere(1, 96), finish); };
  Rows rows{{}, {}};
  for (const float shininess : {2.0f, 10.0f, 50.0f, 250.0f}) {
    rows[0].push_back(painter.draw(ball({ka, kd, ks, shininess}), along("unified"),
                                   {fmt::format("figure 5-12: shininess {}", shininess)}));
  }
  for (const auto& [name, finish] : {std::pair<const char*, Finish>{"ambient", {ka, none, none, 90}},
                                     {"diffuse", {none, kd, none, 90}},
                                     {"specular", {none, none, ks, 90}},
                                     {"ambient + diffuse + specular", {ka, kd, ks, 90}}}) {
    rows[1].push_back(painter.draw(ball(finish), along("unified"), {fmt::format("figure 5-14: {}", name)}));
  }
  const Scene coarse = figure(drum(10), {ka, kd, ks, 40});
  const Scene tessellation = scene::read_scene(scene::bundled_scene_path("tessellation"));
  rows.push_back({painter.draw(coarse, along("vertex"), {"figure 5-17, left: per vertex"}),
                  painter.draw(coarse, along("mixed"), {"exercise 6: specular per fragment"}),
                  painter.draw(coarse, along("unified"), {"figure 5-17, right: per fragment"}),
                  painter.draw(tessellation, along("vertex"), {"figure 5-16: tessellation, per vertex"})});
  Scene spot = wall({1, 1}, "plaster");
  spot.lights = {lamp({0, 0, 3}, {1, 0, 0}, Cone::smoothstep(12 * kDegree, 26 * kDegree))};
  rows.emplace_back();
  for (const auto& [name, edge] : {std::pair{"figure 5-21, left: one cone", render::SpotEdge::hard},
                                   {"two cones by lerp", render::SpotEdge::lerp},
                                   {"figure 5-21, right: two cones by smoothstep", render::SpotEdge::smoothstep}}) {
    rows.back().push_back(painter.draw(spot, along("cg", {.papers = {.spot_edge = edge}}), {name}));
  }
  Scene bright = wall({1, 1}, "plaster");
  bright.lights = {lamp({-1.5, 0, 0.4}, {0.2, 0, 1.5}), lamp({1.6, 0, 0.4}, {1, 0, 9})};
  Scene glossy = figure(wall({1, 1}, "plaster").models[0][0].mesh, {ka, kd, ks, 40});
  glossy.lights[0].position = {-1, 0.5, 2};
  rows.push_back(
      {painter.draw(bright, along("cg"), {"example 5-6: attenuation as printed", "C = 0.2, Q = 1.5; C = 1, Q = 9"}),
       painter.draw(bright, along("unified"), {"clamped to 1 and cut at 0.05", "the other paths"}),
       painter.draw(glossy, along("unified"), {"exercise 4: viewer where the eye is"}),
       painter.draw(glossy, along("unified", {.papers = {.has_infinite_viewer = true}}),
                    {"exercise 4: V always (0, 0, 1)", "infinite viewer"})});
  Scene metal = figure(drum(64), {});
  metal.materials.clear();
  metal.models[0][0].material = "galvanised";
  scene::add_materials(metal);
  rows.push_back({painter.draw(metal, along("unified"), {"galvanised steel by the Basic model"}),
                  painter.draw(metal, along("cook-torrance"), {"further reading: Cook and Torrance"}),
                  painter.draw(metal, along("anisotropic"), {"exercise 7: brushed around the drum"})});
  return rows;
}

}  // namespace litfog::papers
