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

/// Adds a triangle of needles. Its normal leans towards `out`, away from the trunk: real needles stand all ways, and a
/// flat sheet would flicker from lit to dark.
void add_needles(Mesh& mesh, const std::array<glm::vec3, 3>& corners, const std::array<glm::vec2, 3>& uv,
                 const glm::vec3& out) {
  const glm::vec3 face = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (const float side : {1.0f, -1.0f}) {
    const glm::vec3 front = side * face;
    const float lean = glm::dot(front, out) > 0.0f ? 0.9f : 0.35f;
    const glm::vec3 normal = glm::normalize(front + lean * (out - front * glm::dot(front, out)));
    const auto first = std::uint32_t(mesh.vertices.size());
    for (std::size_t i = 0; i < 3; ++i) mesh.vertices.push_back({corners[i], normal, {}, uv[i]});
    mesh.indices.insert(mesh.indices.end(), {first, first + (side > 0 ? 1u : 2u), first + (side > 0 ? 2u : 1u)});
  }
}

struct Branch {
  glm::vec3 root;
  float turn;  ///< about the trunk
  float length;
  float rise;   ///< slope at the trunk
  float droop;  ///< how far the middle hangs, as a fraction of the length
};

void add_branch(Mesh& mesh, const Branch& branch, int twigs, HashRandom& random) {
  const auto pieces = float(twigs);
  const glm::vec3 out(std::sin(branch.turn), 0.0f, std::cos(branch.turn));
  const glm::vec3 side(out.z, 0.0f, -out.x);
  // Rises or falls from the trunk, hangs, and lifts its tip.
  const auto spine = [&](float t) {
    const float y = branch.length * (branch.rise * t - branch.droop * 4.0f * t * (1.0f - 0.55f * t) * 0.5f);
    return branch.root + out * (branch.length * t) + glm::vec3(0.0f, y, 0.0f);
  };
  const float width = 0.36f * branch.length + 0.1f;
  for (int i = 0; i < twigs; ++i) {
    const float t0 = 0.03f + 0.97f * float(i) / pieces;
    const float t1 = i + 1 == twigs ? 1.0f : t0 + 1.3f * 0.97f / pieces;
    const glm::vec3 from = spine(t0);
    const glm::vec3 to = spine(std::min(t1, 1.0f));
    const glm::vec3 normal = glm::normalize(out * 0.6f + glm::vec3(0.0f, 0.7f, 0.0f));
    for (const float hand : {-1.0f, 1.0f}) {
      // A twig points forward and outward, and hangs.
      const float reach = width * (1.0f - 0.65f * t0) * random.between(0.75f, 1.25f);
      const float drop = reach * random.between(0.35f, 0.75f);
      const glm::vec3 tip =
          glm::mix(from, to, random.between(0.75f, 1.15f)) + side * (hand * reach) - glm::vec3(0.0f, drop, 0.0f);
      const float along = branch.length * t0;
      const std::array<glm::vec3, 3> corners{from, hand < 0 ? to : tip, hand < 0 ? tip : to};
      const std::array<glm::vec2, 3> uv{
          glm::vec2(0.0f, along),
          hand < 0 ? glm::vec2(0.0f, along + branch.length * (t1 - t0)) : glm::vec2(reach, along),
          hand < 0 ? glm::vec2(-reach, along) : glm::vec2(0.0f, along + branch.length * (t1 - t0))};
      add_needles(mesh, corners, uv, glm::normalize(normal + side * (0.5f * hand)));
    }
    // The fringe that hangs below the spine, which is what one sees of a spruce from the side.
    const float hang = (0.22f * branch.length + 0.12f) * random.between(0.6f, 1.3f) * (1.0f - 0.4f * t0);
    const glm::vec3 low = glm::mix(from, to, 0.6f) - glm::vec3(0.0f, hang, 0.0f) + side * random.between(-0.1f, 0.1f);
    add_needles(mesh, {from, low, to},
                {glm::vec2(0.0f, branch.length * t0), glm::vec2(hang, branch.length * 0.5f * (t0 + t1)),
                 glm::vec2(0.0f, branch.length * t1)},
                normal);
  }
}

}  // namespace

Model make_spruce(const Spruce& spruce) {
  HashRandom random(std::uint32_t(spruce.seed));
  Model model;
  const float height = spruce.height_m;
  const float lean_x = random.between(-0.02f, 0.02f) * height;
  const float lean_z = random.between(-0.02f, 0.02f) * height;
  const auto trunk = [&](float t) { return glm::vec3(lean_x * t * t, height * t, lean_z * t * t); };
  const float girth = 0.014f * height + 0.03f;
  std::vector<glm::vec3> line;
  std::vector<float> radii;
  for (const float t : {-0.02f, 0.03f, 0.3f, 0.6f, 0.985f}) {
    line.push_back(trunk(t));
    radii.push_back(girth * (1.0f - t) * (t < 0.0f ? 1.5f : 1.0f) + 0.004f);
  }
  append(part(model, "bark"), make_tube(line, radii, 7));

  Mesh& needles = part(model, "needles");
  for (int whorl = 0; whorl < spruce.whorls; ++whorl) {
    // Whorls stand closer towards the top.
    const float fraction = (float(whorl) + random.between(-0.3f, 0.3f)) / float(spruce.whorls);
    const float t = spruce.bare + (0.97f - spruce.bare) * std::pow(glm::clamp(fraction, 0.0f, 1.0f), 0.9f);
    const float crown = 1.0f - (t - spruce.bare) / (1.0f - spruce.bare);
    // Slightly convex outline; the lowest branches, in the shade of the others, are shorter.
    const float outline = std::pow(crown, 0.85f) * (fraction < 0.08f ? 0.8f : 1.0f);
    const float first_turn = random.between(0.0f, glm::two_pi<float>());
    for (int i = 0; i < spruce.branches; ++i) {
      Branch branch;
      branch.turn =
          first_turn + glm::two_pi<float>() * (float(i) + random.between(-0.35f, 0.35f)) / float(spruce.branches);
      branch.length = height * spruce.spread * outline * random.between(0.72f, 1.15f) + 0.02f * height;
      const float offset = random.between(-0.4f, 0.4f) / float(spruce.whorls);
      branch.root = trunk(glm::clamp(t + offset, 0.02f, 0.985f));
      // Old branches below fall, young ones near the top rise.
      branch.rise = glm::mix(0.75f, -0.15f, std::min(1.0f, 1.3f * crown)) + random.between(-0.12f, 0.12f);
      branch.droop = random.between(0.12f, 0.28f) * std::min(1.0f, 1.5f * crown);
      add_branch(needles, branch, spruce.twigs, random);
    }
  }
  // The leader.
  const glm::vec3 top = trunk(1.0f);
  for (int i = 0; i < 3; ++i) {
    const float turn = glm::two_pi<float>() * float(i) / 3.0f;
    const glm::vec3 out(std::sin(turn), 0.0f, std::cos(turn));
    const glm::vec3 foot = trunk(0.93f);
    add_needles(needles, {foot, foot + 0.025f * height * out + glm::vec3(0.0f, 0.02f * height, 0.0f), top},
                {glm::vec2(0.0f), glm::vec2(0.025f * height, 0.02f * height), glm::vec2(0.0f, 0.07f * height)}, out);
  }
  compute_tangents(needles);
  return model;
}

}  // namespace litfog::scene
