// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/depth.h"

#include <epoxy/gl.h>

#include <glm/gtc/matrix_transform.hpp>
#include <string_view>

namespace litfog::render {

bool has_clip_control() { return epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control"); }

bool should_test_depth_late(int samples) {
  if (samples == 1 || !epoxy_has_gl_extension("GL_ARB_shader_stencil_export")) return false;
  const auto* const renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return renderer && std::string_view(renderer).starts_with("llvmpipe");
}

float far_plane_in_clip() { return has_clip_control() ? 0.0f : -1.0f; }

glm::mat4 clip_from_view(const scene::Camera& camera, double aspect) {
  glm::mat4 clip_from_view = glm::infinitePerspective(camera.field_of_view, float(aspect), kNearPlane);
  // Clip z. GL computes the depth kNearPlane / w from it, as z / w or as 0.5 z / w + 0.5.
  const glm::vec4 z = has_clip_control() ? glm::vec4(0, 0, 0, kNearPlane) : glm::vec4(0, 0, 1, 2 * kNearPlane);
  for (int column = 0; column < 4; ++column) clip_from_view[column].z = z[column];
  return clip_from_view;
}

void begin_depths() {
  if (has_clip_control()) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GEQUAL);
  glDepthMask(GL_TRUE);
  glClearDepth(0);
  glClear(GL_DEPTH_BUFFER_BIT);
}

void end_depths() {
  if (has_clip_control()) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  glDisable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glClearDepth(1);
}

}  // namespace litfog::render
