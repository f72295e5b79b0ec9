// SPDX-License-Identifier: Apache-2.0
#include "papers/figure.h"

#include <utility>

#include "measure/frame_times.h"
#include "render/display.h"
#include "scene/model/primitive.h"
#include "scene/model/tessellation.h"
#include "scene/paint/material_catalogue.h"

namespace litfog::papers {

using render::RenderSettings;
using scene::Scene;

RenderSettings along(std::string_view path, RenderSettings settings) {
  settings.path = render::find_lighting_path(path);
  return settings;
}

drawing::SheetEntry FigurePainter::draw(const Scene& scene, const RenderSettings& render,
                                        std::vector<std::string> caption) const {
  return draw(*renderer(scene, render), std::move(caption));
}

drawing::SheetEntry FigurePainter::draw(render::Renderer& renderer, std::vector<std::string> caption) const {
  renderer.draw(render::LightPoints::off);
  return entry(renderer.read(), std::move(caption));
}

drawing::SheetEntry FigurePainter::entry(const render::Picture& picture, std::vector<std::string> caption) {
  constexpr render::Display kPapersDisplay{.tone = render::ToneCurve::clip};
  return {drawing::fitted_to_cell(render::displayed(picture, kPapersDisplay)), std::move(caption)};
}

std::unique_ptr<render::Renderer> FigurePainter::renderer(const Scene& scene, const RenderSettings& render) const {
  return std::make_unique<render::Renderer>(scene, width_, height_, render);
}

std::vector<double> relative_times(const std::vector<std::unique_ptr<render::Renderer>>& renderers, int frames) {
  const std::vector<measure::FrameTimes> times = measure::time_frames(renderers, measure::FrameBudget::exactly(frames));
  std::vector<double> ratios;
  for (const measure::FrameTimes& each : times) ratios.push_back(each.median() / times.front().median());
  return ratios;
}

Scene wall(const glm::ivec2& cells, const std::string& material) {
  Scene scene;
  scene.camera = {.position = {0, 0, 5}, .target = {0, 0, 0}, .field_of_view = 0.75f};
  std::vector<glm::vec3> points;
  for (int j = 0; j <= cells.y; ++j) {
    for (int i = 0; i <= cells.x; ++i)
      points.emplace_back(6 * (float(i) / float(cells.x) - 0.5f), 4 * (float(j) / float(cells.y) - 0.5f), 0);
  }
  scene::Mesh mesh = scene::make_surface(points, cells.x + 1);
  scene::compute_tangents(mesh);
  scene.models.push_back({{material, std::move(mesh)}});
  scene.instances.push_back({0, glm::mat4(1)});
  scene::add_materials(scene);
  return scene;
}

PlacedLight lamp(const glm::dvec3& position, const Attenuation& attenuation, const Cone& cone) {
  return {.light = {.name = "lamp", .color = {1, 0.95, 0.85}, .attenuation = attenuation, .cone = cone},
          .position = position,
          .direction = {0, 0, -1}};
}

Scene figure(scene::Mesh mesh, const Finish& finish) {
  Scene scene;
  scene.camera = {.position = {0, 0, 3.2f}, .target = {0, 0, 0}, .field_of_view = 0.75f};
  scene.materials.push_back({.name = "figure",
                             .size_m = 1,
                             .albedo = nullptr,
                             .normal = std::make_shared<const scene::Texels>(scene::Texels{1, 1, {128, 128, 255, 0}}),
                             .specular = finish.specular,
                             .shininess = finish.shininess,
                             .emissive = finish.emissive,
                             .plain_albedo = finish.diffuse,
                             .ambient = finish.ambient});
  scene.environment.ambient_light = glm::vec3(finish.ambient == glm::vec3(0.0f) ? 0.0f : 1.0f);
  scene::compute_tangents(mesh);
  scene.models.push_back({{"figure", std::move(mesh)}});
  scene.instances.push_back({0, glm::mat4(1)});
  scene.lights = {lamp({-2, 2.2, 3}, {1, 0, 0})};
  return scene;
}

}  // namespace litfog::papers
