// SPDX-License-Identifier: Apache-2.0
#include "scene/model/tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/hash_random.h"
#include "scene/model/primitive.h"

namespace litfog::scene {
namespace {

struct Growth {
  Mesh wood;
  Mesh leaves;
  HashRandom random;
  glm::vec3 crown;  ///< leaves face away from here
  float leaf_fraction;
  float leaf_m;
  float spread;
  int forks;
};

glm::vec3 any_direction(HashRandom& random) {
  const float y = random.between(-1.0f, 1.0f);
  const float turn = random.between(0.0f, glm::two_pi<float>());
  const float flat = std::sqrt(1.0f - y * y);
  return {flat * std::cos(turn), y, flat * std::sin(turn)};
}

/// A leaf: two triangles folded along the midrib, seen from both sides.
void add_leaf(Growth& growth, const glm::vec3& at) {
  HashRandom& random = growth.random;
  const glm::vec3 away = glm::normalize(at - growth.crown + glm::vec3(0.0f, 1e-3f, 0.0f));
  const glm::vec3 along = glm::normalize(any_direction(random) + 0.5f * away - glm::vec3(0.0f, 0.35f, 0.0f));
  const glm::vec3 across = glm::normalize(glm::cross(along, any_direction(random) + 0.1f * along));
  const float length = growth.leaf_m * random.between(0.7f, 1.3f);
  const float half = 0.36f * length;
  const glm::vec3 fold = 0.3f * half * glm::cross(across, along);
  const std::array<glm::vec3, 4> corners{at, at + 0.5f * length * along + half * across + fold, at + length * along,
                                         at + 0.5f * length * along - half * across + fold};
  const glm::vec3 front = glm::normalize(glm::cross(corners[1] - corners[0], corners[3] - corners[0]));
  const float shift_v = random.unit();
  const float shift_u = random.unit();
  const glm::vec2 shift(shift_u, shift_v);
  const std::array<glm::vec2, 4> uv{shift, shift + glm::vec2(half, 0.5f * length), shift + glm::vec2(0.0f, length),
                                    shift + glm::vec2(-half, 0.5f * length)};
  for (const float side : {1.0f, -1.0f}) {
    // Normals that lean out of the crown make a tree look round instead of like confetti.
    const glm::vec3 face = side * front;
    const float lean = glm::dot(face, away) > 0.0f ? 1.0f : 0.3f;
    const glm::vec3 normal = glm::normalize(face + lean * (away - face * glm::dot(face, away)));
    const auto first = std::uint32_t(growth.leaves.vertices.size());
    for (std::size_t i = 0; i < corners.size(); ++i) growth.leaves.vertices.push_back({corners[i], normal, {}, uv[i]});
    for (const std::uint32_t i : {1u, 2u}) {
      const std::uint32_t next = i + 1;
      growth.leaves.indices.insert(growth.leaves.indices.end(),
                                   {first, first + (side > 0.0f ? i : next), first + (side > 0.0f ? next : i)});
    }
  }
}

void grow(Growth& growth, const glm::vec3& root, glm::vec3 direction, float length, float radius, int level) {
  HashRandom& random = growth.random;
  const int pieces = level == growth.forks && level > 2 ? 2 : 4;
  std::vector<glm::vec3> line{root};
  std::vector<float> radii{radius};
  const float wander = level == 0 ? 0.10f : 0.28f;
  for (int i = 1; i <= pieces; ++i) {
    // Boughs turn up towards the light; twigs go anywhere.
    direction =
        glm::normalize(direction + wander * any_direction(random) + glm::vec3(0.0f, level < 2 ? 0.12f : 0.03f, 0.0f));
    line.push_back(line.back() + direction * (length / float(pieces)));
    radii.push_back(radius * (1.0f - 0.62f * float(i) / float(pieces)));
  }
  append(growth.wood, make_tube(line, radii, level == 0 ? 8 : level == 1 ? 5 : 3));
  if (level >= growth.forks - 1) {
    for (int i = 1; i <= pieces; ++i) {
      const float wanted = 4.5f * growth.leaf_fraction;
      const int count = int(wanted + random.unit());
      for (int k = 0; k < count; ++k) {
        add_leaf(growth, line[std::size_t(i)] + 0.6f * growth.leaf_m * any_direction(random));
      }
    }
  }
  if (level == growth.forks) return;
  const int children = level == 0 ? 8 : 5;
  const float turn = random.between(0.0f, glm::two_pi<float>());
  for (int i = 0; i < children; ++i) {
    const float t = glm::mix(level == 0 ? 0.38f : 0.3f, 1.0f, float(i) / float(children - 1));
    const float place = t * float(pieces);
    const auto piece = std::min(std::size_t(place), std::size_t(pieces - 1));
    const glm::vec3 start = glm::mix(line[piece], line[piece + 1], place - float(piece));
    const glm::vec3 along = glm::normalize(line[piece + 1] - line[piece]);
    // Round the stem by the golden angle, as buds are set.
    const float angle = turn + 2.39996f * float(i) + random.between(-0.3f, 0.3f);
    const glm::vec3 other = std::abs(along.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 side = glm::normalize(glm::cross(along, other));
    const glm::vec3 out = side * std::cos(angle) + glm::cross(along, side) * std::sin(angle);
    const float open = glm::mix(1.25f, 0.5f, t) * (level == 0 ? 2.0f * growth.spread : 0.9f);
    const float ratio = level == 0 ? glm::mix(0.62f, 0.42f, t) : 0.55f;
    grow(growth, start, glm::normalize(along + out * open), length * ratio * random.between(0.8f, 1.15f),
         radius * (1.0f - 0.62f * t) * 0.62f, level + 1);
  }
}

Model finish(Growth& growth) {
  compute_tangents(growth.leaves);
  Model model;
  part(model, "bark") = std::move(growth.wood);
  if (!growth.leaves.vertices.empty()) part(model, "leaves") = std::move(growth.leaves);
  return model;
}

}  // namespace

Model make_broadleaf_tree(const BroadleafTree& tree) {
  const float height = tree.height_m;
  Growth growth{{},
                {},
                HashRandom(std::uint32_t(tree.seed)),
                glm::vec3(0.0f, 0.55f * height, 0.0f),
                tree.leaves,
                tree.leaf_m,
                tree.spread,
                tree.forks};
  const float lean_x = growth.random.between(-0.08f, 0.08f);
  const float lean_z = growth.random.between(-0.08f, 0.08f);
  grow(growth, glm::vec3(0.0f, -0.1f, 0.0f), glm::normalize(glm::vec3(lean_x, 1.0f, lean_z)), 0.66f * height,
       0.022f * height + 0.02f, 0);
  return finish(growth);
}

Model make_bush(const Bush& bush) {
  const float height = bush.height_m;
  Growth growth{
      {},   {}, HashRandom(std::uint32_t(bush.seed)), glm::vec3(0.0f, 0.2f * height, 0.0f), bush.leaves, bush.leaf_m,
      0.5f, 3};
  for (int i = 0; i < bush.stems; ++i) {
    const float turn = glm::two_pi<float>() * (float(i) + growth.random.unit()) / float(bush.stems);
    const glm::vec3 out(std::sin(turn), 0.0f, std::cos(turn));
    const float length = height * growth.random.between(0.6f, 0.85f);
    const float open = growth.random.between(0.3f, 1.0f);
    grow(growth, 0.08f * height * out - glm::vec3(0.0f, 0.05f, 0.0f),
         glm::normalize(out * open + glm::vec3(0.0f, 1.0f, 0.0f)), length, 0.008f * height + 0.006f, 1);
  }
  return finish(growth);
}

}  // namespace litfog::scene
