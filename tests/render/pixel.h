// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

#include "render/picture.h"
#include "scene/scene.h"

namespace litfog::test {

inline glm::dvec3 pixel(const render::Picture& picture, int x, int y) {
  const float* at = &picture.rgb[(std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * 3];
  return {at[0], at[1], at[2]};
}

/// The direction in which the camera of a picture sees a point of it. Pixels from the top left corner: the middle of
/// the first pixel is (0.5, 0.5).
inline glm::dvec3 view_direction(const scene::Camera& camera, int width, int height, double x, double y) {
  const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target - camera.position));
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
  const glm::dvec3 up = glm::cross(right, forward);
  const double half = std::tan(double(camera.field_of_view) / 2);
  return glm::normalize(forward + right * ((2 * x / width - 1) * half * width / height) +
                        up * ((1 - 2 * y / height) * half));
}

/// Of all channels of two pictures of one size.
inline double largest_difference(const render::Picture& a, const render::Picture& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    largest = std::max(largest, std::abs(double(a.rgb[i]) - double(b.rgb[i])));
  }
  return largest;
}

}  // namespace litfog::test
