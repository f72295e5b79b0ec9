// SPDX-License-Identifier: Apache-2.0
#include "render/surface_painter.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <string>

#include "render/demo_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"

namespace litfog::render {
namespace {

std::string glsl(const glm::vec3& v) { return fmt::format("vec3({}, {}, {})", v.x, v.y, v.z); }

/// What stays the same in a scene, as constants, environment.glsl: some drivers look a uniform up for every fragment.
std::string environment_constants(const scene::Environment& environment, const RenderSettings& settings) {
  return fmt::format(
      "const vec3 ambient_light = {};\n"
      "const bool has_moon = {};  // the directional light\n"
      "const vec3 moon_direction = {};\n"
      "const vec3 moon_color = {};\n"
      "const bool has_infinite_viewer = {};\n",
      glsl(environment.ambient_light), environment.moon_color != glm::vec3(0.0f), glsl(environment.moon_direction),
      glsl(environment.moon_color), settings.has_infinite_viewer);
}

/// The scene's shader files, and what environment.glsl and pass.glsl are for this program.
std::vector<gl::ShaderSource> shader_files(bool has_cookies, const std::string& environment, const std::string& pass) {
  std::vector<gl::ShaderSource> files = scene_shaders(has_cookies);
  files.push_back({"environment.glsl", environment});
  files.push_back({"pass.glsl", pass});
  return files;
}

/// The most lights handed over to light the fog, and to a pass that takes all; more are listed.
constexpr std::size_t kMostHandedOver = 16;

/// For how many lights a shader is compiled that takes so many. A driver may take a second to compile it, and a frame
/// needs shaders for many numbers of lights.
std::size_t room_for(std::size_t lights) {
  assert(lights <= kMostHandedOver);
  constexpr std::array<std::size_t, 6> kRooms{0, 1, 2, 4, 8, kMostHandedOver};
  return *std::ranges::lower_bound(kRooms, lights);
}

/// "DO(0) DO(1)": a loop over lights unrolled.
std::string unrolled(std::size_t count) {
  std::string calls;
  for (std::size_t i = 0; i < count; ++i) calls += fmt::format(" DO({})", i);
  return calls;
}

void set_blend(Blend blend) {
  (blend == Blend::replace ? glDisable : glEnable)(GL_BLEND);
  switch (blend) {
    case Blend::replace:
      break;
    case Blend::add:
      glBlendFunc(GL_ONE, GL_ONE);
      break;
    case Blend::multiply:
      glBlendFunc(GL_DST_COLOR, GL_ZERO);
      break;
    case Blend::over:
      glBlendFunc(GL_ONE, GL_SRC_ALPHA);
      break;
  }
}

/// The first pass of a surface decides its samples. The others draw each of them once more, though several of its
/// triangles may have the same depth there: the stencil counts the passes that a sample has had. Where they have, the
/// first pass leaves the last triangle; so the others draw the triangles in reverse, and the first to come is the same.
void select_samples(int pass) {
  glDepthFunc(pass == 0 ? GL_LEQUAL : GL_EQUAL);
  glDepthMask(pass == 0 ? GL_TRUE : GL_FALSE);
  glStencilFunc(pass == 0 ? GL_ALWAYS : GL_EQUAL, pass == 0 ? 0 : (pass - 1) & 0xff, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, pass == 0 ? GL_REPLACE : GL_INCR_WRAP);
}

}  // namespace

std::string SurfacePainter::Variant::constants() const {
  std::vector<int> profiles(fog_lights.count, fog_lights.profile);
  profiles.insert(profiles.end(), lights.count, lights.profile);
  const std::size_t first_light = shares_lights ? 0 : fog_lights.count;
  const std::size_t lights_in_pass = profiles.size() - first_light;
  if (profiles.empty()) profiles.push_back(kAnyProfile);  // arrays may not be empty
  return fmt::format(
      "const int hand_size = {};\n"
      "const int profiles[hand_size] = int[]({});\n"
      "const int any_profile = {};\n"
      "const int first_light_in_pass = {};\n"
      "const int lights_in_pass = {};\n"
      "const int batch_size = max(lights_in_pass, 1);\n"
      "const bool has_listed_lights = {};  // too many to be handed over\n"
      "const bool has_listed_fog_lights = {};\n"
      "const bool is_first_pass = {};\n"
      "#define EACH_LIGHT(DO){}\n"
      "#define EACH_FOG_LIGHT(DO){}\n",
      profiles.size(), fmt::join(profiles, ", "), kAnyProfile, first_light, lights_in_pass, has_listed_lights,
      has_listed_fog_lights, is_first, unrolled(lights_in_pass), unrolled(fog_lights.count));
}

SurfacePainter::SurfaceProgram::SurfaceProgram(const Variant& variant, const scene::Scene& scene,
                                               const RenderSettings& settings)
    : program(variant.pass->vertex, variant.pass->geometry, variant.pass->fragment,
              shader_files(!scene.cookies.empty(), environment_constants(scene.environment, settings),
                           variant.constants())),
      world_from_model(program.uniform("world_from_model")),
      bounds_low(program.uniform("bounds_low")),
      bounds_high(program.uniform("bounds_high")),
      light_list_range(program.uniform("light_list_range")),
      handed_lights(program.uniform("handed_lights")),
      cone_from_world(program.uniform("cone_from_world")) {}

SurfacePainter::SurfacePainter(const scene::Scene& scene, const SceneLights& lights,
                               const gl::FogLightBuffer& fog_lights, const RenderSettings& settings)
    : scene_(scene),
      lights_(lights),
      fog_light_buffer_(fog_lights),
      settings_(settings),
      surfaces_(scene, lights.local(), lights.local_extents(), settings.skipping),
      maps_(settings.path->maps, scene, lights, settings.map_size) {}

void SurfacePainter::set_fog(std::span<const FogIntensity> solutions) {
  fog_intensities_.clear();
  for (const FogIntensity& solution : solutions) fog_intensities_.push_back(float(solution.intensity));
}

FrameCounts SurfacePainter::draw(const LightingPath& path, const glm::mat4& clip_from_world) {
  ++frame_;
  clip_from_world_ = clip_from_world;
  used_ = nullptr;
  bound_ = nullptr;
  has_several_passes_ = path.has_several_passes();
  if (has_several_passes_) glEnable(GL_STENCIL_TEST);
  select_samples(0);
  surfaces_.bind_meshes();
  surfaces_.bind_light_list(kLightListUnit);
  lights_.bind_local(kLocalLightUnit);
  FrameCounts counts;
  const Frustum frustum = make_frustum(clip_from_world);
  for (const Surface& surface : surfaces_.surfaces()) {
    if (settings_.skipping == Skipping::on && !can_see(frustum, surface.bounds)) {
      ++counts.chunks_skipped;
      continue;
    }
    draw_surface(path, surface);
    ++counts.chunks_drawn;
    counts.lights_listed += std::size_t(surface.list_count);
    counts.lights_skipped += lights_.local().size() - std::size_t(surface.list_count);
  }
  glDisable(GL_STENCIL_TEST);
  set_blend(Blend::replace);
  select_samples(0);
  return counts;
}

/// All passes of a surface before the next surface: where two lie in one plane, the later one hides the earlier.
void SurfacePainter::draw_surface(const LightingPath& path, const Surface& surface) {
  if (std::ranges::any_of(path.passes, [](const SurfacePass& pass) { return pass.lights != 0; })) find_lights(surface);
  if (std::ranges::any_of(path.passes, &SurfacePass::shows_fog)) find_fog_lights(surface);
  drawn_passes_ = 0;
  for (const SurfacePass& pass : path.passes) {
    if (pass.lights == 0) {
      draw_pass(surface, {.pass = &pass}, {});
    } else if (pass.lights == kAllLights) {
      const bool are_too_many = reaching_.size() > kMostHandedOver;
      draw_pass(surface, {.pass = &pass, .has_listed_lights = are_too_many},
                are_too_many ? std::span<const std::int32_t>() : reaching_);
    } else {
      std::span<const std::int32_t> rest = reaching_;
      bool is_first = pass.blend == Blend::replace;  // which is drawn even without lights
      while (is_first || !rest.empty()) {
        const auto batch = rest.first(batch_length(rest, pass.lights));
        const bool are_listed = is_first && pass.lists_all && batch.size() < rest.size();
        draw_pass(surface, {.pass = &pass, .is_first = is_first, .has_listed_lights = are_listed}, batch);
        rest = rest.subspan(batch.size());
        is_first = false;
      }
    }
  }
}

std::size_t SurfacePainter::batch_length(std::span<const std::int32_t> lights, int most) const {
  std::size_t length = std::min(lights.size(), std::size_t(most));
  if (settings_.path->maps == LightMapSet::none) return length;
  while (length > 1 && maps_.kind(std::size_t(lights[length - 1])) != maps_.kind(std::size_t(lights[0]))) --length;
  return length;
}

void SurfacePainter::find_lights(const Surface& surface) {
  const auto local = surfaces_.lights_of(surface);
  reaching_.assign(local.begin(), local.end());
  for (std::size_t i = lights_.local().size(); i < lights_.size(); ++i) {
    const bool reaches =
        settings_.skipping == Skipping::off || can_reach(lights_.light(i), lights_.extent(i), surface.bounds);
    if (reaches) reaching_.push_back(std::int32_t(i));
  }
  if (settings_.path->maps != LightMapSet::none) {
    std::ranges::stable_sort(reaching_, {}, [&](std::int32_t light) { return maps_.kind(std::size_t(light)); });
  }
}

/// All or none: each number of them is another shader.
void SurfacePainter::find_fog_lights(const Surface& surface) {
  fog_lights_.clear();
  const std::size_t first = lights_.local().size();
  bool shows = settings_.skipping == Skipping::off;
  for (std::size_t i = 0; i < fog_intensities_.size(); ++i) {
    if (settings_.skipping == Skipping::on && fog_intensities_[i] <= 0) continue;
    constexpr double kFarthest = std::numeric_limits<double>::infinity();  // fog is lit as far as it is seen
    shows = shows || can_reach(lights_.light(first + i), kFarthest, surface.bounds);
    fog_lights_.push_back(std::int32_t(first + i));
  }
  if (!shows) fog_lights_.clear();
}

FogLight SurfacePainter::light_handed_over(std::int32_t light) const {
  FogLight packed = lights_.packed(std::size_t(light));
  const auto carried = light - std::int32_t(lights_.local().size());
  if (carried >= 0) packed.color_intensity.w = fog_intensities_[std::size_t(carried)];
  return packed;
}

SurfacePainter::HandedLights SurfacePainter::round_up(std::size_t first) {
  constexpr std::size_t kMostKnown = 2;  // of more, a shader for each profile were too many
  const std::size_t lights = handed_.size() - first;
  handed_.resize(first + room_for(lights));
  HandedLights handed{.count = handed_.size() - first};
  if (lights == 0 || handed.count > kMostKnown) return handed;
  const std::span<FogLight> known = std::span(handed_).subspan(first);
  const float profile = known.front().axis_profile.w;
  const bool is_common =
      std::ranges::all_of(known, [&](const FogLight& light) { return light.axis_profile.w == profile; });
  if (is_common) handed.profile = int(profile);
  return handed;
}

void SurfacePainter::draw_pass(const Surface& surface, Variant variant, std::span<const std::int32_t> batch) {
  const bool has_maps = settings_.path->maps != LightMapSet::none;
  handed_.clear();
  if (variant.is_first && variant.pass->shows_fog) {
    variant.has_listed_fog_lights = fog_lights_.size() > kMostHandedOver;
    if (!variant.has_listed_fog_lights) {
      for (const std::int32_t light : fog_lights_) handed_.push_back(light_handed_over(light));
      variant.fog_lights = round_up(0);
    }
  }
  const std::size_t first = handed_.size();
  // What the fog's lights and the surface's have in common is computed once where the pass takes all.
  variant.shares_lights = variant.pass->lights == kAllLights && !variant.has_listed_lights && first > 0;
  for (const std::int32_t light : batch) {
    if (variant.shares_lights && std::ranges::find(fog_lights_, light) != fog_lights_.end()) continue;
    handed_.push_back(light_handed_over(light));
  }
  if (has_maps) {  // which hold the cones
    variant.lights.count = handed_.size() - first;
  } else {
    variant.lights = round_up(first);
  }

  const SurfaceProgram& program = use(variant, *surface.material);
  const bool is_later = drawn_passes_ > 0;
  if (has_several_passes_) select_samples(drawn_passes_++);
  glUniformMatrix4fv(program.world_from_model, 1, GL_FALSE, glm::value_ptr(surface.world_from_model));
  glUniform3fv(program.bounds_low, 1, glm::value_ptr(surface.bounds.low));
  glUniform3fv(program.bounds_high, 1, glm::value_ptr(surface.bounds.high));
  glUniform2i(program.light_list_range, surface.list_first, surface.list_count);
  if (!handed_.empty()) {
    glUniform4fv(program.handed_lights, GLsizei(5 * handed_.size()), glm::value_ptr(handed_[0].position_extent));
  }
  if (has_maps && !batch.empty()) {
    batch_cones_.clear();
    for (const std::int32_t light : batch) batch_cones_.push_back(maps_.cone_from_world(std::size_t(light)));
    glUniformMatrix3fv(program.cone_from_world, GLsizei(batch_cones_.size()), GL_FALSE,
                       glm::value_ptr(batch_cones_[0]));
    maps_.bind(maps_.kind(std::size_t(batch[0])));
  }
  surfaces_.draw(surface, is_later ? TriangleOrder::reversed : TriangleOrder::stored);
}

SurfacePainter::SurfaceProgram& SurfacePainter::use(const Variant& variant, const SurfaceMaterial& material) {
  SurfaceProgram& program = programs_.try_emplace(variant, variant, scene_, settings_).first->second;
  if (&program != used_) {
    used_ = &program;
    program.program.use();
    set_blend(variant.pass->blend == Blend::replace && !variant.is_first ? Blend::add : variant.pass->blend);
  }
  if (program.frame != frame_) {
    program.frame = frame_;
    program.material = nullptr;
    fog_light_buffer_.bind(program.program, kFogLightBinding);
    set_uniform(program.program, "clip_from_world", clip_from_world_);
    set_uniform(program.program, "eye", scene_.camera.position);
    set_uniform(program.program, "infinite_viewer", glm::normalize(scene_.camera.position - scene_.camera.target));
    set_uniform(program.program, "is_flat_shaded", unsigned{settings_.is_flat_shaded});
    set_uniform(program.program, "albedo_map", kAlbedoUnit);
    set_uniform(program.program, "normal_map", kNormalUnit);
    set_uniform(program.program, "litfog_light_buffer", kLocalLightUnit);
    set_uniform(program.program, "light_list", kLightListUnit);
    set_uniform(program.program, "range_map", kRangeMapUnit);
    set_uniform(program.program, "distance_map", kDistanceMapUnit);
    set_uniform(program.program, "cone_map", kConeMapUnit);
    set_uniform(program.program, "cookies", kCookieUnit);
  }
  if (&material != bound_) {
    bound_ = &material;
    material.albedo.bind(kAlbedoUnit);
    material.normal.bind(kNormalUnit);
  }
  if (&material != program.material) {
    program.material = &material;
    set_uniform(program.program, "material", material.number);
    set_uniform(program.program, "tile_size", material.material.size_m);
    set_uniform(program.program, "specular", material.material.specular);
    set_uniform(program.program, "shininess", material.material.shininess);
    set_uniform(program.program, "emissive", material.material.emissive);
  }
  return program;
}

}  // namespace litfog::render
