// SPDX-License-Identifier: Apache-2.0
#include "render/plan/frustum.h"

#include <algorithm>

namespace litfog::render {

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
