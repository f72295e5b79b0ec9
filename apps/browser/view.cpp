// SPDX-License-Identifier: Apache-2.0
#include "browser/view.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <tuple>
#include <vector>

#include "browser/page_shaders.h"
#include "litfog/gl/check_errors.h"
#include "litfog/gl/unsupported.h"
#include "render/gpu/depth.h"
#include "render/gpu/uniform.h"
#include "render/light/light_point.h"
#include "render/light/light_threshold.h"
#include "render/plan/fog_top.h"
#include "render/plan/frustum.h"

namespace litfog::browser {
namespace {

using render::set_uniform;

constexpr unsigned kBlockBinding = 0;
constexpr unsigned kAlbedoUnit = 0;
constexpr unsigned kNormalUnit = 1;
constexpr unsigned kPictureUnit = 0;
constexpr int kSamples = 4;              // a pixel: WebGL 2 has as many everywhere
constexpr double kLargestExposure = 12;  // EV, of the page's slider
// An automatic exposure is chosen by this many pixels along the picture's shorter side, or up to twice as many, with
// all airlight that shows at the largest exposure.
constexpr int kMeasuredPixels = 100;
constexpr render::Display kMeasured{.exposure = {.ev = kLargestExposure}};

glm::mat4 clip_from_view(const scene::Camera& camera, int width, int height) {
  return glm::infinitePerspective(camera.field_of_view, float(width) / float(height), render::kNearPlane);
}

/// From clip space, where z is 1, to a vector from the eye.
glm::mat4 direction_from_clip(const scene::Camera& camera, int width, int height) {
  const glm::mat4 clip_from_view = glm::perspective(camera.field_of_view, float(width) / float(height), 0.1f, 1.0f);
  return glm::inverse(clip_from_view * glm::mat4(glm::mat3(scene::view_from_world<float>(camera))));
}

}  // namespace

View::View(const scene::Scene& scene)
    : scene_(scene),
      updater_(0),  // which lights are too dark to be seen depends on the exposure
      meshes_(scene.models, [](const std::string&) { return false; }),
      surface_program_("lit.vert", "lit.frag", page_shaders()),
      sky_program_("sky.vert", "sky.frag", page_shaders()),
      point_program_("light_point.vert", "light_point.frag", page_shaders()),
      shown_program_("whole_picture.vert", "shown.frag", page_shaders()) {
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    carried_count_ += scene.lights[i].carried;
    handles_.push_back(updater_.add(drawn_light(i)));
  }
  for (const scene::Material& material : scene.materials) {
    materials_.emplace(material.name,
                       SurfaceMaterial{material, render::Texture(*material.albedo, render::Texture::Encoding::srgb),
                                       render::Texture(*material.normal, render::Texture::Encoding::linear)});
  }
  gl::check_fog_light_layout(shown_program_);
  gl::check_errors("making the view");
}

PlacedLight View::drawn_light(std::size_t light) const {
  PlacedLight drawn = scene_.lights[light];
  if (fog_lighting_ == render::FogLighting::peak) return drawn;
  drawn.carried = false;  // Hales's term is not for it
  // The page has few lamps, so that none needs an end that a larger exposure would show.
  drawn.light.threshold = render::airlight_threshold(drawn.light, kLargestExposure);
  return drawn;
}

void View::set_light(std::size_t light) { updater_.change(handles_[light], drawn_light(light)); }

void View::set_fog_lighting(render::FogLighting fog_lighting) {
  if (fog_lighting == fog_lighting_) return;
  fog_lighting_ = fog_lighting;
  for (std::size_t i = 0; i < handles_.size(); ++i) set_light(i);
}

void View::set_size(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  drawn_.emplace();
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_->framebuffer.id());
  for (const auto& [buffer, format, attachment] : {std::tuple{&drawn_->color, GL_RGBA16F, GL_COLOR_ATTACHMENT0},
                                                   {&drawn_->depth, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT}}) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer->id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, GLenum(format), width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GLenum(attachment), GL_RENDERBUFFER, buffer->id());
  }
  resolved_.emplace(unsigned{GL_RGBA16F}, width, height);
  stride_ = std::max(std::min(width, height) / kMeasuredPixels, 1);
  measured_.emplace(unsigned{GL_RGBA32F}, width / stride_, height / stride_);
}

View::Target::Target(unsigned format, int width, int height) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glBindTexture(GL_TEXTURE_2D, color.id());
  glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color.id(), 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw gl::Unsupported("this browser's WebGL 2 draws no pictures of floats");
  }
}

FrameReport View::draw(const Fog& fog, const render::Display& display) {
  const FogLightChanges changes = updater_.set_fog(fog);
  light_block_.upload(pack_fog_header(fog, scene_.environment.ambient_fog_color, updater_.instances().size()),
                      updater_.kinds(), updater_.instances(), changes);
  FrameReport report{.bytes_uploaded = updater_.statistics().bytes_dirty + sizeof(FogHeader)};

  const glm::mat4 clip_from_world =
      clip_from_view(scene_.camera, width_, height_) * scene::view_from_world<float>(scene_.camera);
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_->framebuffer.id());
  glViewport(0, 0, width_, height_);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  report.surfaces = draw_surfaces(clip_from_world);
  glDepthMask(GL_FALSE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);  // alpha is the surfaces'
  glBindVertexArray(no_vertices_.id());
  draw_sky();
  draw_light_points(clip_from_world);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_->framebuffer.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_->framebuffer.id());
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glDisable(GL_DEPTH_TEST);
  render::Display shown = display;
  if (shown.exposure.is_auto) shown.exposure.ev = measured_exposure();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width_, height_);
  draw_finished(shown, 1, false);
  report.exposure = shown.exposure.ev;
  gl::check_errors("drawing a frame");
  return report;
}

std::size_t View::draw_surfaces(const glm::mat4& clip_from_world) {
  const scene::Environment& environment = scene_.environment;
  const gl::Program& program = surface_program_;
  const render::Frustum frustum = render::make_frustum(clip_from_world);
  program.use();
  light_block_.bind(program, kBlockBinding);
  set_uniform(program, "clip_from_world", clip_from_world);
  set_uniform(program, "eye", glm::vec3(scene_.camera.position));
  set_uniform(program, "ambient_light", environment.ambient_light);
  set_uniform(program, "has_airlight", unsigned{fog_lighting_ == render::FogLighting::airlight});
  set_uniform(program, "carried_count", carried_count_);
  set_uniform(program, "albedo_map", kAlbedoUnit);
  set_uniform(program, "normal_map", kNormalUnit);
  glEnable(GL_CULL_FACE);
  meshes_.bind();
  std::size_t drawn = 0;
  for (const scene::Instance& instance : scene_.instances) {
    set_uniform(program, "world_from_model", instance.world_from_model);
    for (const render::Chunk& chunk : meshes_.chunks(instance.model)) {
      const scene::Bounds bounds = scene::transformed(chunk.bounds, instance.world_from_model);
      if (!render::can_see(frustum, bounds)) continue;
      const SurfaceMaterial& surface = materials_.at(chunk.material);
      set_uniform(program, "bounds_low", bounds.low);
      set_uniform(program, "bounds_high", bounds.high);
      set_uniform(program, "tile_size", surface.material.size_m);
      set_uniform(program, "specular", surface.material.specular);
      set_uniform(program, "shininess", surface.material.shininess);
      set_uniform(program, "emissive", surface.material.emissive);
      set_uniform(program, "normal_scale", surface.material.normal_scale);
      surface.albedo.bind(kAlbedoUnit);
      surface.normal.bind(kNormalUnit);
      meshes_.draw(chunk.first_index, std::size_t(chunk.index_count), render::TriangleOrder::stored);
      ++drawn;
    }
  }
  glDisable(GL_CULL_FACE);
  return drawn;
}

void View::draw_sky() {
  const scene::Environment& environment = scene_.environment;
  sky_program_.use();
  light_block_.bind(sky_program_, kBlockBinding);
  set_uniform(sky_program_, "carried_count", carried_count_);
  set_uniform(sky_program_, "direction_from_clip", direction_from_clip(scene_.camera, width_, height_));
  set_uniform(sky_program_, "far_plane", 1.0f);
  set_uniform(sky_program_, "eye", glm::vec3(scene_.camera.position));
  set_uniform(sky_program_, "sky_zenith", environment.sky_zenith);
  set_uniform(sky_program_, "sky_horizon", environment.sky_horizon);
  set_uniform(sky_program_, "star_brightness", environment.star_brightness);
  render::set_fog_top(sky_program_, scene_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void View::draw_light_points(const glm::mat4& clip_from_world) {
  point_program_.use();
  light_block_.bind(point_program_, kBlockBinding);
  set_uniform(point_program_, "clip_from_world", clip_from_world);
  set_uniform(point_program_, "eye", glm::vec3(scene_.camera.position));
  render::set_point_uniforms(point_program_, fog_lighting_, height_, false);
  set_uniform(point_program_, "first_point", carried_count_);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glDrawArrays(GL_POINTS, 0, GLsizei(scene_.lights.size() - carried_count_));
  glDisable(GL_BLEND);
}

double View::measured_exposure() {
  render::Picture picture{width_ / stride_, height_ / stride_, {}};
  glBindFramebuffer(GL_FRAMEBUFFER, measured_->framebuffer.id());
  glViewport(0, 0, picture.width, picture.height);
  draw_finished(kMeasured, stride_, true);
  std::vector<glm::vec4> light(std::size_t(picture.width) * std::size_t(picture.height));
  glReadPixels(0, 0, picture.width, picture.height, GL_RGBA, GL_FLOAT, light.data());
  for (const glm::vec4& color : light) picture.rgb.insert(picture.rgb.end(), {color.r, color.g, color.b});
  return render::auto_exposure(picture);
}

void View::draw_finished(const render::Display& display, int stride, bool is_measured) {
  const scene::Camera& camera = scene_.camera;
  glActiveTexture(GL_TEXTURE0 + kPictureUnit);
  glBindTexture(GL_TEXTURE_2D, resolved_->color.id());
  shown_program_.use();
  light_block_.bind(shown_program_, kBlockBinding);
  set_uniform(shown_program_, "picture", kPictureUnit);
  set_uniform(shown_program_, "eye", glm::vec3(camera.position));
  set_uniform(shown_program_, "pixel_size", glm::vec2(2) / glm::vec2(width_, height_));
  set_uniform(shown_program_, "direction_from_clip", direction_from_clip(camera, width_, height_));
  set_uniform(shown_program_, "has_airlight", unsigned{fog_lighting_ == render::FogLighting::airlight});
  set_uniform(shown_program_, "exposure_gain", float(std::exp2(display.exposure.ev)));
  set_uniform(shown_program_, "is_neutral", unsigned{display.tone == render::ToneCurve::neutral});
  set_uniform(shown_program_, "stride", unsigned(stride));
  set_uniform(shown_program_, "is_measured", unsigned{is_measured});
  render::set_fog_top(shown_program_, scene_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace litfog::browser
