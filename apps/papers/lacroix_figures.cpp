// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "papers/figure.h"
#include "scene/file/scene_file.h"
#include "scene/model/primitive.h"
#include "scene/model/tessellation.h"

namespace litfog::papers {
namespace {

using render::RenderSettings;
using scene::Scene;

/// The direction from a ball's centre to a point of its surface.
///
/// uv  longitude and latitude, [0, 1] each
glm::vec3 up_at(const glm::vec2& uv) {
  const float longitude = 2 * std::numbers::pi_v<float> * uv.x;
  const float latitude = std::numbers::pi_v<float> * (uv.y - 0.5f);
  return {std::sin(longitude) * std::cos(latitude), std::sin(latitude), std::cos(longitude) * std::cos(latitude)};
}

/// A ball of few faces with its texture as a map, so that each texel is used once.
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

/// A globe with dents, seen at the meridian where its map begins and ends: vertices there share their normals but not
/// their tangents.
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

}  // namespace

Rows lacroix_figures(const FigurePainter& painter) {
  const auto lit_wall = [](const glm::ivec2& cells) {
    Scene scene = wall(cells, "sign_white");
    scene.lights = {lamp({0.2, 0.1, 0.8}, {0, 1, 0})};  // attenuates by his 1 / distance
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

}  // namespace litfog::papers
