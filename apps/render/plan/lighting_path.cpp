// SPDX-License-Identifier: Apache-2.0
#include "render/plan/lighting_path.h"

#include <algorithm>
#include <utility>

namespace litfog::render {
namespace {

constexpr std::string_view kCgTutorial = "Randima Fernando and Mark Kilgard 2003, \"The Cg Tutorial\"";
constexpr std::string_view kFrazier =
    "Ronald Frazier 2000, \"Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL\"";
constexpr std::string_view kHales = "Steven Hales 2004, \"Realtime Pixel Lighting Using Fragment Programs\"";
constexpr std::string_view kLacroix =
    "Jason Lacroix 2005, \"Let There Be Light!: A Unified Lighting Technique for a New Generation of Games\"";

std::string of(std::string_view paper, std::string_view place) { return std::string(paper).append(", ").append(place); }

constexpr LightFeed kAllLights{.kind = LightFeed::Kind::all};
constexpr std::string_view kCoordinates = "path/light_coordinates.vert";

/// A pass whose fragment shader adds up any number of lights.
SurfacePass per_fragment(std::string_view fragment, LightFeed lights = {}) {
  lights.kind = LightFeed::Kind::all;
  return {.vertex = "surface.vert", .fragment = fragment, .lights = lights};
}

/// A pass that looks up batches of lights in light maps.
SurfacePass looked_up(std::string_view fragment, LightFeed lights) {
  lights.kind = LightFeed::Kind::batches;
  return {.vertex = kCoordinates, .fragment = fragment, .lights = lights};
}

/// Frazier's ambient light, then his lights added one by one.
std::vector<SurfacePass> accumulated() {
  const SurfacePass ambient{.vertex = kCoordinates, .fragment = "path/accumulate_ambient.frag", .shows_fog = false};
  SurfacePass light = looked_up("path/accumulate_light.frag", {.batch_size = 1});
  light.blend = Blend::add;
  light.shows_fog = false;
  return {ambient, light};
}

/// accumulated(), multiplied by the base texture, then fog over it.
std::vector<SurfacePass> accumulated_with_texture() {
  std::vector<SurfacePass> passes = accumulated();
  passes.push_back({.vertex = kCoordinates,
                    .fragment = "path/accumulate_texture.frag",
                    .blend = Blend::multiply,
                    .shows_fog = false});
  passes.push_back({.vertex = kCoordinates, .fragment = "path/accumulate_fog.frag", .blend = Blend::over});
  return passes;
}

/// A path with light maps and a light bound.
LightingPath by_maps(std::string_view name, std::string_view description, std::string_view paper, LightMapSet maps,
                     std::vector<SurfacePass> passes) {
  const bool is_radial = maps == LightMapSet::radial;
  return {.name = name,
          .description = description,
          .source = std::string(paper),
          .surface = is_radial ? SurfaceModel::unshaded : SurfaceModel::diffuse,
          .range = is_radial ? RangeLaw::radial : RangeLaw::attenuation,
          .evaluation = Evaluation::lookup,
          .takes_airlight = true,
          .has_light_bound = true,
          .maps = maps,
          .passes = std::move(passes)};
}

/// `unified` with another pass.
LightingPath like_unified(std::string_view name, std::string_view description, std::string source, SurfacePass pass,
                          bool has_reference) {
  return {.name = name,
          .description = description,
          .source = std::move(source),
          .has_normal_maps = true,
          .takes_airlight = true,
          .takes_scattered_light = true,
          .has_reference = has_reference,
          .passes = {pass}};
}

std::vector<LightingPath> make_paths() {
  return {
      {.name = "unified",
       .description = "everything per fragment in world space, normal maps, any number of lights",
       .source = of(kLacroix, "listings 2.1 to 2.3"),
       .has_normal_maps = true,
       .takes_airlight = true,
       .takes_scattered_light = true,
       .has_light_bound = true,
       .passes = {per_fragment("path/unified.frag")}},
      by_maps("lookup-3d", "range from a 3-D texture, angle from a cube map whose +x face spans the cone", kHales,
              LightMapSet::volume, {looked_up("path/lookup_3d.frag", {.batch_size = 4, .bring_fog = true})}),
      by_maps("lookup-2d", "range from two 2-D textures, angle from the same cube map", kHales, LightMapSet::pair,
              {looked_up("path/lookup_2d.frag", {.batch_size = 4, .bring_fog = true})}),
      by_maps("radial", "1 - r^2 / E^2 from a 2-D and a 1-D texture, spots from a cube map", kFrazier,
              LightMapSet::radial, {looked_up("path/radial.frag", {.batch_size = 4})}),
      by_maps("radial-plane", "the same from one 2-D texture: each plane rotated to z = 0, z^2 a constant", kFrazier,
              LightMapSet::radial,
              {{.vertex = "path/radial_plane.vert",
                .geometry = "path/radial_plane.geom",
                .fragment = "path/radial_plane.frag",
                .lights = {.kind = LightFeed::Kind::batches, .batch_size = 4}}}),
      by_maps("accumulate", "lights added one by one over the ambient light, then multiplied by the base texture",
              kFrazier, LightMapSet::radial, accumulated_with_texture()),
      {.name = "vertex",
       .description = "the Basic model at the vertices, any number of lights",
       .source = of(kCgTutorial, "section 5.2; ") + of(kLacroix, "listing 1.1"),
       .evaluation = Evaluation::vertex,
       .passes = {{.vertex = "path/vertex.vert", .fragment = "path/vertex.frag", .lights = kAllLights}}},
      {.name = "mixed",
       .description = "diffuse at the vertices, specular at the fragments",
       .source = of(kCgTutorial, "chapter 5, exercise 6"),
       .evaluation = Evaluation::vertex,
       .passes = {{.vertex = "path/mixed.vert",
                   .fragment = "path/mixed.frag",
                   .lights = {.kind = LightFeed::Kind::batches, .batch_size = 4, .lists_rest = true}}}},
      {.name = "tangent",
       .description = "normal maps, the lights carried into tangent space at the vertices, five a pass",
       .source = of(kLacroix, "listing 1.2"),
       .evaluation = Evaluation::vertex,
       .has_normal_maps = true,
       .takes_airlight = true,
       .passes = {{.vertex = "path/tangent.vert",
                   .fragment = "path/tangent.frag",
                   .lights = {.kind = LightFeed::Kind::batches, .batch_size = 5}}}},
      {.name = "legacy",
       .description = "diffuse light at the vertices, texture and fog of one colour: the cost baseline",
       .source = of(kHales, "table 1"),
       .surface = SurfaceModel::diffuse,
       .evaluation = Evaluation::vertex,
       .has_lit_fog = false,
       .passes = {{.vertex = "path/legacy.vert", .fragment = "path/legacy.frag", .lights = kAllLights}}},
  };
}

std::vector<LightingPath> make_programs() {
  return {
      {.name = "sample",
       .description = "two headlights on one range look-up, the light as ambient, saturating arithmetic",
       .source = of(kHales, "sample fragment program"),
       .surface = SurfaceModel::unshaded,
       .evaluation = Evaluation::lookup,
       .has_reference = false,
       .pairs_lights = true,
       .maps = LightMapSet::volume,
       .passes = {looked_up("path/sample.frag", {.batch_size = 2, .bring_fog = true})}},
      {.name = "light-map",
       .description = "the lights of accumulate added over the ambient light, without texture and fog",
       .source = of(kFrazier, "\"Multiple Lights in a Scene\""),
       .surface = SurfaceModel::unshaded,
       .range = RangeLaw::radial,
       .evaluation = Evaluation::lookup,
       .has_lit_fog = false,
       .has_reference = false,
       .maps = LightMapSet::radial,
       .passes = accumulated()},
      {.name = "interpolated",
       .description = "unified without normal maps",
       .source = of(kLacroix, "listing 2.2"),
       .takes_airlight = true,
       .takes_scattered_light = true,
       .passes = {per_fragment("path/interpolated.frag")}},
      like_unified("nested", "unified, its lights in nested ifs that end at the first one whose flag is off",
                   of(kLacroix, "listings 3.1 and 3.2"), per_fragment("path/nested.frag", {.has_flags = true}), true),
      {.name = "lacroix",
       .description = "attenuation and N.L as printed, neither clamped nor cut; matt surfaces",
       .source = of(kLacroix, "equations 1 to 4, listings 2.1 and 2.2"),
       .surface = SurfaceModel::diffuse,
       .range = RangeLaw::unbounded,
       .has_reference = false,
       .passes = {per_fragment("path/lacroix.frag")}},
      like_unified("parallax", "unified, its textures shifted by their heights",
                   of(kLacroix, "\"Per-pixel normal map based lighting\""), per_fragment("path/parallax.frag"), false),
      {.name = "cg",
       .description = "attenuation as printed, neither clamped nor cut; hard, linear or smooth spots",
       .source = of(kCgTutorial, "examples 5-3 to 5-10"),
       .range = RangeLaw::unbounded,
       .has_reference = false,
       .passes = {per_fragment("path/cg.frag")}},
      like_unified("cook-torrance", "unified, its metals by facets", of(kCgTutorial, "chapter 5, further reading"),
                   per_fragment("path/cook_torrance.frag"), false),
      like_unified("anisotropic", "unified, its metals brushed", of(kCgTutorial, "chapter 5, exercise 7"),
                   per_fragment("path/anisotropic.frag"), false),
  };
}

}  // namespace

std::span<const LightingPath> lighting_paths() {
  static const std::size_t kCount = make_paths().size();
  return all_paths().first(kCount);
}

std::span<const LightingPath> all_paths() {
  static const std::vector<LightingPath> kPaths = [] {
    std::vector<LightingPath> paths = make_paths();
    std::ranges::move(make_programs(), std::back_inserter(paths));
    return paths;
  }();
  return kPaths;
}

const LightingPath& unlit_path() {
  static const LightingPath kPath{.name = "unlit",
                                  .has_lit_fog = false,
                                  .passes = {{.vertex = "unlit.vert", .fragment = "unlit.frag", .shows_fog = false}}};
  return kPath;
}

const LightingPath& light_count_path() {
  static const LightingPath kPath{
      .name = "light-count",
      .has_lit_fog = false,
      .passes = {{.vertex = "unlit.vert", .fragment = "light_count.frag", .shows_fog = false}}};
  return kPath;
}

const LightingPath& object_space_path() {
  static const LightingPath kPath = like_unified(
      "object-space", "unified, its normal maps in the space of their models",
      of(kLacroix, "\"Per-pixel normal map based lighting\""), per_fragment("path/object_space.frag"), false);
  return kPath;
}

const LightingPath& geometry_path(const LightingPath& other) {
  const auto make = [](std::string_view vertex, std::string_view geometry) {
    return LightingPath{
        .name = "geometry",
        .passes = {{.vertex = vertex, .geometry = geometry, .fragment = "geometry.frag", .shows_fog = false}}};
  };
  static const LightingPath kDirect = make("surface.vert", {});
  static const LightingPath kByGeometryShader = make("geometry_corner.vert", "geometry_corner.geom");
  return other.passes.front().geometry.empty() ? kDirect : kByGeometryShader;
}

const SurfacePass& fog_alone_pass() {
  static const SurfacePass kPass{.vertex = "surface.vert", .fragment = "fog_alone.frag"};
  return kPass;
}

const SurfacePass& depth_pass() {
  static const SurfacePass kPass{.vertex = "unlit.vert", .fragment = "depth.frag", .shows_fog = false};
  return kPass;
}

const LightingPath* find_lighting_path(std::string_view name) {
  const auto found = std::ranges::find(all_paths(), name, &LightingPath::name);
  return found == all_paths().end() ? nullptr : &*found;
}

}  // namespace litfog::render
