// SPDX-License-Identifier: Apache-2.0
#include "papers/opengl_pictures.h"

#include <epoxy/gl.h>

#include <span>
#include <vector>

#include "litfog/gl/check_errors.h"
#include "litfog/gl/program.h"
#include "papers/paper_programs.h"
#include "render/gpu/depth.h"
#include "render/gpu/framebuffer.h"
#include "render/gpu/uniform.h"
#include "render/plan/view.h"

namespace litfog::papers {
namespace {

/// The corners of all triangles of a scene, in the world.
std::vector<glm::vec3> corners_of(const scene::Scene& scene) {
  std::vector<glm::vec3> corners;
  for (const scene::Instance& instance : scene.instances) {
    for (const scene::Part& part : scene.models[instance.model]) {
      for (const std::uint32_t i : part.mesh.indices) {
        corners.emplace_back(instance.world_from_model * glm::dvec4(part.mesh.vertices[i].position, 1));
      }
    }
  }
  return corners;
}

}  // namespace

render::Picture draw_stencil_shadow(const scene::Scene& scene, const glm::dvec3& lamp, int width, int height) {
  constexpr float kBias = 0.01f;
  const std::vector<glm::vec3> corners = corners_of(scene);
  const render::Framebuffer framebuffer(width, height, render::Passes::several, 1);
  const gl::Program surfaces("shadow_volume.vert", "white.frag", paper_shaders());
  const gl::Program volumes("shadow_volume.vert", "shadow_volume.geom", "white.frag", paper_shaders());
  const gl::VertexArrayName vertex_array;
  const gl::BufferName buffer;
  glBindVertexArray(vertex_array.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(std::span(corners).size_bytes()), corners.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
  framebuffer.bind();
  glClearColor(0, 0, 0, 1);
  glClearStencil(0);
  glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  render::begin_depths();
  glDisable(GL_CULL_FACE);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  const glm::mat4 clip_from_world = render::view_of(scene.camera, {width, height}, 0).clip_from_world;
  const auto draw = [&](const gl::Program& program) {
    program.use();
    render::set_uniform(program, "clip_from_world", clip_from_world);
    render::set_uniform(program, "lamp", glm::vec3(lamp));
    render::set_uniform(program, "bias", kBias);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(corners.size()));
  };
  draw(surfaces);
  glDepthMask(GL_FALSE);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 0, 0xff);
  glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
  glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
  draw(volumes);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glStencilFunc(GL_EQUAL, 0, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  draw(surfaces);
  glDisable(GL_STENCIL_TEST);
  render::end_depths();
  framebuffer.resolve();
  gl::check_errors("drawing shadows by stencil");
  return framebuffer.read();
}

}  // namespace litfog::papers
