// SPDX-License-Identifier: Apache-2.0
#include "window/moved_picture.h"

#include "window/camera_motion.h"
#include "window/light_pick.h"

namespace litfog::window {

MovedPicture::MovedPicture(const scene::Camera& drawn, double drawn_aspect, const scene::Camera& camera, double aspect,
                           const measure::TriangleTree* surfaces) {
  for (int row = 0; row <= kRows; ++row) {
    for (int column = 0; column <= kColumns; ++column) {
      const EyeRay ray = ray_through(camera, aspect, place(column, row));
      double range = target_distance(camera);
      if (surfaces) {
        const auto hit = surfaces->nearest(ray.origin, ray.direction, 0, kFarthestSurface);
        range = hit ? hit->distance : kFarthestSurface;
      }
      const auto source = place_in_picture(drawn, drawn_aspect, ray.origin + range * ray.direction);
      const bool is_far = source && glm::any(glm::greaterThan(glm::abs(*source - 0.5), glm::dvec2(0.5 + kMargin)));
      sources_.push_back(is_far ? std::nullopt : source);
    }
  }
}

}  // namespace litfog::window
