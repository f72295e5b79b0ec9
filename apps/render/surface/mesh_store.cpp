// SPDX-License-Identifier: Apache-2.0
#include "render/surface/mesh_store.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>

#include "litfog/gl/unsupported.h"

namespace litfog::render {
namespace {

constexpr float kCellSize = 20;  // metres: a few chunks a lamp, some thousand chunks a scene

using Cell = std::tuple<int, int, int>;

Cell cell_of(const glm::vec3& position) {
  const glm::vec3 cell = glm::floor(position / kCellSize);
  return {int(cell.x), int(cell.y), int(cell.z)};
}

template <typename Element>
void fill(GLenum target, const gl::BufferName& buffer, const std::vector<Element>& elements) {
  const std::size_t bytes = elements.size() * sizeof(Element);
  if (bytes >= std::size_t{1} << 31) {
    throw gl::Unsupported("the scene's triangles need " + std::to_string(bytes) +
                          " bytes in one buffer, which must be less than 2^31");
  }
  glBindBuffer(target, buffer.id());
  glBufferData(target, GLsizeiptr(bytes), elements.data(), GL_STATIC_DRAW);
}

/// Draws a run of the bound GL_ELEMENT_ARRAY_BUFFER.
void draw_triangles(std::size_t first, std::size_t count) {
  glDrawElements(GL_TRIANGLES, GLsizei(count), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

/// Sets an attribute to a struct's float member in the bound GL_ARRAY_BUFFER.
template <typename Struct>
void set_attribute(GLuint location, GLint components, std::size_t offset) {
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, sizeof(Struct),
                        reinterpret_cast<const void*>(offset));
}

/// The details of all vertices in the order of cut_into_chunks(); empty if no mesh has any.
std::vector<scene::VertexDetail> details_of(const std::vector<scene::Model>& models) {
  std::vector<scene::VertexDetail> details;
  std::size_t vertices = 0;
  for (const scene::Model& model : models) {
    for (const scene::Part& part : model) {
      details.resize(part.mesh.details.empty() ? details.size() : vertices);
      details.insert(details.end(), part.mesh.details.begin(), part.mesh.details.end());
      vertices += part.mesh.vertices.size();
    }
  }
  return details;
}

/// corners  three indices
glm::vec3 middle_of(const std::uint32_t* corners, const std::vector<scene::Vertex>& vertices) {
  return (vertices[corners[0]].position + vertices[corners[1]].position + vertices[corners[2]].position) / 3.0f;
}

void keep_triangles(Chunk& chunk, const std::vector<scene::Vertex>& vertices,
                    const std::vector<std::uint32_t>& indices) {
  for (std::size_t i = chunk.first_index; i < chunk.first_index + std::size_t(chunk.index_count); i += 3) {
    chunk.triangles.push_back({middle_of(&indices[i], vertices), {indices[i], indices[i + 1], indices[i + 2]}});
  }
}

}  // namespace

std::vector<Chunk> cut_into_chunks(const scene::Model& model, std::vector<scene::Vertex>& vertices,
                                   std::vector<std::uint32_t>& indices) {
  std::vector<Chunk> chunks;
  for (const scene::Part& part : model) {
    const scene::Mesh& mesh = part.mesh;
    const auto base = std::uint32_t(vertices.size());
    vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    const scene::Bounds whole = scene::bounds(mesh);
    const bool is_large = glm::distance(whole.low, whole.high) > 2 * kCellSize;
    std::map<Cell, std::vector<std::uint32_t>> cells;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      const std::uint32_t* triangle = &mesh.indices[i];
      auto& cell = cells[is_large ? cell_of(middle_of(triangle, mesh.vertices)) : Cell{}];
      cell.insert(cell.end(), triangle, triangle + 3);
    }
    for (const auto& [cell, members] : cells) {
      Chunk chunk{part.material,
                  {mesh.vertices[members.front()].position, mesh.vertices[members.front()].position},
                  indices.size(),
                  int(members.size()),
                  !mesh.details.empty()};
      for (const std::uint32_t index : members) {
        chunk.bounds.low = glm::min(chunk.bounds.low, mesh.vertices[index].position);
        chunk.bounds.high = glm::max(chunk.bounds.high, mesh.vertices[index].position);
        indices.push_back(base + index);
      }
      chunks.push_back(std::move(chunk));
    }
  }
  return chunks;
}

void set_vertex_attributes() {
  set_attribute<scene::Vertex>(0, 3, offsetof(scene::Vertex, position));
  set_attribute<scene::Vertex>(1, 3, offsetof(scene::Vertex, normal));
  set_attribute<scene::Vertex>(2, 4, offsetof(scene::Vertex, tangent));
  set_attribute<scene::Vertex>(3, 2, offsetof(scene::Vertex, uv));
}

MeshStore::MeshStore(const std::vector<scene::Model>& models,
                     const std::function<bool(const std::string&)>& is_sorted) {
  std::vector<scene::Vertex> vertices;
  std::vector<std::uint32_t> indices;
  for (const scene::Model& model : models) {
    for (Chunk& chunk : chunks_.emplace_back(cut_into_chunks(model, vertices, indices))) {
      if (is_sorted(chunk.material)) keep_triangles(chunk, vertices, indices);
    }
  }
  index_count_ = indices.size();
  indices.resize(2 * index_count_);
  for (std::size_t i = 0; i < index_count_; i += 3) {
    std::copy_n(indices.begin() + std::ptrdiff_t(i), 3, indices.end() - std::ptrdiff_t(i) - 3);
  }
  glBindVertexArray(vertex_array_.id());
  fill(GL_ARRAY_BUFFER, vertices_, vertices);
  fill(GL_ELEMENT_ARRAY_BUFFER, indices_, indices);
  set_vertex_attributes();
  std::vector<scene::VertexDetail> details = details_of(models);
  if (details.empty()) return;
  details.resize(vertices.size());
  fill(GL_ARRAY_BUFFER, details_, details);
  set_attribute<scene::VertexDetail>(4, 4, offsetof(scene::VertexDetail, color));
  set_attribute<scene::VertexDetail>(5, 4, offsetof(scene::VertexDetail, normal_uv));
}

void MeshStore::bind() const {
  glBindVertexArray(vertex_array_.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  glVertexAttrib4f(4, 1, 1, 1, 1);  // the colour of vertices without details
}

void MeshStore::bind_sorted(const std::vector<std::uint32_t>& indices) const {
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, sorted_indices_.id());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(indices[0])), indices.data(),
               GL_STREAM_DRAW);
}

void MeshStore::draw_sorted(std::size_t first, std::size_t count) const { draw_triangles(first, count); }

void MeshStore::draw(std::size_t first, std::size_t count, TriangleOrder order) const {
  draw_triangles(order == TriangleOrder::stored ? first : 2 * index_count_ - first - count, count);
}

}  // namespace litfog::render
