// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "render/gpu/depth.h"
#include "render/gpu/geometry_buffer.h"
#include "scene/camera.h"

namespace litfog::measure {

/// Directions through the centres of pixels; row 0 is the top row.
class PixelRays {
 public:
  PixelRays(const scene::Camera& camera, int width, int height)
      : axes_(axes_of(camera)),
        pixel_(2 * std::tan(double(camera.field_of_view) / 2) / height),
        middle_(width / 2.0, height / 2.0) {}

  glm::dvec3 direction(int x, int y) const {
    const glm::dvec2 off = pixel_ * glm::dvec2(x + 0.5 - middle_.x, middle_.y - y - 0.5);
    return glm::normalize(axes_.forward + axes_.right * off.x + axes_.up * off.y);
  }

  /// The length along a direction to a surface, metres.
  double length_to(const render::GeometrySample& surface, const glm::dvec3& direction) const {
    return render::kNearPlane / double(surface.depth) / glm::dot(direction, axes_.forward);
  }

 private:
  scene::CameraAxes axes_;
  double pixel_;       // size of a pixel one metre ahead
  glm::dvec2 middle_;  // pixels
};

}  // namespace litfog::measure
