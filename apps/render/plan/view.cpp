// SPDX-License-Identifier: Apache-2.0
#include "render/plan/view.h"

#include <algorithm>
#include <cmath>

#include "render/gpu/depth.h"

namespace litfog::render {

double pixels_per_radian(const scene::Camera& camera, int height) {
  return height / (2 * std::tan(double(camera.field_of_view) / 2));
}

View view_of(const scene::Camera& camera, glm::ivec2 size, double top_above_eye) {
  const glm::mat4 clip_from_eye = clip_from_view(camera, double(size.x) / size.y);
  const glm::mat4 view_from_world = scene::view_from_world<float>(camera);
  // Leaves out the eye's position: far from the origin, rounding of (near point - eye) would rotate the rays.
  const auto turned = glm::mat4(glm::mat3(view_from_world));
  return {.size = size,
          .eye = camera.position,
          .forward = glm::normalize(glm::vec3(camera.target) - glm::vec3(camera.position)),
          .clip_from_world = clip_from_eye * view_from_world,
          .direction_from_clip = glm::inverse(clip_from_eye * turned),
          .pixels_per_radian = pixels_per_radian(camera, size.y),
          .top_above_eye = top_above_eye};
}

Frustum make_frustum(const glm::mat4& clip_from_world) {
  const glm::mat4 rows = glm::transpose(clip_from_world);
  return {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
          rows[3] - rows[1], rows[3] + rows[2], rows[3] - rows[2]};
}

bool can_see(const Frustum& frustum, const scene::Bounds& box) {
  return std::ranges::all_of(frustum, [&](const glm::vec4& plane) {
    const glm::vec3 farthest{plane.x > 0 ? box.high.x : box.low.x, plane.y > 0 ? box.high.y : box.low.y,
                             plane.z > 0 ? box.high.z : box.low.z};
    return glm::dot(glm::vec3(plane), farthest) + plane.w >= 0;
  });
}

}  // namespace litfog::render
