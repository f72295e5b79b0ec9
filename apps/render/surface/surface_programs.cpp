// SPDX-License-Identifier: Apache-2.0
#include "render/surface/surface_programs.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <utility>
#include <vector>

#include "render/gpu/depth.h"
#include "render/gpu/render_shaders.h"

namespace litfog::render {
namespace {

/// Settings, which a renderer never changes, as constants.
std::string settings_constants(const RenderSettings& settings) {
  return fmt::format(
      "const bool has_infinite_viewer = {};\n"
      "const bool is_lamp_leg_fogged = {};\n"
      "const bool are_lit_beyond_ends = {};  // surfaces\n"
      "const bool has_scattered_light = {};\n"
      "const bool has_shafts = {};\n"
      "const float light_ambient = {};\n"
      "const int spot_edge_hard = 0;\n"
      "const int spot_edge_lerp = 1;\n"
      "const int spot_edge = {};\n",
      settings.papers.has_infinite_viewer, settings.fog_lighting == FogLighting::airlight,
      lights_surfaces_beyond_end(settings), has_scattered_light(settings), settings.shadows == Shadows::shafts,
      settings.papers.light_ambient, int(settings.papers.spot_edge));
}

}  // namespace

SurfaceProgram::SurfaceProgram(gl::Program linked)
    : program(std::move(linked)),
      world_from_model(program.uniform("world_from_model")),
      bounds_low(program.uniform("bounds_low")),
      bounds_high(program.uniform("bounds_high")),
      light_list_range(program.uniform("light_list_range")),
      uniform_lights(program.uniform("uniform_lights")),
      light_flags(program.uniform("light_flags")),
      uniform_casters(program.uniform("uniform_casters")),
      cone_from_world(program.uniform("cone_from_world")) {}

SurfacePrograms::SurfacePrograms(const scene::Scene& scene, const RenderSettings& settings)
    : scene_(scene),
      has_cookies_(!scene.cookies.empty()),
      has_shadows_(settings.shadows != Shadows::none),
      should_test_depth_late_(render::should_test_depth_late(settings.samples)),
      samples_(settings.samples == 1 ? "#define ONE_SAMPLE\n" : ""),
      settings_(settings_constants(settings)),
      path_shaders_(settings.path->shaders) {}

SurfaceProgram& SurfacePrograms::program(const ShaderVariant& variant) {
  const std::pair key(variant, scene_.environment.has_moon());
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  const std::string pass = pass_constants(variant);
  std::vector<gl::ShaderSource> files = scene_shaders(has_cookies_, has_shadows_);
  files.insert(files.end(), path_shaders_.begin(), path_shaders_.end());
  const std::string environment = fmt::format("const bool has_moon = {};\n", key.second) + settings_;
  files.push_back({"generated/environment.glsl", environment});
  files.push_back({"generated/pass.glsl", pass});
  const std::string material =
      samples_ + (variant.tests_depth_late ? "#define TESTS_DEPTH_LATE\n" : "") + material_constants(variant.material);
  files.push_back({"generated/material.glsl", material});
  const std::string pass_fragment = fmt::format("#include \"{}\"\n", variant.pass->fragment);
  files.push_back({"generated/pass.frag", pass_fragment});
  const bool is_plain = variant.material == MaterialFeatures{} && !variant.tests_depth_late;
  gl::Program program(variant.pass->vertex, variant.pass->geometry,
                      is_plain ? variant.pass->fragment : std::string_view("material.frag"), files);
  return programs_.emplace(key, std::move(program)).first->second;
}

}  // namespace litfog::render
