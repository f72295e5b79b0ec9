// SPDX-License-Identifier: Apache-2.0
#include "papers/paper_programs.h"

#include <array>

namespace litfog::papers {

using render::Blend;
using render::Evaluation;
using render::LightFeed;
using render::LightingPath;
using render::LightMapSet;
using render::RangeLaw;
using render::SurfaceModel;

const LightingPath& cg_at_vertices(Space space) {
  const auto make = [](std::string_view vertex) {
    return LightingPath{
        .name = "cg-vertex",
        .range = RangeLaw::unbounded,
        .evaluation = Evaluation::vertex,
        .has_reference = false,
        .passes = {{.vertex = vertex, .fragment = "path/vertex.frag", .lights = {.kind = LightFeed::Kind::all}}},
        .shaders = paper_shaders()};
  };
  static const std::array kPaths{make("cg_world.vert"), make("cg_object.vert"), make("cg_eye.vert")};
  return kPaths[std::size_t(space)];
}

const LightingPath& cg_with_two_colors() {
  static const LightingPath kPath{.name = "cg-two-colors",
                                  .range = RangeLaw::unbounded,
                                  .has_reference = false,
                                  .passes = {{.vertex = "surface.vert",
                                              .fragment = "cg_two_colors.frag",
                                              .lights = {.kind = LightFeed::Kind::all}}},
                                  .shaders = paper_shaders()};
  return kPath;
}

const LightingPath& frazier_in_two_passes() {
  constexpr LightFeed kOneByOne{.kind = LightFeed::Kind::batches, .batch_size = 1};
  constexpr std::string_view kVertex = "path/light_coordinates.vert";
  static const LightingPath kPath{
      .name = "frazier-two-passes",
      .surface = SurfaceModel::unshaded,
      .range = RangeLaw::radial,
      .evaluation = Evaluation::lookup,
      .has_lit_fog = false,
      .has_reference = false,
      .maps = LightMapSet::radial,
      .passes = {{.vertex = kVertex, .fragment = "path/accumulate_ambient.frag", .shows_fog = false},
                 {.vertex = kVertex,
                  .fragment = "frazier_point.frag",
                  .blend = Blend::add,
                  .lights = kOneByOne,
                  .shows_fog = false},
                 {.vertex = kVertex,
                  .fragment = "frazier_filter.frag",
                  .blend = Blend::multiply,
                  .lights = kOneByOne,
                  .shows_fog = false},
                 {.vertex = kVertex,
                  .fragment = "path/accumulate_texture.frag",
                  .blend = Blend::multiply,
                  .shows_fog = false}},
      .shaders = paper_shaders()};
  return kPath;
}

const LightingPath& frazier_with_bumps() {
  static const LightingPath kPath{.name = "frazier-bumps",
                                  .range = RangeLaw::radial,
                                  .evaluation = Evaluation::lookup,
                                  .has_normal_maps = true,
                                  .has_reference = false,
                                  .maps = LightMapSet::radial,
                                  .passes = {{.vertex = "frazier_bump.vert",
                                              .fragment = "frazier_bump.frag",
                                              .lights = {.kind = LightFeed::Kind::batches, .batch_size = 4}}},
                                  .shaders = paper_shaders()};
  return kPath;
}

}  // namespace litfog::papers
