// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "model/float_limit.h"
#include "scene/file/gltf_compression.h"
#include "scene/file/gltf_value.h"
#include "scene/scene.h"

namespace litfog::scene {
namespace {

// A primitive's "mode".
constexpr std::size_t kTriangles = 4;
constexpr std::size_t kTriangleFan = 6;

/// Reads three indices per triangle (glTF 2.0, 3.7.2.1) from the given ones, or else from the vertices in their order.
void read_indices(const JsonValue& primitive, const GltfNumbers& given, std::size_t count, std::size_t mode,
                  Mesh& mesh) {
  const auto add = [&](std::size_t i) {
    const double vertex = given.data ? given.at(i, 0) : double(i);
    if (!(vertex < double(mesh.vertices.size()))) {
      primitive.member("indices").fail("must be those of given vertices");
    }
    mesh.indices.push_back(std::uint32_t(vertex));
  };
  if (mode == kTriangles) {
    for (std::size_t i = 0; i < count; ++i) add(i);
    return;
  }
  for (std::size_t i = 0; i + 2 < count; ++i) {
    using Corners = std::array<std::size_t, 3>;
    const Corners strip = i % 2 == 0 ? Corners{i, i + 1, i + 2} : Corners{i, i + 2, i + 1};
    for (const std::size_t corner : mode == kTriangleFan ? Corners{i + 1, i + 2, 0} : strip) add(corner);
  }
}

/// Gives each triangle three vertices of its own, with its normal (glTF 2.0, 3.7.2.1: flat normals if none are given).
void flatten(Mesh& mesh) {
  std::vector<Vertex> vertices;
  std::vector<VertexDetail> details;
  for (const std::uint32_t vertex : mesh.indices) {
    vertices.push_back(mesh.vertices[vertex]);
    if (!mesh.details.empty()) details.push_back(mesh.details[vertex]);
  }
  for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
    const glm::vec3 normal =
        glm::cross(vertices[i + 1].position - vertices[i].position, vertices[i + 2].position - vertices[i].position);
    for (std::size_t corner = i; corner < i + 3; ++corner) vertices[corner].normal = normal;
  }
  mesh.vertices = std::move(vertices);
  mesh.details = std::move(details);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) mesh.indices[i] = std::uint32_t(i);
}

template <glm::length_t N>
bool is_within_limits(const glm::vec<N, float>& v) {
  for (glm::length_t i = 0; i < N; ++i) {
    if (!is_within(double(v[i]), -kMaxCoordinate, kMaxCoordinate)) return false;
  }
  return true;
}

/// A primitive's vertex attributes and indices; data are null if it lacks them.
struct Attributes {
  GltfNumbers positions, normals, tangents, base_uvs, normal_uvs, emission_uvs, colors, indices;
  std::optional<GltfPosing> posing;  // always
};

Attributes read_attributes(const GltfFile& file, const JsonValue& primitive, const GltfMaterial& material,
                           const GltfPose& pose) {
  using enum GltfComponent;
  const JsonValue given = primitive.member("attributes");
  std::optional<GltfDraco> draco;
  if (const auto compression = extension_of(primitive, "KHR_draco_mesh_compression")) draco.emplace(file, *compression);
  const auto read = [&](const std::string& name, const JsonValue& index, std::initializer_list<GltfType> types,
                        std::initializer_list<GltfComponent> components) {
    const auto decoded =
        draco ? draco->attribute(name, file.format(index, types, components)) : std::optional<GltfNumbers>();
    return decoded ? *decoded : file.numbers(index, types, components);
  };
  Attributes attributes;
  // Takes all component types, also those of KHR_mesh_quantization.
  attributes.positions = read("POSITION", given.member("POSITION"), {kGltfVec3},
                              {floating, signed_byte, unsigned_byte, signed_short, unsigned_short});
  const auto attribute = [&](const std::string& name, std::initializer_list<GltfType> types,
                             std::initializer_list<GltfComponent> components) {
    const auto index = given.optional(name);
    if (!index) return GltfNumbers{};
    const GltfNumbers numbers = read(name, *index, types, components);
    if (numbers.count != attributes.positions.count) index->fail("must have as many elements as POSITION");
    return numbers;
  };
  const auto texture_coordinates = [&](std::size_t set) {
    return attribute(fmt::format("TEXCOORD_{}", set), {kGltfVec2},
                     {floating, signed_byte, unsigned_byte, signed_short, unsigned_short});
  };
  attributes.normals = attribute("NORMAL", {kGltfVec3}, {floating, signed_byte, signed_short});
  attributes.tangents = attribute("TANGENT", {kGltfVec4}, {floating, signed_byte, signed_short});
  attributes.base_uvs = texture_coordinates(material.base.set);
  attributes.normal_uvs = texture_coordinates(material.normal.set);
  attributes.emission_uvs = texture_coordinates(material.emission.set);
  attributes.colors = attribute("COLOR_0", {kGltfVec3, kGltfVec4}, {floating, unsigned_byte, unsigned_short});
  attributes.posing.emplace(file, primitive, pose, attribute, attributes.positions.count);
  if (const auto index = primitive.optional("indices")) {
    attributes.indices =
        draco ? draco->indices() : file.numbers(*index, {kGltfScalar}, {unsigned_byte, unsigned_short, unsigned_int});
  }
  return attributes;
}

/// Vertices without a normal point up.
void read_vertices(const JsonValue& primitive, const Attributes& given, const GltfMaterial& material, Mesh& mesh) {
  const bool has_details = given.colors.data || material.normal != material.base || material.emission != material.base;
  for (std::size_t i = 0; i < given.positions.count; ++i) {
    const auto uv = [i](const GltfNumbers& uvs, const GltfCoordinates& coordinates) {
      return uvs.data ? coordinates.transform * glm::vec3(uvs.vec2(i), 1) : glm::vec2(0);
    };
    Vertex vertex{given.positions.vec3(i), glm::vec3(0, 1, 0), glm::vec4(0), uv(given.base_uvs, material.base)};
    VertexDetail detail{.normal_uv = uv(given.normal_uvs, material.normal),
                        .emission_uv = uv(given.emission_uvs, material.emission)};
    if (given.normals.data) vertex.normal = given.normals.vec3(i);
    if (given.tangents.data) {
      vertex.tangent = glm::vec4(given.tangents.vec3(i), given.tangents.at(i, 3) < 0 ? -1 : 1);
    }
    given.posing->apply(i, vertex);
    if (given.colors.data) {
      detail.color = glm::vec4(given.colors.vec3(i), given.colors.components == 4 ? given.colors.at(i, 3) : 1);
    }
    const bool is_sound = is_within_limits(vertex.position) && is_within_limits(vertex.normal) &&
                          is_within_limits(vertex.tangent) && is_within_limits(vertex.uv) &&
                          is_within_limits(detail.normal_uv) && is_within_limits(detail.emission_uv) &&
                          is_within_limits(detail.color);
    if (!is_sound) primitive.member("attributes").fail(fmt::format("must be finite and at most {}", kMaxCoordinate));
    detail.color = glm::clamp(detail.color, 0.0f, 1.0f);  // glTF 2.0, 3.7.2.1
    mesh.vertices.push_back(vertex);
    if (has_details) mesh.details.push_back(detail);
  }
}

/// Adds tangents by the normal map's coordinates.
void give_tangents(Mesh& mesh) {
  const auto swap_uvs = [&mesh] {
    for (std::size_t i = 0; i < mesh.details.size(); ++i) std::swap(mesh.vertices[i].uv, mesh.details[i].normal_uv);
  };
  swap_uvs();
  compute_tangents(mesh);
  swap_uvs();
  // compute_tangents() takes v along the bitangent; glTF's v runs down a picture whose normals have +Y up.
  for (Vertex& vertex : mesh.vertices) vertex.tangent.w = -vertex.tangent.w;
}

}  // namespace

void MeshBudget::take(const JsonValue& primitive, std::size_t triangles, std::size_t vertices) {
  triangles_ += triangles;
  vertices_ += vertices;
  if (triangles_ > kMaxTriangles || vertices_ > kMaxVertices) {
    primitive.fail(fmt::format("triangles must be at most {} in all, vertices {}", kMaxTriangles, kMaxVertices));
  }
}

bool is_without_surface(const JsonValue& primitive) {
  const auto mode = primitive.optional("mode");
  if (!mode) return false;
  if (whole_number(*mode) > kTriangleFan) mode->fail("must be at most 6");
  return whole_number(*mode) < kTriangles;
}

Mesh read_gltf_primitive(const GltfFile& file, const JsonValue& primitive, const GltfMaterial& material,
                         const GltfPose& pose, MeshBudget& budget) {
  const std::size_t mode = whole_number_or(primitive, "mode", kTriangles);
  const Attributes given = read_attributes(file, primitive, material, pose);
  const std::size_t index_count = given.indices.data ? given.indices.count : given.positions.count;
  if (mode == kTriangles ? index_count % 3 != 0 : index_count < 3) {
    const auto index = primitive.optional("indices");
    (index ? *index : primitive).fail(primitive.path_of("indices"), "", "must be three a triangle");
  }
  const std::size_t triangle_count = mode == kTriangles ? index_count / 3 : index_count - 2;
  const std::size_t sides = material.is_double_sided ? 2 : 1;
  const std::size_t vertex_count =
      given.normals.data ? given.positions.count : std::max(given.positions.count, 3 * triangle_count);
  budget.take(primitive, sides * triangle_count, sides * vertex_count);
  Mesh mesh;
  read_vertices(primitive, given, material, mesh);
  const bool has_tangents =
      given.normals.data && given.tangents.data && given.normal_uvs.data &&
      std::ranges::all_of(mesh.vertices, [](const Vertex& each) { return glm::length(glm::vec3(each.tangent)) > 0; });
  read_indices(primitive, given.indices, index_count, mode, mesh);
  if (!given.normals.data) flatten(mesh);
  for (Vertex& vertex : mesh.vertices) {
    const float length = glm::length(vertex.normal);
    vertex.normal = length > 0 ? vertex.normal / length : glm::vec3(0, 1, 0);
  }
  if (!has_tangents) give_tangents(mesh);
  if (material.is_double_sided) add_back_faces(mesh);
  return mesh;
}

}  // namespace litfog::scene
