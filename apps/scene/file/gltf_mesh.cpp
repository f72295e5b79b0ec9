// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "scene/file/gltf_value.h"
#include "scene/scene.h"

namespace litfog::scene {
namespace {

constexpr std::size_t kTriangles = 4;  // a primitive's "mode"

/// Three indices a triangle: those given, or the vertices in their order.
void read_indices(const JsonValue& primitive, const GltfNumbers& given, std::size_t count, Mesh& mesh) {
  for (std::size_t i = 0; i < count; ++i) {
    const double vertex = given.data ? given.at(i, 0) : double(i);
    if (!(vertex < double(mesh.vertices.size()))) {
      primitive.member("indices").fail("must be those of given vertices");
    }
    mesh.indices.push_back(std::uint32_t(vertex));
  }
}

/// Three vertices of its own for each triangle, with its normal (glTF 2.0, 3.7.2.1: flat normals where none are
/// given).
void flatten(Mesh& mesh) {
  std::vector<Vertex> vertices;
  for (const std::uint32_t vertex : mesh.indices) vertices.push_back(mesh.vertices[vertex]);
  for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
    const glm::vec3 normal =
        glm::cross(vertices[i + 1].position - vertices[i].position, vertices[i + 2].position - vertices[i].position);
    for (std::size_t corner = i; corner < i + 3; ++corner) vertices[corner].normal = normal;
  }
  mesh.vertices = std::move(vertices);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) mesh.indices[i] = std::uint32_t(i);
}

template <glm::length_t N>
bool is_within_limits(const glm::vec<N, float>& v) {
  return glm::all(glm::lessThanEqual(glm::abs(v), glm::vec<N, float>(kMaxCoordinate)));
}

}  // namespace

void MeshBudget::take(const JsonValue& primitive, std::size_t triangles, std::size_t vertices) {
  triangles_ += triangles;
  vertices_ += vertices;
  if (triangles_ > kMaxTriangles || vertices_ > kMaxVertices) {
    primitive.fail(fmt::format("triangles must be at most {} in all, vertices {}", kMaxTriangles, kMaxVertices));
  }
}

Mesh read_gltf_primitive(const GltfFile& file, const JsonValue& primitive, bool is_double_sided, MeshBudget& budget) {
  using enum GltfComponent;
  if (const auto mode = primitive.optional("mode"); mode && whole_number(*mode) != kTriangles) {
    mode->fail("must be 4: this program draws triangles");
  }
  const JsonValue attributes = primitive.member("attributes");
  const GltfNumbers positions = file.numbers(attributes.member("POSITION"), kGltfVec3, {floating});
  const auto attribute = [&](const char* name, const GltfType& type, std::initializer_list<GltfComponent> components) {
    const auto index = attributes.optional(name);
    if (!index) return GltfNumbers{};
    const GltfNumbers given = file.numbers(*index, type, components);
    if (given.count != positions.count) index->fail("must have as many elements as POSITION");
    return given;
  };
  const GltfNumbers normals = attribute("NORMAL", kGltfVec3, {floating});
  const GltfNumbers tangents = attribute("TANGENT", kGltfVec4, {floating});
  const GltfNumbers uvs = attribute("TEXCOORD_0", kGltfVec2, {floating, unsigned_byte, unsigned_short});
  GltfNumbers indices;
  if (const auto index = primitive.optional("indices")) {
    indices = file.numbers(*index, kGltfScalar, {unsigned_byte, unsigned_short, unsigned_int});
  }
  const std::size_t index_count = indices.data ? indices.count : positions.count;
  if (index_count % 3 != 0) {
    const auto index = primitive.optional("indices");
    (index ? *index : primitive).fail(primitive.path_of("indices"), "", "must be three a triangle");
  }
  const std::size_t sides = is_double_sided ? 2 : 1;
  const std::size_t vertex_count = normals.data ? positions.count : std::max(positions.count, index_count);
  budget.take(primitive, sides * index_count / 3, sides * vertex_count);
  Mesh mesh;
  bool has_tangents = normals.data && tangents.data && uvs.data;
  for (std::size_t i = 0; i < positions.count; ++i) {
    Vertex vertex{positions.vec3(i), glm::vec3(0, 1, 0), glm::vec4(0), glm::vec2(0)};
    if (normals.data) vertex.normal = normals.vec3(i);
    if (tangents.data) vertex.tangent = glm::vec4(tangents.vec3(i), tangents.at(i, 3) < 0 ? -1 : 1);
    if (uvs.data) vertex.uv = {uvs.at(i, 0), uvs.at(i, 1)};
    const bool is_sound = is_within_limits(vertex.position) && is_within_limits(vertex.normal) &&
                          is_within_limits(vertex.tangent) && is_within_limits(vertex.uv);
    if (!is_sound) attributes.fail(fmt::format("must be finite and at most {}", kMaxCoordinate));
    has_tangents = has_tangents && glm::length(glm::vec3(vertex.tangent)) > 0;
    mesh.vertices.push_back(vertex);
  }
  read_indices(primitive, indices, index_count, mesh);
  if (!normals.data) flatten(mesh);
  for (Vertex& vertex : mesh.vertices) {
    const float length = glm::length(vertex.normal);
    vertex.normal = length > 0 ? vertex.normal / length : glm::vec3(0, 1, 0);
  }
  if (!has_tangents) {
    compute_tangents(mesh);
    // There v grows along the bitangent; glTF's v runs down a picture whose normals have +Y up.
    for (Vertex& vertex : mesh.vertices) vertex.tangent.w = -vertex.tangent.w;
  }
  if (is_double_sided) add_back_faces(mesh);
  return mesh;
}

}  // namespace litfog::scene
