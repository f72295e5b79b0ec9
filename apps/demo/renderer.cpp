// SPDX-License-Identifier: Apache-2.0
#include "renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <future>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <numeric>
#include <string>
#include <tuple>

#include "demo_shaders.h"
#include "litfog/fog_light_block.h"
#include "litfog/gl/headless_context.h"
#include "litfog/gl/unsupported.h"

namespace litfog::demo {
namespace {

constexpr unsigned kFogLightBinding = 0;
enum TextureUnit : unsigned { kAlbedoUnit, kNormalUnit, kLocalLightUnit, kLightListUnit };
constexpr std::size_t kMaxListed = 1 << 25;  // lights in all chunks' lists: 128 MiB
constexpr float kSkyDistance = 50'000;       // metres: beyond any visibility at which fog shows

glm::mat4 clip_from_world(const Camera& camera, double aspect) {
  constexpr float kNear = 0.1f;  // metres
  const glm::mat4 view = glm::lookAt(camera.position, camera.target, glm::vec3(0, 1, 0));
  return glm::infinitePerspective(camera.field_of_view, float(aspect), kNear) * view;
}

void set(const gl::Program& program, const char* name, const glm::mat4& value) {
  glUniformMatrix4fv(program.uniform(name), 1, GL_FALSE, glm::value_ptr(value));
}
void set(const gl::Program& program, const char* name, const glm::vec3& value) {
  glUniform3fv(program.uniform(name), 1, glm::value_ptr(value));
}
void set(const gl::Program& program, const char* name, float value) { glUniform1f(program.uniform(name), value); }
void set(const gl::Program& program, const char* name, TextureUnit unit) {
  glUniform1i(program.uniform(name), GLint(unit));
}

double extent_of(const PlacedLight& light) { return extent(light.light.attenuation, light.light.threshold); }

std::vector<PlacedLight> carried_lights(const std::vector<PlacedLight>& lights) {
  std::vector<PlacedLight> selected;
  std::ranges::copy_if(lights, std::back_inserter(selected), &PlacedLight::carried);
  return selected;
}

/// Without those of extent 0, which light nothing and must not show as points either.
std::vector<PlacedLight> local_lights(const std::vector<PlacedLight>& lights) {
  std::vector<PlacedLight> selected;
  std::ranges::copy_if(lights, std::back_inserter(selected),
                       [](const PlacedLight& light) { return !light.carried && extent_of(light) > 0; });
  return selected;
}

Bounds around(const std::vector<Bounds>& boxes) {
  Bounds whole = boxes.front();
  for (const Bounds& box : boxes) whole = {glm::min(whole.low, box.low), glm::max(whole.high, box.high)};
  return whole;
}

}  // namespace

Renderer::Renderer(const Scene& scene, int width, int height, Skipping skipping)
    : scene_(scene),
      skipping_(skipping),
      framebuffer_(width, height),
      carried_(carried_lights(scene.lights)),
      local_(local_lights(scene.lights)),
      surface_program_("surface.vert", "unified.frag", demo_shaders()),
      sky_program_("sky.vert", "sky.frag", demo_shaders()),
      light_point_program_("light_point.vert", "light_point.frag", demo_shaders()),
      meshes_(scene.models) {
  gl::check_fog_light_layout(surface_program_);
  load_materials();
  std::vector<FogLight> packed;
  std::vector<double> extents;
  for (const PlacedLight& light : local_) {
    extents.push_back(extent_of(light));
    packed.push_back(pack_fog_light(light, {.intensity = 0, .peak_range = 0, .extent = extents.back(), .status = {}}));
  }
  local_lights_ =
      std::make_unique<BufferTexture>(packed.data(), packed.size() * sizeof(FogLight), BufferTexture::Texel::float4);
  make_draws(extents);
  set_fog(Fog{});
  gl::check_errors("uploading the scene");
}

void Renderer::load_materials() {
  std::map<std::string, std::future<Material>> made;  // in parallel: each is some 10 ms of noise
  for (std::size_t model = 0; model < scene_.models.size(); ++model) {
    for (const Chunk& chunk : meshes_.chunks(model)) {
      auto& material = made[chunk.material];
      if (!material.valid()) {
        material = std::async(std::launch::async, [name = chunk.material] { return make_material(name); });
      }
    }
  }
  for (auto& [name, future] : made) {
    Material material = future.get();
    Texture albedo(material.size, material.albedo, Texture::Encoding::srgb);
    Texture normal(material.size, material.normal, Texture::Encoding::linear);
    material.albedo = {};
    material.normal = {};
    materials_.emplace(name, MaterialTextures{std::move(material), std::move(albedo), std::move(normal)});
  }
}

void Renderer::make_draws(const std::vector<double>& extents) {
  const LightFinder finder(local_, extents);
  const std::size_t most = std::min(kMaxListed, BufferTexture::max_texels());
  std::vector<std::int32_t> list;
  if (skipping_ == Skipping::off) {  // one list for all
    list.resize(local_.size());
    std::iota(list.begin(), list.end(), 0);
  }
  for (const Instance& instance : scene_.instances) {
    const auto& chunks = meshes_.chunks(instance.model);
    std::vector<Bounds> boxes;
    for (const Chunk& chunk : chunks) boxes.push_back(transformed(chunk.bounds, instance.world_from_model));
    std::vector<std::int32_t> near;  // lights that can reach the instance
    if (skipping_ == Skipping::on && !boxes.empty()) near = finder.reaching(around(boxes));
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      Draw draw{.material = &materials_.at(chunks[i].material),
                .chunk = &chunks[i],
                .world_from_model = instance.world_from_model,
                .bounds = boxes[i],
                .list_first = 0,
                .list_count = int(list.size())};
      if (skipping_ == Skipping::on) {
        const std::vector<std::int32_t> reaching = finder.reaching(boxes[i], near);
        draw.list_first = int(list.size());
        draw.list_count = int(reaching.size());
        list.insert(list.end(), reaching.begin(), reaching.end());
        if (list.size() > most) {
          throw gl::Unsupported("the scene's surfaces are reached by too many lights: at most " + std::to_string(most) +
                                " can be listed for all of them together");
        }
      }
      draws_.push_back(draw);
    }
  }
  // By name, not by address: where surfaces lie in one plane the order decides, and pictures have to come out the same.
  std::ranges::stable_sort(draws_, {}, [](const Draw& draw) { return draw.material->material.name; });
  light_list_ =
      std::make_unique<BufferTexture>(list.data(), list.size() * sizeof(std::int32_t), BufferTexture::Texel::int1);
}

void Renderer::set_fog(const Fog& fog) {
  std::vector<FogIntensity> solutions;
  for (const PlacedLight& light : carried_) solutions.push_back(solve_fog_intensity(light.light, fog));
  const glm::dvec3 ambient_fog = scene_.environment.ambient_fog_color;
  fog_lights_.upload(pack_fog_light_block(fog, ambient_fog, carried_, solutions));
}

FrameCounts Renderer::draw() {
  const glm::mat4 clip = clip_from_world(scene_.camera, double(framebuffer_.width()) / framebuffer_.height());
  framebuffer_.bind();
  glClearColor(0, 0, 0, 1);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const FrameCounts counts = draw_surfaces(clip);
  glDepthMask(GL_FALSE);
  draw_sky(clip);
  draw_light_points(clip);
  glFinish();
  gl::check_errors("drawing a frame");
  return counts;
}

FrameCounts Renderer::draw_surfaces(const glm::mat4& clip) {
  const Environment& environment = scene_.environment;
  const gl::Program& program = surface_program_;
  program.use();
  fog_lights_.bind(program, kFogLightBinding);
  meshes_.bind();
  set(program, "clip_from_world", clip);
  set(program, "eye", scene_.camera.position);
  set(program, "ambient_light", environment.ambient_light);
  set(program, "moon_direction", environment.moon_direction);
  set(program, "moon_color", environment.moon_color);
  set(program, "albedo_map", kAlbedoUnit);
  set(program, "normal_map", kNormalUnit);
  set(program, "local_lights", kLocalLightUnit);
  set(program, "light_list", kLightListUnit);
  local_lights_->bind(kLocalLightUnit);
  light_list_->bind(kLightListUnit);
  const GLint world_from_model = program.uniform("world_from_model");
  const GLint bounds_low = program.uniform("bounds_low");
  const GLint bounds_high = program.uniform("bounds_high");
  const GLint light_list_range = program.uniform("light_list_range");

  FrameCounts counts;
  const Frustum frustum = make_frustum(clip);
  const MaterialTextures* bound = nullptr;
  for (const Draw& draw : draws_) {
    if (skipping_ == Skipping::on && !can_see(frustum, draw.bounds)) {
      ++counts.chunks_skipped;
      continue;
    }
    if (draw.material != bound) {
      bound = draw.material;
      bound->albedo.bind(kAlbedoUnit);
      bound->normal.bind(kNormalUnit);
      set(program, "tile_size", bound->material.size_m);
      set(program, "specular", bound->material.specular);
      set(program, "shininess", bound->material.shininess);
      set(program, "emissive", bound->material.emissive);
    }
    glUniformMatrix4fv(world_from_model, 1, GL_FALSE, glm::value_ptr(draw.world_from_model));
    glUniform3fv(bounds_low, 1, glm::value_ptr(draw.bounds.low));
    glUniform3fv(bounds_high, 1, glm::value_ptr(draw.bounds.high));
    glUniform2i(light_list_range, draw.list_first, draw.list_count);
    meshes_.draw(*draw.chunk);
    ++counts.chunks_drawn;
    counts.lights_listed += std::size_t(draw.list_count);
    counts.lights_skipped += local_.size() - std::size_t(draw.list_count);
  }
  return counts;
}

void Renderer::draw_sky(const glm::mat4& clip) {
  const Environment& environment = scene_.environment;
  sky_program_.use();
  fog_lights_.bind(sky_program_, kFogLightBinding);
  set(sky_program_, "world_from_clip", glm::inverse(clip));
  set(sky_program_, "eye", scene_.camera.position);
  set(sky_program_, "sky_zenith", environment.sky_zenith);
  set(sky_program_, "sky_horizon", environment.sky_horizon);
  set(sky_program_, "star_brightness", environment.star_brightness);
  set(sky_program_, "moon_direction", environment.moon_direction);
  set(sky_program_, "moon_color", environment.moon_color);
  set(sky_program_, "sky_distance", kSkyDistance);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::draw_light_points(const glm::mat4& clip) {
  if (local_.empty()) return;
  light_point_program_.use();
  fog_lights_.bind(light_point_program_, kFogLightBinding);
  local_lights_->bind(kLocalLightUnit);
  set(light_point_program_, "clip_from_world", clip);
  set(light_point_program_, "eye", scene_.camera.position);
  set(light_point_program_, "pixel_scale", float(framebuffer_.height()) / 720.0f);
  set(light_point_program_, "local_lights", kLocalLightUnit);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glDrawArrays(GL_POINTS, 0, GLsizei(local_.size()));
  glDisable(GL_BLEND);
}

}  // namespace litfog::demo
