// SPDX-License-Identifier: Apache-2.0
#include "render/lighting_path.h"

#include <algorithm>

namespace litfog::render {
namespace {

std::vector<LightingPath> make_paths() {
  const std::string cg_tutorial = "Randima Fernando and Mark Kilgard 2003, \"The Cg Tutorial\"";
  const std::string frazier = "Ronald Frazier 2000, \"Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL\"";
  const std::string hales = "Steven Hales 2004, \"Realtime Pixel Lighting Using Fragment Programs\"";
  const std::string lacroix =
      "Jason Lacroix 2005, \"Let There Be Light!: A Unified Lighting Technique for a New Generation of Games\"";
  return {
      {.name = "unified",
       .description = "everything per fragment in world space, normal maps, any number of lights",
       .source = lacroix + ", listings 2.1 to 2.3",
       .has_normal_maps = true,
       .takes_airlight = true,
       .passes = {{.vertex = "surface.vert",
                   .fragment = "unified.frag",
                   .lights = {.kind = LightFeed::Kind::all},
                   .constants_from_vertices = true}}},
      {.name = "lookup-3d",
       .description = "range from a 3-D texture, angle from a cube map whose +x face spans the cone",
       .source = hales,
       .surface = SurfaceModel::diffuse,
       .evaluation = Evaluation::lookup,
       .takes_airlight = true,
       .maps = LightMapSet::volume,
       .passes = {{.vertex = "light_coordinates.vert",
                   .fragment = "lookup_3d.frag",
                   .lights = {.kind = LightFeed::Kind::batches, .batch_size = 4, .bring_fog = true}}}},
      {.name = "lookup-2d",
       .description = "range from two 2-D textures, angle from the same cube map",
       .source = hales,
       .surface = SurfaceModel::diffuse,
       .evaluation = Evaluation::lookup,
       .takes_airlight = true,
       .maps = LightMapSet::pair,
       .passes = {{.vertex = "light_coordinates.vert",
                   .fragment = "lookup_2d.frag",
                   .lights = {.kind = LightFeed::Kind::batches, .batch_size = 4, .bring_fog = true}}}},
      {.name = "radial",
       .description = "1 - r^2 / E^2 from a 2-D and a 1-D texture, spots from a cube map",
       .source = frazier,
       .surface = SurfaceModel::unshaded,
       .range = RangeLaw::radial,
       .evaluation = Evaluation::lookup,
       .takes_airlight = true,
       .maps = LightMapSet::radial,
       .passes = {{.vertex = "light_coordinates.vert",
                   .fragment = "radial.frag",
                   .lights = {.kind = LightFeed::Kind::batches, .batch_size = 4}}}},
      {.name = "radial-plane",
       .description = "the same from one 2-D texture: each plane rotated to z = 0, z^2 a constant",
       .source = frazier,
       .surface = SurfaceModel::unshaded,
       .range = RangeLaw::radial,
       .evaluation = Evaluation::lookup,
       .takes_airlight = true,
       .maps = LightMapSet::radial,
       .passes = {{.vertex = "radial_plane.vert",
                   .geometry = "radial_plane.geom",
                   .fragment = "radial_plane.frag",
                   .lights = {.kind = LightFeed::Kind::batches, .batch_size = 4}}}},
      {.name = "accumulate",
       .description = "lights added one by one over the ambient light, then multiplied by the base texture",
       .source = frazier,
       .surface = SurfaceModel::unshaded,
       .range = RangeLaw::radial,
       .evaluation = Evaluation::lookup,
       .takes_airlight = true,
       .maps = LightMapSet::radial,
       .passes = {{.vertex = "light_coordinates.vert", .fragment = "accumulate_ambient.frag", .shows_fog = false},
                  {.vertex = "light_coordinates.vert",
                   .fragment = "accumulate_light.frag",
                   .blend = Blend::add,
                   .lights = {.kind = LightFeed::Kind::batches, .batch_size = 1},
                   .shows_fog = false},
                  {.vertex = "light_coordinates.vert",
                   .fragment = "accumulate_texture.frag",
                   .blend = Blend::multiply,
                   .shows_fog = false},
                  {.vertex = "light_coordinates.vert", .fragment = "accumulate_fog.frag", .blend = Blend::over}}},
      {.name = "vertex",
       .description = "the Basic model at the vertices, any number of lights",
       .source = cg_tutorial + ", section 5.2; " + lacroix + ", listing 1.1",
       .evaluation = Evaluation::vertex,
       .passes = {{.vertex = "vertex.vert", .fragment = "vertex.frag", .lights = {.kind = LightFeed::Kind::all}}}},
      {.name = "mixed",
       .description = "diffuse at the vertices, specular at the fragments",
       .source = cg_tutorial + ", chapter 5, exercise 6",
       .evaluation = Evaluation::vertex,
       .passes = {{.vertex = "mixed.vert",
                   .fragment = "mixed.frag",
                   .lights = {.kind = LightFeed::Kind::batches, .batch_size = 4, .lists_rest = true}}}},
      {.name = "tangent",
       .description = "normal maps, the lights carried into tangent space at the vertices, four a pass",
       .source = lacroix + ", listing 1.2",
       .evaluation = Evaluation::vertex,
       .has_normal_maps = true,
       .takes_airlight = true,
       .passes = {{.vertex = "tangent.vert",
                   .fragment = "tangent.frag",
                   .lights = {.kind = LightFeed::Kind::batches, .batch_size = 4}}}},
      {.name = "legacy",
       .description = "diffuse light at the vertices, texture and fog of one colour: the cost baseline",
       .source = hales + ", table 1",
       .surface = SurfaceModel::diffuse,
       .evaluation = Evaluation::vertex,
       .has_lit_fog = false,
       .passes = {{.vertex = "legacy.vert", .fragment = "legacy.frag", .lights = {.kind = LightFeed::Kind::all}}}},
  };
}

}  // namespace

std::span<const LightingPath> lighting_paths() {
  static const std::vector<LightingPath> kPaths = make_paths();
  return kPaths;
}

const LightingPath& unlit_path() {
  static const LightingPath kPath{.name = "unlit",
                                  .description = "the base texture alone",
                                  .source = {},
                                  .has_lit_fog = false,
                                  .passes = {{.vertex = "unlit.vert", .fragment = "unlit.frag", .shows_fog = false}}};
  return kPath;
}

const LightingPath* find_lighting_path(std::string_view name) {
  const auto paths = lighting_paths();
  const auto found = std::ranges::find(paths, name, &LightingPath::name);
  return found == paths.end() ? nullptr : &*found;
}

}  // namespace litfog::render
