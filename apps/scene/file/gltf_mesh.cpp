// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_mesh.h"

#include <fmt/format.h>

#include "scene/scene.h"

namespace litfog::scene {
namespace {

void read_indices(const GltfFile& file, const GltfPlace& place, const tinygltf::Primitive& primitive, Mesh& mesh) {
  std::size_t count = mesh.vertices.size();
  GltfNumbers indices;
  if (primitive.indices >= 0) {
    indices = file.numbers(place / "indices", primitive.indices, TINYGLTF_TYPE_SCALAR,
                           {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                            TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT});
    count = indices.count;
  }
  if (count % 3 != 0) file.refuse(place / "indices", "must be three a triangle");
  if (count > 3 * kMaxTriangles) file.refuse(place / "indices", fmt::format("must be at most {}", 3 * kMaxTriangles));
  for (std::size_t i = 0; i < count; ++i) {
    const double vertex = indices.data ? indices.at(i, 0) : double(i);
    if (!(vertex < double(mesh.vertices.size()))) file.refuse(place / "indices", "must be those of given vertices");
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

Mesh read_gltf_primitive(const GltfFile& file, const GltfPlace& place, const tinygltf::Primitive& primitive) {
  constexpr int kFloat = TINYGLTF_COMPONENT_TYPE_FLOAT;
  constexpr int kByte = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
  constexpr int kShort = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1) {
    file.refuse(place / "mode", "must be 4: this program draws triangles");
  }
  const auto attribute = [&](const char* name, int type, std::initializer_list<int> components) {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) return GltfNumbers{};
    return file.numbers(place / "attributes" / name, found->second, type, components);
  };
  const GltfNumbers positions = attribute("POSITION", TINYGLTF_TYPE_VEC3, {kFloat});
  if (!positions.data) file.refuse(place / "attributes" / "POSITION", "must be given");
  const GltfNumbers normals = attribute("NORMAL", TINYGLTF_TYPE_VEC3, {kFloat});
  const GltfNumbers tangents = attribute("TANGENT", TINYGLTF_TYPE_VEC4, {kFloat});
  const GltfNumbers uvs = attribute("TEXCOORD_0", TINYGLTF_TYPE_VEC2, {kFloat, kByte, kShort});
  for (const auto& [name, given] : {std::pair{"NORMAL", normals}, {"TANGENT", tangents}, {"TEXCOORD_0", uvs}}) {
    if (given.data && given.count != positions.count) {
      file.refuse(place / "attributes" / name, "must have as many elements as POSITION");
    }
  }
  Mesh mesh;
  bool has_tangents = normals.data && tangents.data && uvs.data;
  for (std::size_t i = 0; i < positions.count; ++i) {
    Vertex vertex{positions.vec3(i), glm::vec3(0, 1, 0), glm::vec4(0), glm::vec2(0)};
    if (normals.data) vertex.normal = normals.vec3(i);
    if (tangents.data) vertex.tangent = glm::vec4(tangents.vec3(i), tangents.at(i, 3) < 0 ? -1 : 1);
    if (uvs.data) vertex.uv = {uvs.at(i, 0), uvs.at(i, 1)};
    const bool is_sound = is_within_limits(vertex.position) && is_within_limits(vertex.normal) &&
                          is_within_limits(vertex.tangent) && is_within_limits(vertex.uv);
    if (!is_sound) file.refuse(place / "attributes", fmt::format("must be finite and at most {}", kMaxCoordinate));
    has_tangents = has_tangents && glm::length(glm::vec3(vertex.tangent)) > 0;
    mesh.vertices.push_back(vertex);
  }
  read_indices(file, place, primitive, mesh);
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
  const bool is_seen_from_behind =
      primitive.material >= 0 &&
      file.model()
          .materials[file.index(place / "material", primitive.material, file.model().materials.size())]
          .doubleSided;
  if (is_seen_from_behind) add_back_faces(mesh);
  return mesh;
}

}  // namespace litfog::scene
