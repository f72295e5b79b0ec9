// SPDX-License-Identifier: Apache-2.0
#include "bench/plain_renderer.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <glm/gtc/type_ptr.hpp>
#include <numeric>
#include <span>

#include "litfog/formulas.h"
#include "litfog/gl/check_errors.h"
#include "render/gpu/depth.h"
#include "render/gpu/render_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"
#include "render/light/light_map_store.h"
#include "render/light/light_point.h"
#include "render/renderer.h"
#include "render/surface/mesh_store.h"
#include "render/surface/sky_painter.h"
#include "scene/light_frame.h"

namespace litfog::bench {

/// The files of apps/bench/shaders, embedded.
std::span<const gl::ShaderSource> plain_shaders();

namespace {

using render::set_uniform;

/// Indices of a scene's lights, local lights first.
std::vector<std::size_t> local_lights_first(const std::vector<PlacedLight>& lights) {
  std::vector<std::size_t> order(lights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return !lights[i].carried; });
  return order;
}

gl::Program make_program(std::string_view vertex, std::string_view fragment, const scene::Scene& scene,
                         std::size_t local_count) {
  const std::string counts =
      fmt::format("#define LOCAL_COUNT {}\n#define LIGHT_COUNT {}\n", local_count, scene.lights.size());
  std::vector<gl::ShaderSource> files{{"generated/plain.glsl", counts},
                                      {"light_list.glsl", "#include \"plain_lights.glsl\"\n"}};
  files.insert(files.end(), plain_shaders().begin(), plain_shaders().end());
  const std::vector<gl::ShaderSource> rest = render::scene_shaders(!scene.cookies.empty());
  files.insert(files.end(), rest.begin(), rest.end());
  return gl::Program(vertex, fragment, files);
}

PlainLight pack(const PlacedLight& light, const FogIntensity& solution) {
  const auto [attenuation, cone] = pack_fog_light_kind(light, solution);
  const FogLightInstance instance = pack_fog_light_instance(light, 0);
  return {.position_extent = glm::vec4(glm::vec3(instance.position_kind), attenuation.w),
          .axis_profile = instance.axis_profile,
          .color_intensity = glm::vec4(glm::vec3(instance.color), cone.w),
          .attenuation = glm::vec4(glm::vec3(attenuation), cone.z),
          .cone = glm::vec4(cone.x, cone.y, 0, 0)};
}

}  // namespace

PlainRenderer::Mesh::Mesh(const scene::Mesh& mesh) : index_count(int(mesh.indices.size())) {
  glBindVertexArray(vertex_array.id());
  glBindBuffer(GL_ARRAY_BUFFER, vertices.id());
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices.size() * sizeof(scene::Vertex)), mesh.vertices.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * sizeof(std::uint32_t)), mesh.indices.data(),
               GL_STATIC_DRAW);
  render::set_vertex_attributes();
}

PlainRenderer::PlainRenderer(const scene::Scene& scene, int width, int height, int samples)
    : scene_(scene),
      framebuffer_(width, height, render::Passes::one, samples),
      light_order_(local_lights_first(scene.lights)),
      local_count_(std::size_t(std::ranges::count(scene.lights, false, &PlacedLight::carried))),
      surface_program_(make_program("plain.vert", "plain.frag", scene, local_count_)),
      sky_program_(make_program("sky.vert", "plain_sky.frag", scene, local_count_)),
      light_point_program_(make_program("light_point.vert", "light_point.frag", scene, local_count_)) {
  using Encoding = render::Texture::Encoding;
  assert(!scene.lights.empty() && scene.lights.size() <= kMaxPlainLights);
  if (!scene.cookies.empty()) cookies_ = render::upload_cookies(scene.cookies);
  for (const scene::Material& material : scene.materials) {
    const auto albedo = material.plain_albedo
                            ? std::make_shared<const render::Texture>(glm::vec4(*material.plain_albedo, 1.0f))
                            : std::make_shared<const render::Texture>(*material.albedo, Encoding::srgb);
    materials_[material.name] = {&material, albedo,
                                 std::make_shared<const render::Texture>(*material.normal, Encoding::linear)};
  }
  for (const scene::Model& model : scene.models) {
    auto& meshes = meshes_.emplace_back();
    for (const scene::Part& part : model) meshes.push_back(std::make_unique<Mesh>(part.mesh));
  }
  for (const scene::Instance& instance : scene.instances) {
    const scene::Model& model = scene.models[instance.model];
    for (std::size_t i = 0; i < model.size(); ++i) {
      draws_.push_back(
          {&materials_.at(model[i].material), meshes_[instance.model][i].get(), instance.world_from_model});
    }
  }
  std::ranges::stable_sort(draws_, {}, [](const Draw& draw) { return draw.material->material->name; });
  set_atmosphere(scene.atmosphere);
}

void PlainRenderer::set_atmosphere(const Atmosphere& atmosphere) {
  atmosphere_ = atmosphere;
  packed_.clear();
  for (const std::size_t i : light_order_) {
    const PlacedLight light = scene::lit_light(scene_, i);
    packed_.push_back(pack(light, solve_fog_intensity(light.light, atmosphere.fog)));
    if (const auto use = scene_.cookie_uses.find(i); use != scene_.cookie_uses.end()) {
      const glm::dvec3 up = glm::transpose(scene::cookie_from_world(light.direction, use->second.roll))[1];
      packed_.back().axis_profile.w = float(LITFOG_PROFILE_COOKIE);
      packed_.back().cone = glm::vec4(float(use->second.cookie), glm::vec3(up));
    }
  }
  fog_block_.upload(pack_fog_header(atmosphere, 0));
}

void PlainRenderer::draw() {
  const render::View view = render::view_of(scene_.camera, {framebuffer_.width(), framebuffer_.height()},
                                            atmosphere_.top - scene_.camera.position.y);
  framebuffer_.bind();
  glEnable(GL_CULL_FACE);
  glClear(GL_COLOR_BUFFER_BIT);
  render::begin_depths();
  if (cookies_) cookies_->bind(render::kCookieUnit);
  draw_surfaces(view.clip_from_world);
  glDepthMask(GL_FALSE);
  use(sky_program_);
  render::draw_sky(sky_program_, view, scene_);
  draw_light_points(view);
  render::end_depths();
  framebuffer_.resolve();
  glFinish();
  gl::check_errors("drawing a plain frame");
}

void PlainRenderer::use(const gl::Program& program) const {
  program.use();
  glUniform4fv(program.uniform("lights"), GLsizei(5 * packed_.size()), glm::value_ptr(packed_[0].position_extent));
  set_uniform(program, "density", float(atmosphere_.fog.density));
  set_uniform(program, "is_exp2", unsigned{atmosphere_.fog.mode == FogMode::exp2});
  set_uniform(program, "ambient_fog_color", glm::vec3(atmosphere_.ambient_fog_color));
  set_uniform(program, "moon_direction", scene_.environment.moon_direction);
  set_uniform(program, "moon_color", scene_.environment.moon_color);
  set_uniform(program, "eye", glm::vec3(scene_.camera.position));
  set_uniform(program, "cookies", render::kCookieUnit);
}

void PlainRenderer::draw_surfaces(const glm::mat4& clip_from_world) const {
  use(surface_program_);
  set_uniform(surface_program_, "clip_from_world", clip_from_world);
  set_uniform(surface_program_, "ambient_light", scene_.environment.ambient_light);
  set_uniform(surface_program_, "albedo_map", render::kAlbedoUnit);
  set_uniform(surface_program_, "normal_map", render::kNormalUnit);
  const int world_from_model = surface_program_.uniform("world_from_model");
  const Material* bound = nullptr;
  for (const Draw& draw : draws_) {
    if (draw.material != bound) {
      bound = draw.material;
      bound->albedo->bind(render::kAlbedoUnit);
      bound->normal->bind(render::kNormalUnit);
      set_uniform(surface_program_, "tile_size", bound->material->size_m);
      set_uniform(surface_program_, "specular", bound->material->specular);
      set_uniform(surface_program_, "shininess", bound->material->shininess);
      set_uniform(surface_program_, "emissive", bound->material->emissive);
    }
    glUniformMatrix4fv(world_from_model, 1, GL_FALSE, glm::value_ptr(draw.world_from_model));
    glBindVertexArray(draw.mesh->vertex_array.id());
    glDrawElements(GL_TRIANGLES, draw.mesh->index_count, GL_UNSIGNED_INT, nullptr);
  }
}

void PlainRenderer::draw_light_points(const render::View& view) const {
  if (local_count_ == 0) return;
  use(light_point_program_);
  fog_block_.bind(light_point_program_, render::kFogLightBinding);
  render::draw_light_points(light_point_program_, view, render::FogLighting::peak, 0, int(local_count_));
}

}  // namespace litfog::bench
