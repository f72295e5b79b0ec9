// SPDX-License-Identifier: Apache-2.0
#include "scene/model/forest.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/model/broadleaf.h"
#include "scene/model/conifer.h"
#include "scene/model/primitive.h"
#include "scene/model/rock.h"
#include "scene/noise.h"

namespace litfog::scene {
namespace {

glm::vec3 random_spot(const Band& band, Random& random) {
  const float along = random.between(band.from_m, band.to_m);
  const float beside = band.clear_m + band.reach_m * random.unit();
  const bool left = band.side < 0 || (band.side == 0 && random.unit() < 0.5f);
  glm::vec3 spot = band.point(along, left ? -beside : beside);
  spot.y = ground_height(band, spot.x, spot.z);
  return spot;
}

glm::mat4 standing(const glm::vec3& spot, float yaw, float scale) {
  return glm::scale(place(spot, yaw), glm::vec3(scale));
}

/// Blades of one tuft: bent strips of a quad and a tip, seen from both sides.
void add_tuft(Mesh& mesh, const Grass& grass, const glm::vec3& spot, Random& random) {
  // Tall and short patches of a few metres.
  const float vigour = 0.8f + 0.6f * gradient_noise(0.45f * spot.x, 0.45f * spot.z, 5);
  for (int blade = 0; blade < grass.blades; ++blade) {
    const float turn = random.between(0.0f, glm::two_pi<float>());
    const glm::vec3 out(std::sin(turn), 0.0f, std::cos(turn));
    const glm::vec3 side(out.z, 0.0f, -out.x);
    const float height = vigour * grass.height_m * random.between(0.45f, 1.2f);
    const float lean = height * random.between(0.15f, 0.7f);
    const float half = 0.003f + 0.008f * height;
    const glm::vec3 foot = spot + 0.12f * grass.height_m * out * random.unit() - glm::vec3(0.0f, 0.02f, 0.0f);
    const glm::vec3 knee = foot + 0.35f * lean * out + glm::vec3(0.0f, 0.65f * height, 0.0f);
    const glm::vec3 tip = foot + lean * out + glm::vec3(0.0f, height, 0.0f);
    // Grass is lit from above like the lawn it stands on, whichever way a blade turns.
    const glm::vec3 face = glm::normalize(glm::cross(side, knee - foot));
    for (const float hand : {1.0f, -1.0f}) {
      const glm::vec3 front = hand * face;
      const glm::vec3 normal = glm::normalize(front + 0.7f * (glm::vec3(0, 1, 0) - front * front.y));
      const auto first = std::uint32_t(mesh.vertices.size());
      const float u = random.unit();
      mesh.vertices.push_back({foot - half * side, normal, {}, {u - half, 0.0f}});
      mesh.vertices.push_back({foot + half * side, normal, {}, {u + half, 0.0f}});
      mesh.vertices.push_back({knee + 0.7f * half * side, normal, {}, {u + 0.7f * half, 0.65f * height}});
      mesh.vertices.push_back({knee - 0.7f * half * side, normal, {}, {u - 0.7f * half, 0.65f * height}});
      mesh.vertices.push_back({tip, normal, {}, {u, height}});
      const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.indices.insert(mesh.indices.end(), {first + a, first + (hand > 0 ? b : c), first + (hand > 0 ? c : b)});
      };
      add(0, 1, 2);
      add(0, 2, 3);
      add(3, 2, 4);
    }
  }
}

}  // namespace

Model make_forest(const Forest& forest) {
  Random random(std::uint32_t(forest.seed));
  Model model;
  std::vector<glm::vec3> trunks;
  for (int tree = 0; tree < forest.trees; ++tree) {
    // The best of a few spots: far enough from the others, or as far as it goes.
    glm::vec3 spot{};
    float best = -1.0f;
    for (int attempt = 0; attempt < 12 && best < forest.spacing_m; ++attempt) {
      const glm::vec3 candidate = random_spot(forest, random);
      float nearest = 1e9f;
      for (const glm::vec3& other : trunks) nearest = std::min(nearest, glm::distance(candidate, other));
      if (nearest <= best) continue;
      best = nearest;
      spot = candidate;
    }
    trunks.push_back(spot);
    const float height = random.between(forest.least_height_m, std::max(forest.least_height_m, forest.most_height_m));
    const bool far_away = std::abs(forest.offset_of(spot.x, spot.z)) > forest.clear_m + 12.0f;
    const int seed = int(random.bits() >> 12);
    const glm::mat4 at = standing(spot, random.between(0.0f, glm::two_pi<float>()), 1.0f);
    if (random.unit() < forest.broadleaf) {
      BroadleafTree kind;
      kind.height_m = 0.75f * height;
      kind.leaves = forest.leaves;
      kind.leaf_m *= far_away ? 2.0f : 1.0f;
      kind.forks = far_away ? 2 : 3;
      kind.seed = seed;
      append(model, make_broadleaf_tree(kind), at);
    } else {
      Spruce kind;
      kind.height_m = height;
      kind.spread = random.between(0.18f, 0.26f);
      kind.bare = random.between(0.03f, 0.12f);
      kind.whorls = far_away ? 13 : 18;
      kind.branches = far_away ? 6 : 7;
      kind.twigs = far_away ? 3 : 5;
      kind.seed = seed;
      append(model, make_spruce(kind), at);
    }
  }
  return model;
}

Model make_grass(const Grass& grass) {
  Random random(std::uint32_t(grass.seed));
  Model model;
  Mesh& mesh = part(model, "blades");
  for (int tuft = 0; tuft < grass.tufts; ++tuft) add_tuft(mesh, grass, random_spot(grass, random), random);
  compute_tangents(mesh);
  return model;
}

Model make_rocks(const Rocks& rocks) {
  Random random(std::uint32_t(rocks.seed));
  Model model;
  for (int rock = 0; rock < rocks.rocks; ++rock) {
    Rock kind;
    // Small ones are more frequent.
    const float share = random.unit();
    kind.size_m = glm::mix(rocks.least_size_m, std::max(rocks.least_size_m, rocks.most_size_m), share * share * share);
    kind.seed = int(random.bits() >> 12);
    const glm::vec3 spot = random_spot(rocks, random);
    append(model, make_rock(kind), standing(spot, random.between(0.0f, glm::two_pi<float>()), 1.0f));
  }
  return model;
}

}  // namespace litfog::scene
