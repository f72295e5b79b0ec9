// SPDX-License-Identifier: Apache-2.0
#include <functional>
#include <utility>

#include "papers/figure.h"
#include "papers/opengl_pictures.h"
#include "papers/paper_programs.h"
#include "render/light/light_map.h"
#include "scene/file/scene_file.h"
#include "scene/paint/cookie_pattern.h"
#include "scene/srgb.h"

namespace litfog::papers {
namespace {

using render::MapTexels;
using render::RenderSettings;
using scene::Scene;

constexpr int kMapSize = 128;

/// A picture of texels as an image program shows them.
///
/// texel_at  index of a pixel's texel, or -1
drawing::SheetEntry picture_of(const MapTexels& texels, glm::ivec2 size, const std::function<int(int, int)>& texel_at,
                               std::vector<std::string> caption) {
  render::Picture picture{size.x, size.y, {}};
  for (int row = 0; row < size.y; ++row) {
    for (int column = 0; column < size.x; ++column) {
      const int i = texel_at(column, row);
      const float level = i < 0 ? 0.1f : float(texels[std::size_t(i)]) / 65535;
      picture.rgb.insert(picture.rgb.end(), 3, scene::linear_from_srgb(level));
    }
  }
  return {drawing::fitted_to_cell(picture), std::move(caption)};
}

/// The faces of a cube map, unfolded.
drawing::SheetEntry unfolded(const MapTexels& cube, int size, std::vector<std::string> caption) {
  const auto texel_at = [size](int column, int row) {
    constexpr int kFaces[3][4] = {{-1, 2, -1, -1}, {1, 4, 0, 5}, {-1, 3, -1, -1}};  // of +x -x +y -y +z -z
    const int face = kFaces[row / size][column / size];
    return face < 0 ? -1 : (face * size + row % size) * size + column % size;
  };
  caption.emplace_back("faces -x +z +x -z, +y above, -y below");
  return picture_of(cube, {4 * size, 3 * size}, texel_at, std::move(caption));
}

std::vector<std::vector<drawing::SheetEntry>> maps() {
  const MapTexels ramp = render::make_square_ramp(kMapSize);
  const MapTexels spot = render::make_cone_cube(Cone::cosine(45 * kDegree, 0), render::CubeAxis::minus_z, kMapSize,
                                                render::ConeMaps::one_disc);
  const Cookie disco = scene::paint_cookie("disco"), beacon = scene::paint_cookie("beacon");
  constexpr glm::ivec2 kSize(kMapSize * 16 / 9, kMapSize);
  const auto in_square = [](int column, int row) {
    const int x = column - (kSize.x - kMapSize) / 2;
    return x < 0 || x >= kMapSize ? -1 : row * kMapSize + x;
  };
  const auto along_ramp = [](int column, int) { return column * kMapSize / kSize.x; };
  return {{picture_of(render::make_square_map(kMapSize), kSize, in_square, {"2-D texture: (x/R)^2 + (y/R)^2"}),
           picture_of(ramp, kSize, along_ramp, {"1-D texture: (z/R)^2", "stretched vertically for clarity"}),
           unfolded(spot, kMapSize, {"spot light cube map"})},
          {unfolded(render::make_cookie_cube(disco), disco.size, {"disco light cube map"}),
           unfolded(render::make_cookie_cube(beacon), beacon.size, {"beacon cube map"})}};
}

PlacedLight coloured(PlacedLight light, const glm::dvec3& color, const glm::dvec3& direction = {0, 0, -1}) {
  light.light.color = color;
  light.direction = glm::normalize(direction);
  return light;
}

const Cone kSpot = Cone::smoothstep(16 * kDegree, 18 * kDegree);

/// Three mirror balls of different colours, and a beacon.
std::vector<drawing::SheetEntry> tricks(const FigurePainter& painter, Scene room) {
  room.cookies = {scene::paint_cookie("disco"), scene::paint_cookie("beacon")};
  const Attenuation attenuation{1, 0, 0.5};
  room.lights = {coloured(lamp({0, 2.4, -1}, attenuation), {0.9, 0.1, 0.1}, {0, -1, 0}),
                 coloured(lamp({0, 2.4, -1}, attenuation), {0.1, 0.8, 0.2}, {0, -1, 0}),
                 coloured(lamp({0, 2.4, -1}, attenuation), {0.2, 0.3, 1.0}, {0, -1, 0})};
  for (std::size_t i = 0; i < 3; ++i) room.cookie_uses[i] = {.cookie = 0, .roll = double(i) * 4 * kDegree};
  drawing::SheetEntry disco = painter.draw(room, along("radial"), {"groovy disco light"});
  room.lights = {coloured(lamp({-0.4, 1.7, -1.5}, attenuation), {2.0, 1.0, 0.1}, {0, -1, 0})};
  room.cookie_uses = {{0, {.cookie = 1, .roll = 60 * kDegree}}};
  return {std::move(disco), painter.draw(room, along("radial"), {"rotating police beacon"})};
}

/// A room's lamps, each with stencil shadows.
render::Picture with_stencil_shadows(const FigurePainter& painter, const Scene& room) {
  const auto draw = [&](std::vector<PlacedLight> lights) {
    Scene lit = room;
    lit.lights = std::move(lights);
    render::Renderer renderer(lit, painter.width(), painter.height(), along("accumulate", {.samples = 1}));
    renderer.draw(render::LightPoints::off);
    return renderer.read();
  };
  const render::Picture dark = draw({});
  render::Picture sum = dark;
  for (const PlacedLight& light : room.lights) {
    const render::Picture lit = draw({light});
    const render::Picture seen = draw_stencil_shadow(room, light.position, painter.width(), painter.height());
    for (std::size_t i = 0; i < sum.rgb.size(); ++i) sum.rgb[i] += seen.rgb[i] * (lit.rgb[i] - dark.rgb[i]);
  }
  return sum;
}

}  // namespace

Rows frazier_figures(const FigurePainter& painter) {
  Scene room = scene::read_scene(scene::bundled_scene_path("room"));
  for (PlacedLight& light : room.lights) light.light.color *= 0.3;  // his back buffer ends at 1
  const auto draw = [&](std::vector<PlacedLight> lights, const RenderSettings& settings,
                        std::vector<std::string> caption) {
    Scene lit = room;
    lit.lights = std::move(lights);
    return painter.draw(lit, settings, std::move(caption));
  };
  RenderSettings unlit;
  unlit.path = &render::unlit_path();
  const PlacedLight red = coloured(lamp({0, 1.4, -1}, {1, 0, 1}), {0.9, 0.1, 0.1});
  const PlacedLight yellow = coloured(lamp({-2.4, 1.8, -3}, {1, 0, 0.6}), {0.9, 0.8, 0.1});
  Rows rows = maps();
  rows.push_back({painter.draw(room, unlit, {"base texture only"}),
                  draw({red}, along("radial"), {"red point light in the middle of the room"}),
                  draw({yellow}, along("radial"), {"slightly larger yellow point light at its edge"})});
  const Attenuation far{1, 0, 0.1};
  rows.push_back({draw({coloured(lamp({0.2, 1.8, 3}, far, kSpot), {0.9, 0.9, 0.8}, {0, -0.02, -1})},
                       along("radial-plane"), {"spot light facing the far wall"}),
                  draw({coloured(lamp({0, 0.9, 1}, far, kSpot), {0.9, 0.9, 0.8}, {0, 0.8, -1})}, along("radial-plane"),
                       {"spot light on the curved ceiling"}),
                  draw({coloured(lamp({-1.3, 1.7, 2.6}, {1, 0, 0.6}, kSpot), {0.9, 0.05, 0.05}, {-0.9, -0.2, -1})},
                       along("radial-plane"), {"spot light close up: its red frustum"})});
  rows.push_back(tricks(painter, room));
  std::vector<PlacedLight> many{red, yellow,
                                coloured(lamp({0.2, 1.8, 3}, far, kSpot), {0.2, 0.35, 0.9}, {0.25, -0.05, -1}),
                                coloured(lamp({-0.6, 1.8, 3}, far, kSpot), {0.2, 0.8, 0.3}, {0.1, 0.05, -1})};
  for (PlacedLight& light : many) light.light.color *= 0.6;
  rows.push_back(
      {draw(many, along("light-map"), {"dynamic multi-light light map, without texture"}),
       draw(many, along("accumulate"), {"multiplied by the base texture"}),
       draw(many, along("radial-plane"), {"the same in one pass of four lights", "z^2 of each a constant"})});
  const std::vector<PlacedLight> spots{many[2], many[3]};
  rows.push_back({draw(spots, along("accumulate"), {"two spot lights that overlap, accumulated"}),
                  draw(spots, {.skipping = render::Skipping::off, .path = &frazier_in_two_passes()},
                       {"two passes a light: artefacts", "each light's cube map filters the other's light"})});
  rows.emplace_back();
  for (const auto& [name, maps] : {std::pair{"one spot map for every angle, by its scale", render::ConeMaps::one_disc},
                                   {"a map of each light's own cone", render::ConeMaps::scaled}}) {
    rows.back().push_back(painter.draw(room, along("radial", {.papers = {.cone_maps = maps}}), {name}));
  }
  rows.push_back({painter.draw(room, along("radial"), {"his lights, the surface's orientation ignored"}),
                  painter.draw(room, {.path = &frazier_with_bumps()},
                               {"improvements: bump mapping", "with gloss maps and specular highlights"})});
  rows.push_back({FigurePainter::entry(with_stencil_shadows(painter, room),
                                       {"improvements: \"stencil shadowing\"", "one sample a pixel"}),
                  painter.draw(room, along("accumulate", {.shadows = render::Shadows::surfaces}),
                               {"improvements: \"depth buffer shadow casting\"", "as litfog casts shadows"})});
  return rows;
}

}  // namespace litfog::papers
