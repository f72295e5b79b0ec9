// SPDX-License-Identifier: Apache-2.0
#include "scene/model/band.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/noise.h"

namespace litfog::scene {
namespace {

/// Blades of one tuft: bent strips of a quad and a tip, seen from both sides.
void add_tuft(Mesh& mesh, const Grass& grass, const glm::vec3& spot, HashRandom& random) {
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
    // Normals lean upwards whichever way a blade turns, so that grass is lit like the lawn it stands on.
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

Model make_grass(const Grass& grass) {
  HashRandom random(std::uint32_t(grass.band.seed));
  Model model;
  Mesh& mesh = part(model, "blades");
  for (int tuft = 0; tuft < grass.tufts; ++tuft) add_tuft(mesh, grass, random_point(grass.band, random), random);
  compute_tangents(mesh);
  return model;
}

}  // namespace litfog::scene
