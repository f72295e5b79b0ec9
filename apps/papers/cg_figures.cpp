// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "papers/figure.h"
#include "papers/paper_programs.h"
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

/// Figure 5-22: smoothstep(min, max, x) over x, with a margin of a fifth on each side.
drawing::SheetEntry graph_of_smoothstep() {
  render::Picture picture{drawing::kSheetCellWidth, drawing::kSheetCellWidth * 9 / 16, {}};
  const auto height_of = [](double x) { return x * x * (3 - 2 * x); };
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      const double scale = 1.4 / picture.width;  // of x a pixel
      const double x = (column + 0.5) * scale - 0.2;
      const double y = 1.2 - (row + 0.5) * 1.4 / picture.height;
      const double t = std::clamp(x, 0.0, 1.0);
      const double slope = x == t ? 6 * t * (1 - t) : 0;
      const double distance = std::abs(y - height_of(t)) / std::hypot(1.4 / picture.height, slope * scale);
      const double axis = std::min({std::abs(x), std::abs(x - 1)}) / scale;
      const auto light = float(std::clamp(2 - distance, 0.0, 1.0));
      const float ground = axis < 1 ? 0.15f : 0.02f;
      picture.rgb.insert(picture.rgb.end(), 3, std::max(light, ground));
    }
  }
  return {std::move(picture), {"figure 5-22: smoothstep", "0 at min, 1 at max: the lines"}};
}

/// Attenuation and spots at the vertices in each space, on a wall that is rotated and scaled by a half.
std::vector<drawing::SheetEntry> lit_at_vertices(const FigurePainter& painter) {
  Scene spots = wall({36, 24}, "plaster");
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1), -0.25, glm::dvec3(1, 1, 0));
  spots.instances[0].world_from_model = glm::scale(turned, glm::dvec3(0.5));
  spots.camera.position = {0, 0, 2.6f};
  spots.lights = {lamp({-0.5, 0.2, 1}, {0.4, 0, 0.6}, Cone::smoothstep(10 * kDegree, 28 * kDegree)),
                  lamp({0.6, -0.1, 0.8}, {1, 0.5, 0}, Cone::smoothstep(14 * kDegree, 20 * kDegree))};
  std::vector<drawing::SheetEntry> entries;
  for (const auto& [space, name] : {std::pair{Space::world, "world space"},
                                    {Space::object, "object space, as printed"},
                                    {Space::eye, "eye space, exercise 3"}}) {
    entries.push_back(
        painter.draw(spots, {.path = &cg_at_vertices(space)}, {fmt::format("5-4 to 5-10 at vertices: {}", name)}));
    if (space == Space::world) continue;
    double most = 0;
    for (std::size_t i = 0; i < entries[0].picture.rgb.size(); ++i) {
      most = std::max(most, double(std::abs(entries.back().picture.rgb[i] - entries[0].picture.rgb[i])));
    }
    entries.back().caption.push_back(fmt::format("differs from the world's by at most {:.2g}", most));
  }
  return entries;
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
  for (const auto& [name, finish] : {std::pair<const char*, Finish>{"5-3: emissive", {none, none, none, 90, kd}},
                                     {"5-5: ambient", {ka, none, none, 90}},
                                     {"5-8: diffuse", {none, kd, none, 90}},
                                     {"5-11: specular", {none, none, ks, 90}}}) {
    rows[1].push_back(painter.draw(ball(finish), along("unified"), {fmt::format("figure {}", name)}));
  }
  const Finish plastic{ka, kd, ks, 90};
  rows.push_back({painter.draw(ball(plastic), along("unified"), {"figure 5-14: ambient + diffuse + specular"}),
                  painter.draw(ball(plastic), {.path = &cg_with_two_colors()},
                               {"a light's specular colour apart, blue", "\"instead of allowing different values\""}),
                  graph_of_smoothstep()});
  rows.push_back(lit_at_vertices(painter));
  const Scene coarse = figure(drum(10), {ka, kd, ks, 40});
  Scene tessellation = scene::read_scene(scene::bundled_scene_path("tessellation"));
  tessellation.camera = {.position = {-1.25f, 2.25f, 9.5f}, .target = {-1.25f, 2.25f, 0}, .field_of_view = 0.54f};
  std::erase_if(tessellation.instances,
                [](const scene::Instance& instance) { return std::abs(instance.world_from_model[3].x + 1.25) > 3; });
  rows.push_back({painter.draw(coarse, along("vertex"), {"figure 5-17, left: per vertex"}),
                  painter.draw(coarse, along("mixed"), {"exercise 6: specular per fragment"}),
                  painter.draw(coarse, along("unified"), {"figure 5-17, right: per fragment"}),
                  painter.draw(tessellation, along("vertex"),
                               {"figure 5-16: 8, 12 and 16 faces around", "lit per vertex; wires below"})});
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
  Scene metal_ball = metal;
  metal_ball.models[0][0].mesh = ball({}).models[0][0].mesh;
  rows.push_back({painter.draw(ball({ka, kd, none, 90}), along("unified"), {"figure 5-1: matt"}),
                  painter.draw(ball(plastic), along("unified"), {"figure 5-1: Basic, as plastic"}),
                  painter.draw(metal_ball, along("cook-torrance"), {"figure 5-1: metal"}),
                  painter.draw(metal_ball, along("anisotropic"), {"figure 5-1: brushed"})});
  rows.push_back({painter.draw(metal, along("unified"), {"galvanised steel by the Basic model"}),
                  painter.draw(metal, along("cook-torrance"), {"further reading: Cook and Torrance"}),
                  painter.draw(metal, along("anisotropic"), {"exercise 7: brushed around the drum"})});
  return rows;
}

}  // namespace litfog::papers
