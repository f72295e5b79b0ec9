// SPDX-License-Identifier: Apache-2.0
#include "render/surface/surface_painter.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "render/gpu/light_uniforms.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"
#include "render/plan/fog_top.h"

namespace litfog::render {
namespace {

constexpr std::size_t kDrawnAtOnce = 500;  // surfaces drawn between two polls of the interruption

/// Stands for lights that a shader is compiled for and a surface lacks. Its attenuation is finite, because some paths
/// do not clamp it.
constexpr PackedLight kBlack{.kind = {.attenuation_extent = {1, 0, 0, 0}, .cone_scale_intensity = {}}, .instance = {}};

constexpr double kFarReach = 1e30;  // finite, so that times an extent of 0 it is 0

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

/// The first pass of a surface decides which samples it covers. Each later pass draws each of these once, because the
/// stencil counts a sample's passes. Of several triangles at the same depth, the first pass keeps the last one; later
/// passes keep the first one, so they draw the triangles in reverse order.
void select_samples(int pass) {
  glDepthFunc(pass == 0 ? GL_GEQUAL : GL_EQUAL);
  glDepthMask(pass == 0 ? GL_TRUE : GL_FALSE);
  glStencilFunc(pass == 0 ? GL_ALWAYS : GL_EQUAL, pass == 0 ? 0 : (pass - 1) & 0xff, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, pass == 0 ? GL_REPLACE : GL_INCR_WRAP);
}

MaterialFeatures features_of(const Surface& surface, const LightingPath& path) {
  const SurfaceMaterial& material = *surface.material;
  const bool is_pane = path.draws_panes() && material.is_pane();
  return {.is_flat = material.is_flat && path.has_normal_maps,
          .is_masked = material.material.least_coverage.has_value() && !is_pane,
          .is_pane = is_pane,
          .is_unlit = material.material.is_unlit,
          .has_emission_map = material.emission != nullptr,
          .has_second_texture = material.second != nullptr,
          .has_ambient = material.material.ambient && path.surface == SurfaceModel::basic,
          .has_details = surface.chunk->has_details};
}

void set_material_uniforms(const ShaderVariant& variant, const SurfaceMaterial& surface_material,
                           const gl::Program& program) {
  const scene::Material& material = surface_material.material;
  set_uniform(program, "material", surface_material.number);
  set_uniform(program, "tile_size", material.size_m);
  set_uniform(program, "second_tiles", material.size_m / material.second_size_m);
  set_uniform(program, "normal_scale", material.normal_scale);
  const std::optional<float> coverage = variant.material.is_pane ? material.opacity : material.least_coverage;
  set_uniform(program, "coverage", coverage.value_or(0));
  set_uniform(program, "relief", material.relief_m / material.size_m);
  if (material.ambient) set_uniform(program, "ambient_color", *material.ambient);
  set_uniform(program, "specular", material.specular);
  set_uniform(program, "shininess", material.shininess);
  set_uniform(program, "uniform_emissive", material.emissive);
  set_uniform(program, "metal_roughness", material.metal_roughness);
}

/// The number of leading surfaces that are drawn with the same GL state except their transforms.
std::size_t count_alike(const FramePlan& plan, std::span<const PlannedSurface> surfaces) {
  const PlannedSurface& first = surfaces[0];
  const auto is_alike = [&](const PlannedSurface& other) {
    const Surface& a = *first.surface;
    const Surface& b = *other.surface;
    return a.material == b.material && a.is_fog_lit == b.is_fog_lit && a.chunk->has_details == b.chunk->has_details &&
           first.is_fog_alone == other.is_fog_alone && std::ranges::equal(plan.lights_of(first), plan.lights_of(other));
  };
  return std::size_t(std::ranges::find_if_not(surfaces, is_alike) - surfaces.begin());
}

}  // namespace

/// State that draw() keeps between surfaces.
struct SurfacePainter::Frame {
  const LightingPath& path;
  const View& view;
  const FrameLight& light;
  std::size_t number;
  int passes_drawn = 0;  // for the current surface
  std::size_t bytes = 0;
  const SurfaceProgram* used = nullptr;
  const SurfaceMaterial* bound = nullptr;
  // For panes:
  bool draws_panes = false;
  const PaneAirlight* airlight = nullptr;
  std::size_t first = 0;  // the current surface's range of the sorted indices
  std::size_t count = 0;
};

/// The lights that a pass takes as uniforms: the fog's, then the surface's.
struct SurfacePainter::LightUniforms {
  std::vector<PackedLight> lights;
  std::vector<std::int32_t> casters;  // one per light; empty without shadows
};

SurfacePainter::SurfacePainter(const scene::Scene& scene, const SceneLights& lights,
                               const gl::FogLightBuffer& fog_lights, const RenderSettings& settings)
    : scene_(scene),
      lights_(lights),
      fog_light_buffer_(fog_lights),
      settings_(settings),
      surfaces_(scene, lights, settings.path_skipping(), settings.path->has_normal_maps),
      maps_(scene, lights, settings),
      programs_(scene, settings) {}

void SurfacePainter::set_lights() {
  surfaces_.set_lights(scene_, lights_, settings_.path_skipping());
  maps_ = LightMapStore(scene_, lights_, settings_);
}

void SurfacePainter::set_fog(std::size_t knots) {
  fog_lights_ = fog_lights(lights_, settings_.path_skipping());
  knots_ = knots;
}

std::size_t SurfacePainter::draw(const LightingPath& path, const FramePlan& plan, const View& view,
                                 const FrameLight& light, Interruption& interruption) {
  Frame frame{.path = path, .view = view, .light = light, .number = ++frames_};
  if (path.has_several_passes()) glEnable(GL_STENCIL_TEST);
  select_samples(0);
  surfaces_.meshes().bind();
  if (settings_.papers.early_rejection == EarlyRejection::depth_pass && &path == settings_.path &&
      !path.has_several_passes()) {
    draw_depths(frame, plan);
  }
  // With several passes, one surface is finished before the next, because the later of two coplanar ones hides the
  // earlier.
  const std::size_t most_alike = path.has_several_passes() ? 1 : kDrawnAtOnce;
  std::size_t drawn = kDrawnAtOnce;  // since the last poll
  for (std::span<const PlannedSurface> rest = plan.surfaces; !rest.empty();) {
    if (drawn >= kDrawnAtOnce) {
      if (interruption.has_come()) break;
      drawn = 0;
    }
    const auto alike = rest.first(count_alike(plan, rest.first(std::min(rest.size(), most_alike))));
    rest = rest.subspan(alike.size());
    drawn += alike.size();
    if (settings_.path->draws_panes() && alike[0].surface->material->is_pane()) continue;
    draw_surfaces(frame, alike, plan.lights_of(alike[0]));
  }
  glDisable(GL_STENCIL_TEST);
  set_blend(Blend::replace);
  select_samples(0);
  return frame.bytes;
}

void SurfacePainter::draw_depths(Frame& frame, const FramePlan& plan) {
  std::vector<PlannedSurface> opaque;
  std::ranges::copy_if(plan.surfaces, std::back_inserter(opaque), [](const PlannedSurface& planned) {
    const SurfaceMaterial& material = *planned.surface->material;
    return !material.material.least_coverage && !material.is_pane();
  });
  if (opaque.empty()) return;
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  const SurfaceProgram& program = use(frame, {.pass = &depth_pass()}, *opaque.front().surface->material);
  draw_triangles(frame, opaque, program, TriangleOrder::stored);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

std::size_t SurfacePainter::draw_panes(const LightingPath& path, const FramePlan& plan, const View& view,
                                       const FrameLight& light, const PaneAirlight* airlight) {
  struct Triangle {
    float distance;
    const PlannedSurface* surface;
    const SortedTriangle* triangle;
  };
  std::vector<Triangle> triangles;
  for (const PlannedSurface& surface : plan.surfaces) {
    const glm::mat4& world_from_model = surface.surface->world_from_model;
    for (const SortedTriangle& triangle : surface.surface->chunk->triangles) {
      const glm::vec3 middle(world_from_model * glm::vec4(triangle.middle, 1));
      triangles.push_back({glm::distance(middle, view.eye), &surface, &triangle});
    }
  }
  std::ranges::stable_sort(triangles, std::ranges::greater{}, &Triangle::distance);
  std::vector<std::uint32_t> indices;
  for (const Triangle& each : triangles) {
    indices.insert(indices.end(), each.triangle->indices.begin(), each.triangle->indices.end());
  }
  Frame frame{.path = path,
              .view = view,
              .light = light,
              .number = ++frames_,
              .bytes = indices.size() * sizeof(indices[0]),
              .draws_panes = true,
              .airlight = airlight};
  surfaces_.meshes().bind();
  surfaces_.meshes().bind_sorted(indices);
  for (std::size_t first = 0, next = 0; first < triangles.size(); first = next) {
    const PlannedSurface& surface = *triangles[first].surface;
    while (next < triangles.size() && triangles[next].surface == &surface) ++next;
    frame.first = 3 * first;
    frame.count = 3 * (next - first);
    draw_surfaces(frame, {&surface, 1}, plan.lights_of(surface));
  }
  return frame.bytes;
}

void SurfacePainter::draw_surfaces(Frame& frame, std::span<const PlannedSurface> alike,
                                   std::span<const std::int32_t> lights) {
  const PlannedSurface& planned = alike[0];
  frame.passes_drawn = 0;
  std::span<const std::int32_t> fog = planned.surface->is_fog_lit ? std::span(fog_lights_) : std::span<std::int32_t>{};
  if (planned.is_fog_alone) {
    draw_pass(frame, alike, {.pass = &fog_alone_pass()}, fog, {});
    return;
  }
  const std::vector<std::int32_t> grouped = frame.path.has_mapped_fog() ? with_fog_lights(lights, fog, maps_.kinds())
                                                                        : grouped_by_maps(lights, maps_.kinds());
  if (frame.path.has_mapped_fog()) fog = {};
  for (const SurfacePass& pass : frame.path.passes) {
    std::span<const std::int32_t> rest = grouped;
    switch (pass.lights.kind) {
      case LightFeed::Kind::none:
        draw_pass(frame, alike, {.pass = &pass}, fog, {});
        break;
      case LightFeed::Kind::all: {
        const bool are_listed = rest.size() > (pass.lights.has_flags ? kMaxUniformLights : kMaxUnrolledLights);
        draw_pass(frame, alike, {.pass = &pass, .has_listed_lights = are_listed}, fog,
                  are_listed ? rest.first(0) : rest);
        break;
      }
      case LightFeed::Kind::batches: {
        bool is_first = pass.blend == Blend::replace;  // drawn even without lights
        while (is_first || !rest.empty()) {
          const auto batch = rest.first(batch_length(rest, pass.lights.batch_size, maps_.kinds()));
          const bool are_listed = is_first && pass.lights.lists_rest && batch.size() < rest.size();
          draw_pass(frame, alike, {.pass = &pass, .is_first = is_first, .has_listed_lights = are_listed}, fog, batch);
          rest = rest.subspan(batch.size());
          is_first = false;
        }
        break;
      }
    }
  }
}

void SurfacePainter::draw_pass(Frame& frame, std::span<const PlannedSurface> alike, ShaderVariant variant,
                               std::span<const std::int32_t> fog_lights, std::span<const std::int32_t> batch) {
  const Surface& surface = *alike[0].surface;
  variant.material = features_of(surface, *settings_.path);
  variant.knot_count = knots_;
  LightUniforms uniforms;
  const auto add_uniform = [&](std::int32_t light) {
    uniforms.lights.push_back(lights_.packed(std::size_t(light)));
    if (frame.light.shadows) uniforms.casters.push_back(frame.light.shadows->caster_of(std::size_t(light)));
  };
  const auto resize_uniforms = [&](std::size_t count) {
    uniforms.lights.resize(count, kBlack);
    if (frame.light.shadows) uniforms.casters.resize(count, ShadowMaps::kNoCaster);
  };
  if (variant.is_first && variant.pass->shows_fog) {
    variant.has_listed_fog_lights = fog_lights.size() > kMaxUnrolledLights;
    if (!variant.has_listed_fog_lights) {
      for (const std::int32_t light : fog_lights) add_uniform(light);
      variant.fog_light_count = compiled_light_count(uniforms.lights.size());
      resize_uniforms(variant.fog_light_count);
    }
  }
  const std::size_t first = uniforms.lights.size();
  // A pass that takes all lights computes once what the fog and the surface share.
  const LightFeed& feed = variant.pass->lights;
  variant.shares_lights =
      feed.kind == LightFeed::Kind::all && !feed.has_flags && !variant.has_listed_lights && first > 0;
  for (const std::int32_t light : batch) {
    if (variant.shares_lights && std::ranges::find(fog_lights, light) != fog_lights.end()) continue;
    add_uniform(light);
  }
  const std::size_t count = uniforms.lights.size() - first;
  variant.light_count = has_maps() ? count : feed.has_flags ? kMaxUniformLights : compiled_light_count(count);
  resize_uniforms(first + variant.light_count);
  // Loops over lists end early if depths are tested first. Several passes need the stencil for themselves.
  variant.tests_depth_late = programs_.should_test_depth_late() &&
                             settings_.papers.early_rejection == EarlyRejection::none &&
                             feed.kind == LightFeed::Kind::all && !frame.path.has_several_passes() &&
                             !variant.has_listed_lights && !variant.has_listed_fog_lights;
  draw_variant(frame, alike, variant, uniforms, batch);
}

void SurfacePainter::draw_variant(Frame& frame, std::span<const PlannedSurface> alike, const ShaderVariant& variant,
                                  const LightUniforms& uniforms, std::span<const std::int32_t> batch) {
  const SurfaceMaterial& surface_material = *alike[0].surface->material;
  const SurfaceProgram& program = use(frame, variant, surface_material);
  const bool is_later = frame.passes_drawn > 0;
  if (frame.path.has_several_passes()) select_samples(frame.passes_drawn++);
  glUniform2i(program.light_list_range, alike[0].list_first, alike[0].list_count);
  frame.bytes += 2 * sizeof(GLint) + uniforms.lights.size() * sizeof(PackedLight);
  if (!uniforms.lights.empty()) {
    glUniform4fv(program.uniform_lights, GLsizei(uniforms.lights.size() * kPackedVectors),
                 glm::value_ptr(uniforms.lights[0].kind.attenuation_extent));
  }
  if (variant.pass->lights.has_flags) {
    std::array<GLint, kMaxUniformLights> flags{};
    std::fill_n(flags.begin(), batch.size(), 1);
    glUniform1iv(program.light_flags, GLsizei(flags.size()), flags.data());
  }
  if (!uniforms.casters.empty()) {
    glUniform1iv(program.uniform_casters, GLsizei(uniforms.casters.size()), uniforms.casters.data());
  }
  if (has_maps() && !batch.empty()) {
    std::vector<glm::mat3> cones;
    for (const std::int32_t light : batch) cones.push_back(maps_.cone_from_world(std::size_t(light)));
    glUniformMatrix3fv(program.cone_from_world, GLsizei(cones.size()), GL_FALSE, glm::value_ptr(cones[0]));
    maps_.bind(maps_.kinds()[std::size_t(batch[0])]);
  }
  draw_triangles(frame, alike, program, is_later ? TriangleOrder::reversed : TriangleOrder::stored);
}

void SurfacePainter::draw_triangles(Frame& frame, std::span<const PlannedSurface> alike, const SurfaceProgram& program,
                                    TriangleOrder order) {
  const bool have_bounds = settings_.samples > 1;  // shaders/rasterised.glsl; without, neighbours share a draw call
  for (std::size_t i = 0; i < alike.size();) {
    const glm::mat4& world_from_model = alike[i].surface->world_from_model;
    const scene::Bounds& bounds = alike[i].surface->bounds;
    const std::size_t first = alike[i].surface->chunk->first_index;
    auto count = std::size_t(alike[i].surface->chunk->index_count);
    if (i == 0 || world_from_model != alike[i - 1].surface->world_from_model) {
      glUniformMatrix4fv(program.world_from_model, 1, GL_FALSE, glm::value_ptr(world_from_model));
      frame.bytes += sizeof(glm::mat4);
    }
    for (++i; !have_bounds && i < alike.size(); ++i) {
      const Surface& next = *alike[i].surface;
      if (next.chunk->first_index != first + count || next.world_from_model != world_from_model) break;
      count += std::size_t(next.chunk->index_count);
    }
    if (have_bounds) {
      glUniform3fv(program.bounds_low, 1, glm::value_ptr(bounds.low));
      glUniform3fv(program.bounds_high, 1, glm::value_ptr(bounds.high));
      frame.bytes += sizeof(bounds.low) + sizeof(bounds.high);
    }
    if (frame.draws_panes) {
      surfaces_.meshes().draw_sorted(frame.first, frame.count);
    } else {
      surfaces_.meshes().draw(first, count, order);
    }
  }
}

SurfaceProgram& SurfacePainter::use(Frame& frame, const ShaderVariant& variant, const SurfaceMaterial& material) {
  SurfaceProgram& program = programs_.program(variant);
  if (&program != frame.used) {
    frame.used = &program;
    program.program.use();
    const bool is_added = variant.pass->blend == Blend::replace && !variant.is_first;
    if (!frame.draws_panes) set_blend(is_added ? Blend::add : variant.pass->blend);
  }
  if (program.frame != frame.number) {
    program.frame = frame.number;
    program.material = nullptr;
    set_frame_uniforms(frame, variant, program.program);
  }
  if (&material != frame.bound) {
    frame.bound = &material;
    material.albedo->bind(kAlbedoUnit);
    if (material.normal) material.normal->bind(kNormalUnit);
    if (material.emission) material.emission->bind(kEmissionUnit);
    if (material.second) material.second->bind(kSecondUnit);
  }
  if (&material != program.material) {
    program.material = &material;
    set_material_uniforms(variant, material, program.program);
  }
  return program;
}

void SurfacePainter::set_frame_uniforms(const Frame& frame, const ShaderVariant& variant,
                                        const gl::Program& program) const {
  bind_lights(program, fog_light_buffer_);
  set_uniform(program, "ambient_light", scene_.environment.ambient_light);
  set_uniform(program, "moon_direction", scene_.environment.moon_direction);
  set_uniform(program, "moon_color", scene_.environment.moon_color);
  set_uniform(program, "clip_from_world", frame.view.clip_from_world);
  set_uniform(program, "eye", frame.view.eye);
  set_moonlight(program, frame.view);
  set_uniform(program, "infinite_viewer", -frame.view.forward);
  set_uniform(program, "is_flat_shaded", settings_.papers.is_flat_shaded);
  set_uniform(program, "albedo_map", kAlbedoUnit);
  set_uniform(program, "normal_map", kNormalUnit);
  set_uniform(program, "emission_map", kEmissionUnit);
  set_uniform(program, "second_map", kSecondUnit);
  set_uniform(program, "light_list", kLightListUnit);
  set_uniform(program, "reach", float(std::min(surfaces_.reach(), kFarReach)));
  set_uniform(program, "carried_count", int(lights_.carried_count()));
  set_uniform(program, "range_map", kRangeMapUnit);
  set_uniform(program, "distance_map", kDistanceMapUnit);
  set_uniform(program, "cone_map", kConeMapUnit);
  set_uniform(program, "shadow_maps", kShadowMapUnit);
  set_uniform(program, "shadow_casters", kShadowCasterUnit);
  set_uniform(program, "caster_of_light", kCasterOfLightUnit);
  if (frame.light.shadows) frame.light.shadows->set_moon_maps(program);
  if (frame.light.scattered) frame.light.scattered->bind(program);
  if (variant.material.is_pane) {
    bind_pane_airlight(program, frame.airlight);
    set_uniform(program, "shaft_steps", settings_.shaft_steps);
  }
}

}  // namespace litfog::render
