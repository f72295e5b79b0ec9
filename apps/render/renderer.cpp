// SPDX-License-Identifier: Apache-2.0
#include "render/renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "litfog/fog_light_block.h"
#include "litfog/gl/check_errors.h"
#include "render/demo_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"
#include "render/light_map_store.h"

namespace litfog::render {
namespace {

glm::mat4 view_from_world(const scene::Camera& camera) {
  return glm::lookAt(camera.position, camera.target, glm::vec3(0, 1, 0));
}

}  // namespace

float fog_above_eye(const scene::Scene& scene) {
  return float(std::clamp(scene.fog_top - double(scene.camera.position.y), -1.0, 2.0 * kSkyDistance));
}

Renderer::Renderer(const scene::Scene& scene, int width, int height, const RenderSettings& settings)
    : scene_(scene),
      settings_(settings),
      framebuffer_(width, height, settings.path->has_several_passes() ? Passes::several : Passes::one,
                   settings.samples),
      lights_(scene, settings),
      cookie_cones_(lights_.cookie_cones().data(), lights_.cookie_cones().size_bytes(), BufferTexture::Texel::float4),
      surfaces_(scene, lights_, fog_block_, settings),
      sky_program_("sky.vert", "sky.frag", scene_shaders(!scene.cookies.empty())),
      light_point_program_("light_point.vert", "light_point.frag", scene_shaders(!scene.cookies.empty())) {
  gl::check_fog_light_layout(sky_program_);
  if (settings.shadows != Shadows::none) {
    shadows_.emplace(lights_, surfaces_.surfaces(), scene.camera.position, settings);
  }
  if (settings.fog_lighting == FogLighting::airlight) {
    airlight_.emplace(scene, lights_, fog_block_, framebuffer_,
                      settings.shadows == Shadows::shafts ? shadows() : nullptr, settings.shaft_steps);
  }
  if (!scene.cookies.empty()) cookies_ = upload_cookies(scene.cookies);
  set_fog(Fog{});
  gl::check_errors("uploading the scene");
}

void Renderer::set_fog(const Fog& fog) {
  fog_ = fog;
  const FogLightChanges changes = lights_.set_fog(fog);
  light_tables_.upload(lights_.kinds(), lights_.instances(), changes);
  fog_block_.upload(pack_fog_header(fog, scene_.environment.ambient_fog_color, 0));
}

glm::mat4 Renderer::clip_from_world() const {
  return clip_from_view(scene_.camera, framebuffer_.aspect()) * view_from_world(scene_.camera);
}

View Renderer::view() const {
  // Without the eye's position: far from the origin, the rounding of a near point minus the eye would rotate the rays.
  const auto turned = glm::mat4(glm::mat3(view_from_world(scene_.camera)));
  return {.clip_from_world = clip_from_world(),
          .direction_from_clip = glm::inverse(clip_from_view(scene_.camera, framebuffer_.aspect()) * turned),
          .near_plane = kNearPlane,
          .fog_above_eye = fog_above_eye(scene_)};
}

FrameCounts Renderer::draw(LightPoints light_points) {
  const View view = this->view();
  const std::size_t shadow_maps_drawn = shadows_ ? shadows_->draw() : 0;
  framebuffer_.bind();
  glClearColor(0, 0, 0, 1);
  glEnable(GL_CULL_FACE);
  glClear(GL_COLOR_BUFFER_BIT);
  begin_depths();
  light_tables_.bind_textures(kKindBufferUnit, kInstanceBufferUnit);
  surfaces_.surfaces().bind_light_list(kLightListUnit);
  if (cookies_) cookies_->bind(kCookieUnit);
  cookie_cones_.bind(kCookieConeUnit);
  if (shadows_) shadows_->bind();
  FrameCounts counts = surfaces_.draw(*settings_.path, view.clip_from_world, shadows());
  counts.shadow_maps_drawn = shadow_maps_drawn;
  glDepthMask(GL_FALSE);
  draw_sky(view);
  if (light_points == LightPoints::on) draw_light_points(view);
  end_depths();
  framebuffer_.resolve();
  if (airlight_) airlight_->draw(framebuffer_, view, fog_);
  glFinish();
  gl::check_errors("drawing a frame");
  return counts;
}

void Renderer::draw_geometry(const GeometryBuffer& geometry) {
  geometry.begin();
  glEnable(GL_CULL_FACE);
  surfaces_.draw(geometry_path(*settings_.path), clip_from_world(), nullptr);
  geometry.end();
  gl::check_errors("drawing the geometry");
}

void Renderer::draw_sky(const View& view) {
  const scene::Environment& environment = scene_.environment;
  sky_program_.use();
  fog_block_.bind(sky_program_, kFogLightBinding);
  set_uniform(sky_program_, "cookies", kCookieUnit);
  set_uniform(sky_program_, "cookie_cones", kCookieConeUnit);
  set_uniform(sky_program_, "litfog_kind_buffer", kKindBufferUnit);
  set_uniform(sky_program_, "litfog_instance_buffer", kInstanceBufferUnit);
  set_uniform(sky_program_, "light_list", kLightListUnit);
  set_uniform(sky_program_, "carried_count", carried_count());
  set_uniform(sky_program_, "direction_from_clip", view.direction_from_clip);
  set_uniform(sky_program_, "far_plane", far_plane_in_clip());
  set_uniform(sky_program_, "eye", scene_.camera.position);
  set_uniform(sky_program_, "sky_zenith", environment.sky_zenith);
  set_uniform(sky_program_, "sky_horizon", environment.sky_horizon);
  set_uniform(sky_program_, "star_brightness", environment.star_brightness);
  set_uniform(sky_program_, "moon_direction", environment.moon_direction);
  set_uniform(sky_program_, "moon_color", environment.moon_color);
  set_uniform(sky_program_, "sky_distance", kSkyDistance);
  set_uniform(sky_program_, "fog_above_eye", view.fog_above_eye);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::draw_light_points(const View& view) {
  if (lights_.local_count() == 0) return;
  light_point_program_.use();
  fog_block_.bind(light_point_program_, kFogLightBinding);
  set_uniform(light_point_program_, "cookies", kCookieUnit);
  set_uniform(light_point_program_, "cookie_cones", kCookieConeUnit);
  set_uniform(light_point_program_, "clip_from_world", view.clip_from_world);
  set_uniform(light_point_program_, "eye", scene_.camera.position);
  set_uniform(light_point_program_, "has_glare", unsigned{settings_.fog_lighting == FogLighting::peak});
  set_uniform(light_point_program_, "near_plane", view.near_plane);
  set_uniform(light_point_program_, "has_clip_control", unsigned{has_clip_control()});
  set_uniform(light_point_program_, "pixel_scale", float(framebuffer_.height()) / 720.0f);
  set_uniform(light_point_program_, "litfog_kind_buffer", kKindBufferUnit);
  set_uniform(light_point_program_, "litfog_instance_buffer", kInstanceBufferUnit);
  set_uniform(light_point_program_, "light_list", kLightListUnit);
  set_uniform(light_point_program_, "carried_count", carried_count());
  glEnable(GL_PROGRAM_POINT_SIZE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glDrawArrays(GL_POINTS, 0, GLsizei(lights_.local_count()));
  glDisable(GL_BLEND);
}

}  // namespace litfog::render
