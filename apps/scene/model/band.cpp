// SPDX-License-Identifier: Apache-2.0
#include "scene/model/band.h"

namespace litfog::scene {

glm::vec3 random_point(const Band& band, HashRandom& random) {
  const float along = random.between(band.from_m, band.to_m);
  const float beside = band.clear_m + band.reach_m * random.unit();
  const bool left = band.side < 0 || (band.side == 0 && random.unit() < 0.5f);
  glm::vec3 point = band.terrain.path.point(along, left ? -beside : beside);
  point.y = height_at(band.terrain, point.x, point.z);
  return point;
}

}  // namespace litfog::scene
