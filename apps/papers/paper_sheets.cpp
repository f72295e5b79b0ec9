// SPDX-License-Identifier: Apache-2.0
#include "papers/paper_sheets.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "command/standard_output.h"
#include "drawing/contact_sheet.h"
#include "drawing/picture_folder.h"
#include "litfog/gl/headless_context.h"
#include "measure/frame_times.h"
#include "render/display.h"
#include "render/renderer.h"
#include "render/surface/polygon_sort.h"
#include "scene/file/scene_file.h"
#include "scene/model/primitive.h"
#include "scene/model/tessellation.h"
#include "scene/paint/field.h"
#include "scene/paint/material_catalogue.h"

namespace litfog::papers {
namespace {

using render::RenderSettings;
using scene::Scene;
using Rows = std::vector<std::vector<drawing::SheetEntry>>;

constexpr double kDegree = std::numbers::pi / 180;
constexpr render::Display kPapersDisplay{.tone = render::ToneCurve::clip};

RenderSettings along(std::string_view path, RenderSettings settings = {}) {
  settings.path = render::find_lighting_path(path);
  return settings;
}

/// Draws the figures of a sheet, all of one size.
class FigurePainter {
 public:
  FigurePainter(int width, int height, int frames) : width_(width), height_(height), frames_(frames) {}

  drawing::SheetEntry draw(const Scene& scene, const RenderSettings& render, std::vector<std::string> caption) const {
    return draw(*renderer(scene, render), std::move(caption));
  }
  drawing::SheetEntry draw(render::Renderer& renderer, std::vector<std::string> caption) const {
    renderer.draw(render::LightPoints::off);
    return {drawing::fitted_to_cell(render::displayed(renderer.read(), kPapersDisplay)), std::move(caption)};
  }
  std::unique_ptr<render::Renderer> renderer(const Scene& scene, const RenderSettings& render) const {
    return std::make_unique<render::Renderer>(scene, width_, height_, render);
  }
  int frames() const { return frames_; }

 private:
  int width_, height_, frames_;
};

// --- what the figures show ---

/// A wall of one material facing +Z at z = 0, cells.x by cells.y cells, six metres wide and four high.
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

PlacedLight lamp(const glm::dvec3& position, const Attenuation& attenuation, const Cone& cone = {}) {
  return {.light = {.name = "lamp", .color = {1, 0.95, 0.85}, .attenuation = attenuation, .cone = cone},
          .position = position,
          .direction = {0, 0, -1}};
}

/// What the figures' objects are made of.
struct Finish {
  glm::vec3 ambient_light{0.0f};  ///< Ka * globalAmbient
  glm::vec3 diffuse{0.0f};
  glm::vec3 specular{0.0f};
  float shininess = 1;
};

/// A mesh in white light from the upper left, in front of the camera.
Scene figure(scene::Mesh mesh, const Finish& finish) {
  Scene scene;
  scene.camera = {.position = {0, 0, 3.2f}, .target = {0, 0, 0}, .field_of_view = 0.75f};
  scene.materials.push_back({.name = "figure",
                             .size_m = 1,
                             .albedo = nullptr,
                             .normal = std::make_shared<const scene::Texels>(scene::Texels{1, 1, {128, 128, 255, 0}}),
                             .specular = finish.specular,
                             .shininess = finish.shininess,
                             .emissive = finish.ambient_light,
                             .plain_albedo = finish.diffuse});
  scene::compute_tangents(mesh);
  scene.models.push_back({{"figure", std::move(mesh)}});
  scene.instances.push_back({0, glm::mat4(1)});
  scene.lights = {lamp({-2, 2.2, 3}, {1, 0, 0})};
  return scene;
}

// --- Hales ---

/// A program over the figures' setting, or over one that is drawn another way.
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

/// The times of frames over that of the first renderer's, all interleaved.
std::vector<double> relative_times(const std::vector<std::unique_ptr<render::Renderer>>& renderers, int frames) {
  std::vector<measure::DrawFrame> draws;
  for (const auto& renderer : renderers) draws.push_back(measure::frames_of(*renderer));
  const std::vector<measure::FrameTimes> times = measure::time_frames(draws, measure::FrameBudget::exactly(frames));
  std::vector<double> ratios;
  for (const measure::FrameTimes& each : times) ratios.push_back(each.median() / times.front().median());
  return ratios;
}

/// Figures 1 and 2 and table 1: "headlights" with its two headlights alone. Every program draws every polygon, so that
/// their times compare.
Rows hales_figures(const FigurePainter& painter) {
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
  const std::vector<double> times = relative_times(renderers, painter.frames());
  Rows rows;
  for (const auto& [figure, fog] : {std::pair{"figure 1, clear air", Fog{}}, {"figure 2, exp2 fog, 100 m", thick}}) {
    rows.emplace_back();
    for (std::size_t i = 0; i < programs.size(); ++i) {
      if (rows.back().size() == 4) rows.emplace_back();
      std::vector<std::string> caption{fmt::format("{}: {}", figure, programs[i].name)};
      const bool is_table = rows.size() <= 2;  // "the scene in figure 1 was used to measure the performance"
      if (is_table) caption.push_back(fmt::format("{:.2f} x legacy's frame", times[i]));
      if (is_table && i == 0) caption.push_back("table 1, legacy: X800 1.0, 9800 1.130, FX 5950 1.847");
      if (is_table && i == 1) caption.push_back("table 1, shader: 1.95, 2.450, 4.830: 1.95, 2.17, 2.62 x legacy");
      renderers[i]->set_atmosphere(renderers[i]->scene().atmosphere.with(fog));
      rows.back().push_back(painter.draw(*renderers[i], std::move(caption)));
    }
  }
  return rows;
}

/// A cosine cone on a wall that is near enough for its edge to be in the picture.
Rows hales_cones(const FigurePainter& painter) {
  Rows rows;
  for (const double degrees : {60.0, 80.0, 89.0}) {
    Scene scene = wall({1, 1}, "sign_white");
    scene.materials[0].specular = {};  // which Hales's equation lacks
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

Rows hales_sheet(const FigurePainter& painter) {
  Rows rows = hales_figures(painter);
  for (std::vector<drawing::SheetEntry>& row : hales_cones(painter)) rows.push_back(std::move(row));
  return rows;
}

// --- Lacroix ---

/// The direction in which a place on a ball lies from its middle.
///
/// uv  its longitude and latitude, [0, 1] each
glm::vec3 up_at(const glm::vec2& uv) {
  const float longitude = 2 * std::numbers::pi_v<float> * uv.x;
  const float latitude = std::numbers::pi_v<float> * (uv.y - 0.5f);
  return {std::sin(longitude) * std::cos(latitude), std::sin(latitude), std::cos(longitude) * std::cos(latitude)};
}

/// A ball of few faces whose texture is a map of it, so that each texel is in one place.
scene::Mesh globe(int faces_around) {
  const glm::ivec2 cells(faces_around, faces_around / 2);
  std::vector<glm::vec2> uvs;
  std::vector<glm::vec3> points;
  for (int j = 0; j <= cells.y; ++j) {
    for (int i = 0; i <= cells.x; ++i) {
      uvs.push_back(glm::vec2(i, j) / glm::vec2(cells));
      points.push_back(up_at(uvs.back()));
    }
  }
  scene::Mesh mesh = scene::make_surface(points, cells.x + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    mesh.vertices[i].normal = points[i];
    mesh.vertices[i].uv = uvs[i];
  }
  return mesh;
}

enum class NormalSpace { tangent, object };

/// The normal map of a globe with dents.
std::shared_ptr<const scene::Texels> make_dents(NormalSpace space) {
  constexpr glm::ivec2 kSize(512, 256);
  constexpr float kDents = 9;
  constexpr float kSlope = 0.8f;
  scene::Texels texels{kSize.x, kSize.y, {}, {.wrap_v = scene::Sampling::Wrap::clamp}};
  for (int row = 0; row < kSize.y; ++row) {
    for (int column = 0; column < kSize.x; ++column) {
      const glm::vec3 up = up_at((glm::vec2(column, row) + 0.5f) / glm::vec2(kSize));
      const glm::vec3 sines = glm::sin(kDents * up);
      const glm::vec3 cosines = glm::cos(kDents * up);
      // Gradient of the height sin x sin y sin z.
      const glm::vec3 slope = kSlope * glm::vec3(cosines.x * sines.y * sines.z, sines.x * cosines.y * sines.z,
                                                 sines.x * sines.y * cosines.z);
      glm::vec3 normal = glm::normalize(up - slope + up * glm::dot(up, slope));
      if (space == NormalSpace::tangent) {
        const glm::vec3 east = glm::normalize(glm::vec3(up.z, 0, -up.x));
        normal = {glm::dot(normal, east), glm::dot(normal, glm::cross(up, east)), glm::dot(normal, up)};
      }
      for (int c = 0; c < 3; ++c) texels.rgba.push_back(scene::level_of(0.5f + 0.5f * normal[c]));
      texels.rgba.push_back(255);
    }
  }
  return std::make_shared<const scene::Texels>(std::move(texels));
}

/// A globe with dents, in view the meridian at which its map begins and ends: vertices there share their normals, but
/// not their tangents.
Scene dented_globe(int faces_around, NormalSpace space) {
  Scene scene = figure(globe(faces_around), {.diffuse = glm::vec3(0.5f), .specular = glm::vec3(0.4f), .shininess = 40});
  scene.materials[0].normal = make_dents(space);
  return scene;
}

/// A matt ball between two lamps.
Scene ball_between_lamps() {
  Scene scene = figure(scene::make_sphere(1, 96), {.diffuse = glm::vec3(0.8f)});
  scene.lights = {lamp({-2, 0.6, 0.8}, {0, 1, 0}), lamp({2, -0.6, 0.2}, {0, 1, 0})};
  return scene;
}

/// Listings 3.1 and 3.2, whose picture is that of listing 2.1: "Let's assume there are 6 point lights".
std::vector<drawing::SheetEntry> nested_flags(const FigurePainter& painter, Scene scene) {
  scene.lights.clear();
  for (int i = 0; i < 6; ++i) {
    scene.lights.push_back(lamp({i % 2 == 0 ? -2.2 : 2.2, 1.8, 1.2 - 2.4 * (i / 2)}, {1, 0, 0.4}));
  }
  std::vector<std::unique_ptr<render::Renderer>> renderers;
  for (const char* path : {"unified", "nested"}) renderers.push_back(painter.renderer(scene, along(path)));
  const std::vector<double> times = relative_times(renderers, painter.frames());
  return {painter.draw(*renderers[0], {"listing 2.1: six point lights", "compiled for each number of lights"}),
          painter.draw(*renderers[1], {"listings 3.1 and 3.2: nested ifs, ended by flags",
                                       fmt::format("{:.2f} x that frame", times[1])})};
}

Rows lacroix_figures(const FigurePainter& painter) {
  const auto lit_wall = [](const glm::ivec2& cells) {
    Scene scene = wall(cells, "sign_white");
    scene.lights = {lamp({0.2, 0.1, 0.8}, {0, 1, 0})};  // his 1 / distance
    return scene;
  };
  const Scene room = scene::read_scene(scene::bundled_scene_path("room"));
  Scene bricks = wall({1, 1}, "brick");
  bricks.camera = {.position = {-1.6f, -0.5f, 0.45f}, .target = {-0.6f, -0.35f, 0}, .field_of_view = 0.6f};
  bricks.lights = {lamp({-0.9, 0.3, 0.6}, {1, 0, 0.2})};
  RenderSettings object_space;
  object_space.path = &render::object_space_path();
  return {
      {painter.draw(lit_wall({1, 1}), along("vertex"), {"figure 1: 4 vertices, lit at the vertices"}),
       painter.draw(lit_wall({6, 4}), along("vertex"), {"figure 2: 35 vertices, lit at the vertices"}),
       painter.draw(lit_wall({1, 1}), along("interpolated"),
                    {"figure 3: 4 vertices, lit per pixel", "listing 2.2, interpolated normals"})},
      {painter.draw(ball_between_lamps(), along("lacroix"),
                    {"equations 1 to 4 as printed", "a lamp behind a surface takes away what the other gives"}),
       painter.draw(ball_between_lamps(), along("interpolated"), {"N.L clamped to 0", "the other paths"})},
      {painter.draw(room, along("interpolated"), {"listing 2.2: interpolated normals"}),
       painter.draw(room, along("tangent"), {"listing 1.2: normal maps, lights in tangent space"}),
       painter.draw(room, along("unified"), {"listing 2.3: normal maps in world space"})},
      nested_flags(painter, room),
      {painter.draw(bricks, along("interpolated"), {"bricks seen along the wall: interpolated normals"}),
       painter.draw(bricks, along("unified"), {"normal map"}),
       painter.draw(bricks, along("parallax"), {"and parallax mapping, by the bricks' heights"})},
      {painter.draw(
           dented_globe(8, NormalSpace::tangent), along("unified"),
           {"8 faces around, normal map in tangent space", "a seam where vertices share normals, but no tangents"}),
       painter.draw(dented_globe(8, NormalSpace::object), object_space, {"8 faces around, normal map in object space"}),
       painter.draw(dented_globe(192, NormalSpace::tangent), along("unified"),
                    {"192 faces around, normal map in tangent space"})}};
}

// --- The Cg Tutorial ---

scene::Mesh drum(int segments) {
  const scene::Model model = scene::make_drum_model({.radius_m = 0.6f, .height_m = 1.6f, .segments = segments});
  scene::Mesh mesh;
  scene::append(mesh, model.front().mesh, glm::translate(glm::mat4(1), glm::vec3(0, -0.8f, 0)));
  return mesh;
}

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

// --- Frazier ---

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

}  // namespace

void draw_paper_sheets(const std::string& folder, int width, int height, int frames) {
  const std::pair<const char*, Rows (*)(const FigurePainter&)> sheets[] = {{"hales.png", hales_sheet},
                                                                           {"lacroix.png", lacroix_figures},
                                                                           {"cg.png", cg_figures},
                                                                           {"frazier.png", frazier_figures}};
  std::vector<std::string> files;
  for (const auto& [file, draw] : sheets) files.emplace_back(file);
  drawing::PictureFolder pictures(folder, files, {});
  const gl::HeadlessContext context;
  const FigurePainter painter(width, height, frames);
  for (const auto& [file, draw] : sheets) {
    pictures.write(file, drawing::make_contact_sheet(draw(painter)));
    command::report(fmt::format("{}\n", pictures.path_of(file)));
  }
  pictures.finish();
}

}  // namespace litfog::papers
