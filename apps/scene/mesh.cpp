// SPDX-License-Identifier: Apache-2.0
#include "scene/mesh.h"

#include <algorithm>
#include <cstddef>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <utility>

namespace litfog::scene {
namespace {

/// A tangent for a unit normal, continuous in the normal everywhere but straight down, where every such field must
/// break (Frisvad 2012, "Building an Orthonormal Basis from a 3D Unit Vector Without Normalization"). It must be
/// continuous because values in tangent space are interpolated between vertices; basis_from_world (light_frame.h) is
/// not.
glm::vec3 perpendicular(const glm::vec3& normal) {
  if (normal.y < -0.9999f) return glm::normalize(glm::vec3(1, 0, 0) - normal * normal.x);
  const float tilt = normal.x / (1 + normal.y);
  return glm::normalize(glm::vec3(1 - normal.x * tilt, -normal.x, -normal.z * tilt));
}

void extend(Bounds& box, const Mesh& mesh) {
  for (const Vertex& vertex : mesh.vertices) {
    box.low = glm::min(box.low, vertex.position);
    box.high = glm::max(box.high, vertex.position);
  }
}

/// Fills in default details.
void give_details(Mesh& mesh) {
  for (std::size_t i = mesh.details.size(); i < mesh.vertices.size(); ++i) mesh.details.push_back(detail_of(mesh, i));
}

constexpr Bounds kEmpty{glm::vec3(std::numeric_limits<float>::max()), glm::vec3(std::numeric_limits<float>::lowest())};

/// append() by a matrix of floats or doubles.
template <typename Matrix>
void append_by(Mesh& whole, const Mesh& piece, const Matrix& whole_from_piece) {
  using Real = typename Matrix::value_type;
  using Vector = glm::vec<3, Real>;
  using Linear = glm::mat<3, 3, Real>;
  const Linear linear(whole_from_piece);
  const Linear normals = glm::transpose(glm::inverse(linear));
  const bool mirrored = glm::determinant(linear) < 0;
  const auto first = std::uint32_t(whole.vertices.size());
  if (!piece.details.empty()) {
    give_details(whole);
    whole.details.insert(whole.details.end(), piece.details.begin(), piece.details.end());
  }
  for (const Vertex& vertex : piece.vertices) {
    const Vector normal = glm::normalize(normals * Vector(vertex.normal));
    // A non-uniform scale tilts the tangent off the normal's plane.
    Vector tangent = linear * Vector(vertex.tangent);
    tangent = glm::normalize(tangent - normal * glm::dot(normal, tangent));
    whole.vertices.push_back({glm::vec3(whole_from_piece * glm::vec<4, Real>(vertex.position, 1)), normal,
                              glm::vec4(tangent, mirrored ? -vertex.tangent.w : vertex.tangent.w), vertex.uv});
  }
  if (!whole.details.empty()) give_details(whole);
  for (std::size_t i = 0; i + 2 < piece.indices.size(); i += 3) {
    whole.indices.push_back(first + piece.indices[i]);
    whole.indices.push_back(first + piece.indices[mirrored ? i + 2 : i + 1]);
    whole.indices.push_back(first + piece.indices[mirrored ? i + 1 : i + 2]);
  }
}

}  // namespace

VertexDetail detail_of(const Mesh& mesh, std::size_t vertex) {
  if (vertex < mesh.details.size()) return mesh.details[vertex];
  const glm::vec2 uv = mesh.vertices[vertex].uv;
  return {.normal_uv = uv, .emission_uv = uv};
}

Bounds bounds(const Mesh& mesh) {
  Bounds box = kEmpty;
  extend(box, mesh);
  return box;
}

Bounds bounds(const Model& model) {
  Bounds box = kEmpty;
  for (const Part& piece : model) extend(box, piece.mesh);
  return box;
}

Bounds united(const Bounds& a, const Bounds& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

Bounds transformed(const Bounds& box, const glm::mat4& to_from_box) {
  const glm::vec3 centre = glm::vec3(to_from_box * glm::vec4((box.low + box.high) * 0.5f, 1.0f));
  const glm::vec3 half = (box.high - box.low) * 0.5f;
  const glm::vec3 reach = glm::abs(glm::vec3(to_from_box[0])) * half.x + glm::abs(glm::vec3(to_from_box[1])) * half.y +
                          glm::abs(glm::vec3(to_from_box[2])) * half.z;
  return {centre - reach, centre + reach};
}

double nearest_distance(const glm::dvec3& point, const Bounds& box) {
  return glm::distance(point, glm::clamp(point, glm::dvec3(box.low), glm::dvec3(box.high)));
}

double farthest_distance(const glm::dvec3& point, const Bounds& box) {
  return glm::length(glm::max(glm::abs(point - glm::dvec3(box.low)), glm::abs(point - glm::dvec3(box.high))));
}

std::size_t triangle_count(const Model& model) {
  std::size_t count = 0;
  for (const Part& piece : model) count += piece.mesh.indices.size() / 3;
  return count;
}

void append(Mesh& whole, const Mesh& piece, const glm::mat4& whole_from_piece) {
  append_by(whole, piece, whole_from_piece);
}

void append(Mesh& whole, const Mesh& piece, const glm::dmat4& whole_from_piece) {
  append_by(whole, piece, whole_from_piece);
}

void append(Model& whole, const Model& piece, const glm::mat4& whole_from_piece) {
  for (const Part& each : piece) append(part(whole, each.material), each.mesh, whole_from_piece);
}

Mesh& part(Model& model, std::string_view material) {
  for (Part& piece : model) {
    if (piece.material == material) return piece.mesh;
  }
  return model.emplace_back(Part{std::string(material), {}}).mesh;
}

glm::mat4 place(const glm::vec3& position, float yaw) {
  return glm::rotate(glm::translate(glm::mat4(1.0f), position), yaw, glm::vec3(0, 1, 0));
}

void compute_tangents(Mesh& mesh) {
  std::vector<std::pair<glm::vec3, glm::vec3>> sums(mesh.vertices.size(), {glm::vec3(0), glm::vec3(0)});
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vertex& a = mesh.vertices[mesh.indices[i]];
    const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
    const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
    const glm::vec3 ab = b.position - a.position;
    const glm::vec3 ac = c.position - a.position;
    const glm::vec2 uv_ab = b.uv - a.uv;
    const glm::vec2 uv_ac = c.uv - a.uv;
    const float determinant = uv_ab.x * uv_ac.y - uv_ab.y * uv_ac.x;
    if (determinant == 0.0f) continue;
    // Not divided by the determinant's magnitude, so that each triangle is weighted by its area.
    const float sign = determinant < 0.0f ? -1.0f : 1.0f;
    const glm::vec3 tangent = sign * (ab * uv_ac.y - ac * uv_ab.y);
    const glm::vec3 bitangent = sign * (ac * uv_ab.x - ab * uv_ac.x);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      auto& [tangent_sum, bitangent_sum] = sums[mesh.indices[i + corner]];
      tangent_sum += tangent;
      bitangent_sum += bitangent;
    }
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    Vertex& vertex = mesh.vertices[i];
    const auto& [tangent_sum, bitangent_sum] = sums[i];
    glm::vec3 tangent = tangent_sum - vertex.normal * glm::dot(vertex.normal, tangent_sum);
    const float length = glm::length(tangent);
    const bool usable = length > 1e-3f * glm::length(tangent_sum) && length > 1e-20f;
    tangent = usable ? tangent / length : perpendicular(vertex.normal);
    const float sign = glm::dot(glm::cross(vertex.normal, tangent), bitangent_sum) < 0.0f ? -1.0f : 1.0f;
    vertex.tangent = glm::vec4(tangent, sign);
  }
}

void add_back_faces(Mesh& mesh) {
  const auto vertices = std::uint32_t(mesh.vertices.size());
  const std::size_t indices = mesh.indices.size();
  mesh.vertices.reserve(2 * mesh.vertices.size());
  mesh.indices.reserve(2 * indices);
  for (std::uint32_t i = 0; i < vertices; ++i) {
    Vertex vertex = mesh.vertices[i];
    vertex.normal = -vertex.normal;
    vertex.tangent.w = -vertex.tangent.w;
    mesh.vertices.push_back(vertex);
  }
  if (!mesh.details.empty()) {
    mesh.details.resize(2 * std::size_t(vertices));
    std::copy_n(mesh.details.begin(), vertices, mesh.details.begin() + std::ptrdiff_t(vertices));
  }
  for (std::size_t i = 0; i + 2 < indices; i += 3) {
    mesh.indices.push_back(vertices + mesh.indices[i]);
    mesh.indices.push_back(vertices + mesh.indices[i + 2]);
    mesh.indices.push_back(vertices + mesh.indices[i + 1]);
  }
}

}  // namespace litfog::scene
