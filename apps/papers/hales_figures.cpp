// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

#include "papers/figure.h"
#include "papers/opengl_pictures.h"
#include "render/surface/polygon_sort.h"
#include "scene/file/scene_file.h"
#include "scene/paint/field.h"

namespace litfog::papers {
namespace {

using render::RenderSettings;
using scene::Scene;

/// A program for the figures' scene, or for one drawn another way.
struct Program {
  std::string name;
  RenderSettings render;
  const Scene* scene;
};

/// Patches of dirt, lighter and darker.
std::shared_ptr<const scene::Texels> make_dirt() {
  const scene::Field patches = scene::make_octaves(256, 4, 5, 1);
  scene::Texels texels{patches.size(), patches.size(), {}};
  for (const float height : patches.values()) {
    const std::uint8_t level = scene::srgb_level_of(0.8f + 0.5f * height);
    texels.rgba.insert(texels.rgba.end(), {level, level, level, 255});
  }
  return std::make_shared<const scene::Texels>(std::move(texels));
}

/// A scene whose ground has dirt as its second face texture, over many tiles of the first.
Scene with_dirt(Scene scene) {
  const std::shared_ptr<const scene::Texels> dirt = make_dirt();
  for (scene::Material& material : scene.materials) {
    if (material.name != "asphalt" && material.name != "grass") continue;
    material.second = dirt;
    material.second_size_m = 12;
  }
  return scene;
}

/// Figures 1 and 2 and table 1: "headlights" with only its two headlights. Every program draws every polygon, so that
/// their times are comparable.
Rows hales_table(const FigurePainter& painter) {
  Scene scene = scene::read_scene(scene::bundled_scene_path("headlights"));
  std::erase_if(scene.lights, [](const PlacedLight& light) { return !light.carried; });
  const RenderSettings whole{.skipping = render::Skipping::off};
  RenderSettings airlight = along("unified", whole);
  airlight.fog_lighting = render::FogLighting::airlight;
  const Scene sorted = render::sort_polygons(scene, along("sample", whole));
  const Scene dirty = with_dirt(scene);
  const std::vector<Program> programs{{"legacy", along("legacy", whole), &scene},
                                      {"sample program, every polygon", along("sample", whole), &scene},
                                      {"sample program, polygons sorted", along("sample", whole), &sorted},
                                      {"sample program, two face textures", along("sample", whole), &dirty},
                                      {"lookup-3d", along("lookup-3d", whole), &scene},
                                      {"lookup-2d", along("lookup-2d", whole), &scene},
                                      {"unified, Hales's fog", along("unified", whole), &scene},
                                      {"unified, airlight", airlight, &scene}};
  std::vector<std::unique_ptr<render::Renderer>> renderers;
  for (const Program& program : programs) renderers.push_back(painter.renderer(*program.scene, program.render));
  const Fog thick = Fog::from_visibility(FogMode::exp2, 100.0);
  Rows rows;
  for (const auto& [figure, fog] : {std::pair{"figure 1, clear air", Fog{}}, {"figure 2, exp2 fog, 100 m", thick}}) {
    for (const auto& renderer : renderers) renderer->set_atmosphere(scene.atmosphere.with(fog));
    const std::vector<double> times = relative_times(renderers, painter.frames());
    rows.emplace_back();
    for (std::size_t i = 0; i < programs.size(); ++i) {
      if (rows.back().size() == 4) rows.emplace_back();
      std::vector<std::string> caption{fmt::format("{}: {}", figure, programs[i].name),
                                       fmt::format("{:.2f} x legacy's frame", times[i])};
      const bool is_table = rows.size() <= 2;  // "the scene in figure 1 was used to measure the performance"
      if (is_table && i == 0) caption.push_back("table 1, legacy: X800 1.0, 9800 1.130, FX 5950 1.847");
      if (is_table && i == 1) caption.push_back("table 1, shader: 1.95, 2.450, 4.830: 1.95, 2.17, 2.62 x legacy");
      rows.back().push_back(painter.draw(*renderers[i], std::move(caption)));
    }
  }
  rows.emplace_back();
  for (const auto& [name, fog] : {std::pair{"clear air", Fog{}}, {"exp2 fog, 100 m", thick}}) {
    const auto fixed = draw_by_fixed_pipeline(scene, fog, painter.width(), painter.height(), painter.frames());
    if (!fixed) break;
    rows.back().push_back(FigurePainter::entry(
        fixed->picture, {fmt::format("OpenGL's fixed pipeline, {}", name),
                         fmt::format("legacy, which mimics it: {:.2f} x its frame", fixed->mimic_ratio),
                         "\"a fragment program that just mimics ... runs much slower\""}));
  }
  return rows;
}

/// A flare and a search light by the paper's look-ups; the paper names both beside headlights.
std::vector<drawing::SheetEntry> flare_and_search_light(const FigurePainter& painter) {
  Scene scene = scene::read_scene(scene::bundled_scene_path("headlights"));
  std::vector<drawing::SheetEntry> entries;
  PlacedLight flare = lamp({8, 35, -70}, {1, 0, 4e-4});
  PlacedLight search = lamp(scene.camera.position, {1, 0, 1e-5}, Cone::cosine(3 * kDegree, 200));
  search.direction = glm::normalize(glm::dvec3(-0.12, 0.02, -1));
  search.carried = true;
  for (const auto& [name, light] : {std::pair{"a parachute flare", flare}, {"a search light", search}}) {
    scene.lights = {light};
    for (const auto& [air, fog] :
         {std::pair{"clear air", Fog{}}, {"exp2 fog, 300 m", Fog::from_visibility(FogMode::exp2, 300.0)}}) {
      const auto renderer = painter.renderer(scene, along("lookup-3d"));
      renderer->set_atmosphere(scene.atmosphere.with(fog));
      entries.push_back(painter.draw(*renderer, {fmt::format("{}, {}", name, air)}));
    }
  }
  return entries;
}

/// A cosine cone on a wall so near that the cone's edge is in the picture.
Rows hales_cones(const FigurePainter& painter) {
  Rows rows;
  for (const double degrees : {60.0, 80.0, 89.0}) {
    Scene scene = wall({1, 1}, "sign_white");
    scene.materials[0].specular = {};  // Hales's equation has none
    const Cone cone = Cone::cosine(degrees * kDegree, 1);
    scene.lights = {lamp({0, 0, 2.2 / std::tan(std::min(degrees, 85.0) * kDegree)}, {1, 0, 0.3}, cone)};
    rows.emplace_back();
    for (const int size : {32, 128}) {
      RenderSettings scaled = along("lookup-3d");
      scaled.papers.map_size = size;
      rows.back().push_back(painter.draw(
          scene, scaled, {fmt::format("cone of {} degrees, scaled, {} texels", degrees, size), "as Hales scales it"}));
    }
    rows.back().push_back(painter.draw(scene, along("lookup-3d", {.papers = {.cone_maps = render::ConeMaps::even}}),
                                       {fmt::format("cone of {} degrees, even, 128 texels", degrees),
                                        "beyond 60 degrees over all faces of the cube"}));
    rows.back().push_back(painter.draw(scene, along("unified"), {fmt::format("cone of {} degrees, formula", degrees)}));
  }
  return rows;
}

}  // namespace

Rows hales_figures(const FigurePainter& painter) {
  Rows rows = hales_table(painter);
  rows.push_back(flare_and_search_light(painter));
  for (std::vector<drawing::SheetEntry>& row : hales_cones(painter)) rows.push_back(std::move(row));
  return rows;
}

}  // namespace litfog::papers
