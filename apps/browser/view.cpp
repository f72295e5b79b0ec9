// SPDX-License-Identifier: Apache-2.0
#include "browser/view.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "litfog/gl/check_errors.h"
#include "litfog/gl/unsupported.h"
#include "render/gpu/depth.h"
#include "render/gpu/render_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"
#include "render/light/light_point.h"
#include "render/light/light_threshold.h"
#include "render/plan/fog_top.h"
#include "render/plan/view.h"

namespace litfog::browser {
namespace {

using render::set_uniform;

constexpr int kSamples = 4;  // a pixel: WebGL 2 has as many everywhere
// An automatic exposure is chosen by this many pixels along the picture's shorter side, or up to twice as many.
constexpr int kMeasuredPixels = 100;

gl::Program make_point_program(render::FogLighting fog_lighting) {
  const auto [vertex, fragment] = render::point_shaders(fog_lighting);
  return {vertex, fragment, render::render_shaders()};
}

}  // namespace

View::View(const scene::Scene& scene)
    : scene_(scene),
      updater_(0),  // which lights are too dark to be seen depends on the exposure
      meshes_(scene.models, [](const std::string&) { return false; }),
      sky_(scene, light_block_),
      surface_program_("surface.vert", "lit.frag", render::render_shaders()),
      point_programs_{make_point_program(render::FogLighting::peak), make_point_program(render::FogLighting::airlight)},
      airlight_program_("whole_picture.vert", "airlight.frag", render::render_shaders()),
      shown_program_("whole_picture.vert", "shown.frag", render::render_shaders()) {
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    carried_count_ += scene.lights[i].carried;
    handles_.push_back(updater_.add(drawn_light(i)));
  }
  for (const scene::Material& material : scene.materials) {
    materials_.emplace(material.name,
                       SurfaceMaterial{material, render::Texture(*material.albedo, render::Texture::Encoding::srgb),
                                       render::Texture(*material.normal, render::Texture::Encoding::linear)});
  }
  gl::check_fog_light_layout(airlight_program_);
  gl::check_errors("making the view");
}

PlacedLight View::drawn_light(std::size_t light) const {
  PlacedLight drawn = scene_.lights[light];
  if (fog_lighting_ == render::FogLighting::peak) return drawn;
  drawn.carried = false;  // Hales's term is not for it
  // The page has few lamps, so that none needs an end that a larger exposure would show.
  drawn.light = photometric(drawn.light);
  drawn.light.threshold = render::airlight_threshold(drawn.light, kMaxExposure);
  return drawn;
}

void View::set_light(std::size_t light) { updater_.change(handles_[light], drawn_light(light)); }

void View::set_fog_lighting(render::FogLighting fog_lighting) {
  if (fog_lighting == fog_lighting_) return;
  fog_lighting_ = fog_lighting;
  for (std::size_t i = 0; i < handles_.size(); ++i) set_light(i);
}

void View::set_size(int width, int height) {
  const glm::ivec2 size(width, height);
  if (size == size_) return;
  size_ = size;
  drawn_.emplace();
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_->framebuffer.id());
  for (const auto& [buffer, format, attachment] : {std::tuple{&drawn_->color, GL_RGBA16F, GL_COLOR_ATTACHMENT0},
                                                   {&drawn_->depth, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT}}) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer->id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, GLenum(format), width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GLenum(attachment), GL_RENDERBUFFER, buffer->id());
  }
  resolved_.emplace(size);
  composed_.emplace(size);
  measured_.emplace(size / std::max(std::min(width, height) / kMeasuredPixels, 1));
}

View::Target::Target(glm::ivec2 target_size) : size(target_size) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  render::bind_texture(render::kUploadUnit, color);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA16F, size.x, size.y);
  render::set_filter(GL_TEXTURE_2D, GL_NEAREST);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color.id(), 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw gl::Unsupported("this browser's WebGL 2 draws no pictures of floats");
  }
}

FrameReport View::draw(const Fog& fog, const render::Display& display) {
  const FogLightChanges changes = updater_.set_fog(fog);
  light_block_.upload(pack_fog_header(scene_.atmosphere.with(fog), updater_.instances().size()), updater_.kinds(),
                      updater_.instances(), changes);
  FrameReport report{.bytes_uploaded = updater_.statistics().bytes_dirty + sizeof(FogHeader)};

  const render::View view =
      render::view_of(scene_.camera, size_, scene_.atmosphere.top_above(scene_.camera.position.y));
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_->framebuffer.id());
  glViewport(0, 0, size_.x, size_.y);
  glClear(GL_COLOR_BUFFER_BIT);
  render::begin_depths();
  report.surfaces = draw_surfaces(view);
  glDepthMask(GL_FALSE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);  // alpha is the surfaces'
  glBindVertexArray(no_vertices_.id());
  sky_.draw(view, render::SkyDrawing::sky, carried_count_);
  const gl::Program& points = point_programs_[std::size_t(fog_lighting_)];
  use(points, view);
  render::draw_light_points(points, view, fog_lighting_, int(carried_count_),
                            int(scene_.lights.size() - carried_count_));
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  render::end_depths();
  copy(drawn_->framebuffer, size_, *resolved_);

  const bool has_airlight = fog_lighting_ == render::FogLighting::airlight;
  if (has_airlight) draw_airlight(view);
  const Target& picture = has_airlight ? *composed_ : *resolved_;
  report.exposure = display.exposure.is_auto ? measured_exposure(picture) : display.exposure.ev;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  shown_program_.use();
  render::bind_texture(render::kPassUnit, picture.color);
  set_uniform(shown_program_, "picture", render::kPassUnit);
  set_uniform(shown_program_, "exposure_gain", float(std::exp2(report.exposure)));
  set_uniform(shown_program_, "is_neutral", display.tone == render::ToneCurve::neutral);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  gl::check_errors("drawing a frame");
  return report;
}

void View::use(const gl::Program& program, const render::View& view) const {
  program.use();
  light_block_.bind(program, render::kFogLightBinding);
  set_uniform(program, "carried_count", carried_count_);
  set_uniform(program, "clip_from_world", view.clip_from_world);
  set_uniform(program, "eye", view.eye);
}

std::size_t View::draw_surfaces(const render::View& view) {
  const gl::Program& program = surface_program_;
  const render::Frustum frustum = render::make_frustum(view.clip_from_world);
  use(program, view);
  set_uniform(program, "ambient_light", scene_.environment.ambient_light);
  set_uniform(program, "has_airlight", fog_lighting_ == render::FogLighting::airlight);
  set_uniform(program, "albedo_map", render::kAlbedoUnit);
  set_uniform(program, "normal_map", render::kNormalUnit);
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
      surface.albedo.bind(render::kAlbedoUnit);
      surface.normal.bind(render::kNormalUnit);
      meshes_.draw(chunk.first_index, std::size_t(chunk.index_count), render::TriangleOrder::stored);
      ++drawn;
    }
  }
  glDisable(GL_CULL_FACE);
  return drawn;
}

void View::draw_airlight(const render::View& view) {
  glBindFramebuffer(GL_FRAMEBUFFER, composed_->framebuffer.id());
  use(airlight_program_, view);
  render::bind_texture(render::kPassUnit, resolved_->color);
  set_uniform(airlight_program_, "picture", render::kPassUnit);
  set_uniform(airlight_program_, "pixel_size", 2.0f / glm::vec2(size_));
  set_uniform(airlight_program_, "direction_from_clip", view.direction_from_clip);
  render::set_fog_top(airlight_program_, view.top_above_eye);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void View::copy(const gl::FramebufferName& from, glm::ivec2 size, const Target& to) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer.id());
  glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, to.size.x, to.size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

double View::measured_exposure(const Target& picture) {
  copy(picture.framebuffer, picture.size, *measured_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, measured_->framebuffer.id());
  const auto [width, height] = std::pair(measured_->size.x, measured_->size.y);
  std::vector<glm::vec4> light(std::size_t(width) * std::size_t(height));
  glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, light.data());
  render::Picture measured{width, height, {}};
  for (const glm::vec4& color : light) measured.rgb.insert(measured.rgb.end(), {color.r, color.g, color.b});
  return render::auto_exposure(measured);
}

}  // namespace litfog::browser
