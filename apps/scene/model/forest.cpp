// SPDX-License-Identifier: Apache-2.0
#include "scene/model/band.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "scene/model/tree.h"

namespace litfog::scene {

Model make_forest(const Forest& forest) {
  HashRandom random(std::uint32_t(forest.band.seed));
  Model model;
  std::vector<glm::vec3> trunks;
  for (int i = 0; i < forest.trees; ++i) {
    // The first of twelve spots that is far enough from the other trunks, or the farthest of them.
    glm::vec3 spot{};
    float best = -1.0f;
    for (int attempt = 0; attempt < 12 && best < forest.spacing_m; ++attempt) {
      const glm::vec3 candidate = random_point(forest.band, random);
      float nearest = 1e9f;
      for (const glm::vec3& other : trunks) nearest = std::min(nearest, glm::distance(candidate, other));
      if (nearest <= best) continue;
      best = nearest;
      spot = candidate;
    }
    trunks.push_back(spot);
    const float height = random.between(forest.least_height_m, std::max(forest.least_height_m, forest.most_height_m));
    const bool far_away = std::abs(forest.band.terrain.path.offset_of(spot.x, spot.z)) > forest.band.clear_m + 12.0f;
    const int seed = int(random.bits() >> 12);
    const glm::mat4 at = place(spot, random.between(0.0f, glm::two_pi<float>()));
    if (random.unit() < forest.broadleaf) {
      BroadleafTree tree;
      tree.height_m = 0.75f * height;
      tree.leaves = forest.leaves;
      tree.leaf_m *= far_away ? 2.0f : 1.0f;
      tree.forks = far_away ? 2 : 3;
      tree.seed = seed;
      append(model, make_broadleaf_tree(tree), at);
    } else {
      Spruce tree;
      tree.height_m = height;
      tree.spread = random.between(0.18f, 0.26f);
      tree.bare = random.between(0.03f, 0.12f);
      tree.whorls = far_away ? 13 : 18;
      tree.branches = far_away ? 6 : 7;
      tree.twigs = far_away ? 3 : 5;
      tree.seed = seed;
      append(model, make_spruce(tree), at);
    }
  }
  return model;
}

}  // namespace litfog::scene
