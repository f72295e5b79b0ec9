// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "reference/random_light.h"
#include "scene/mesh.h"

namespace litfog::test {

inline glm::dvec3 random_point(Random& random, double reach) {
  const double x = random.uniform(-reach, reach);
  const double y = random.uniform(-reach, reach);
  return {x, y, random.uniform(-reach, reach)};
}

inline glm::dvec3 random_point_in(Random& random, const scene::Bounds& box) {
  const double x = random.uniform(box.low.x, box.high.x);
  const double y = random.uniform(box.low.y, box.high.y);
  return {x, y, random.uniform(box.low.z, box.high.z)};
}

inline scene::Bounds random_box(Random& random) {
  const glm::vec3 low = random_point(random, 30);
  return {low, random_point_in(random, {low, low + 20.0f})};
}

}  // namespace litfog::test
