// SPDX-License-Identifier: Apache-2.0
#include "render/airlight_painter.h"

#include <epoxy/gl.h>

#include <cmath>

#include "render/demo_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"
#include "render/renderer.h"

namespace litfog::render {
namespace {

/// What a light may leave out of a pixel: an eighth of a step of the display in linear light.
constexpr float kBudget = 1 / (8 * 255.0f);

/// The phase function's largest value over its isotropic one.
float largest_phase(double asymmetry) {
  const double g = std::abs(asymmetry);
  return float((1 + g) / ((1 - g) * (1 - g)));
}

}  // namespace

AirlightPainter::AirlightPainter(const scene::Scene& scene, const gl::FogLightBuffer& fog_lights)
    : scene_(scene),
      fog_lights_(fog_lights),
      program_("airlight.vert", "airlight.frag", scene_shaders(!scene.cookies.empty())) {}

void AirlightPainter::draw(const Framebuffer& framebuffer, const View& view, unsigned lights, unsigned carried) {
  program_.use();
  fog_lights_.bind(program_, kFogLightBinding);
  framebuffer.bind_depth(kDepthUnit);
  set_uniform(program_, "depths", kDepthUnit);
  set_uniform(program_, "sample_count", unsigned(Framebuffer::samples()));
  set_uniform(program_, "cookies", kCookieUnit);
  set_uniform(program_, "litfog_light_buffer", kLightBufferUnit);
  set_uniform(program_, "light_list", kLightListUnit);
  set_uniform(program_, "carried_count", carried);
  set_uniform(program_, "clip_from_world", view.clip_from_world);
  set_uniform(program_, "direction_from_clip", view.direction_from_clip);
  set_uniform(program_, "pixel_size", 2.0f / glm::vec2(framebuffer.width(), framebuffer.height()));
  set_uniform(program_, "eye", scene_.camera.position);
  set_uniform(program_, "forward", glm::normalize(scene_.camera.target - scene_.camera.position));
  set_uniform(program_, "near_plane", view.near_plane);
  set_uniform(program_, "sky_distance", kSkyDistance);
  set_uniform(program_, "fog_above_eye", view.fog_above_eye);
  set_uniform(program_, "budget", kBudget);
  set_uniform(program_, "largest_phase", largest_phase(scene_.phase_g));
  set_uniform(program_, "asymmetry", float(scene_.phase_g));
  glBindVertexArray(vertex_array_.id());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(lights));
  glDisable(GL_BLEND);
}

}  // namespace litfog::render
