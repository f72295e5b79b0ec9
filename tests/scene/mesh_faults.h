// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "scene/mesh.h"

namespace litfog::test {

/// What is wrong with a mesh, counted.
struct Faults {
  int not_finite = 0;
  int normals_not_unit = 0;  // by more than 1e-3
  int tangents_not_unit = 0;
  int tangents_not_square = 0;
  int signs_not_one = 0;
  int indices_out_of_range = 0;
  int without_area = 0;
  int facing_away = 0;  // from the mean of their vertices' normals
  int tangents_against_u = 0;
  int triangles = 0;
};

inline bool finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

inline void count_faults(const scene::Mesh& mesh, Faults& faults) {
  for (const scene::Vertex& vertex : mesh.vertices) {
    const glm::vec3 tangent(vertex.tangent);
    if (!finite(vertex.position) || !finite(vertex.normal) || !finite(tangent) || !std::isfinite(vertex.uv.x) ||
        !std::isfinite(vertex.uv.y)) {
      ++faults.not_finite;
    }
    if (!(std::abs(glm::length(vertex.normal) - 1.0f) <= 1e-3f)) ++faults.normals_not_unit;
    if (!(std::abs(glm::length(tangent) - 1.0f) <= 1e-3f)) ++faults.tangents_not_unit;
    if (!(std::abs(glm::dot(vertex.normal, tangent)) <= 1e-3f)) ++faults.tangents_not_square;
    if (!(std::abs(vertex.tangent.w) == 1.0f)) ++faults.signs_not_one;
  }
  if (mesh.indices.size() % 3 != 0) ++faults.indices_out_of_range;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    ++faults.triangles;
    const std::uint32_t* corner = &mesh.indices[i];
    if (corner[0] >= mesh.vertices.size() || corner[1] >= mesh.vertices.size() || corner[2] >= mesh.vertices.size()) {
      ++faults.indices_out_of_range;
      continue;
    }
    const scene::Vertex& a = mesh.vertices[corner[0]];
    const scene::Vertex& b = mesh.vertices[corner[1]];
    const scene::Vertex& c = mesh.vertices[corner[2]];
    const glm::vec3 area = glm::cross(b.position - a.position, c.position - a.position);
    // A tenth of a square millimetre.
    if (!(glm::length(area) > 2e-7f)) {
      ++faults.without_area;
      continue;
    }
    if (!(glm::dot(area, a.normal + b.normal + c.normal) > 0.0f)) ++faults.facing_away;
    // du along the mean tangent, seen through the linear map from the triangle to uv.
    const glm::vec3 tangent = glm::vec3(a.tangent) + glm::vec3(b.tangent) + glm::vec3(c.tangent);
    const glm::vec2 d1 = b.uv - a.uv;
    const glm::vec2 d2 = c.uv - a.uv;
    const float determinant = d1.x * d2.y - d1.y * d2.x;
    if (std::abs(determinant) < 1e-9f) continue;
    const glm::vec3 along_u = ((b.position - a.position) * d2.y - (c.position - a.position) * d1.y) / determinant;
    if (!(glm::dot(along_u, tangent) > 0.0f)) ++faults.tangents_against_u;
  }
}

inline Faults faults_of(const scene::Model& model) {
  Faults faults;
  for (const scene::Part& each : model) count_faults(each.mesh, faults);
  return faults;
}

}  // namespace litfog::test
