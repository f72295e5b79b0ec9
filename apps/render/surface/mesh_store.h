// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "litfog/gl/gl_name.h"
#include "scene/mesh.h"

namespace litfog::render {

/// A triangle of a chunk that is sorted in each frame.
struct SortedTriangle {
  glm::vec3 middle;  ///< model space
  std::array<std::uint32_t, 3> indices;
};

/// A run of neighbouring triangles of one material, small enough to be culled and to have a short light list.
struct Chunk {
  std::string material;
  scene::Bounds bounds;  ///< model space
  std::size_t first_index;
  int index_count;
  bool has_details;                            ///< its vertices have scene::VertexDetail
  std::vector<SortedTriangle> triangles = {};  ///< empty unless the material is sorted
};

/// Cuts a model's parts into chunks: large parts by cells. Appends the vertices and the indices to draw.
std::vector<Chunk> cut_into_chunks(const scene::Model& model, std::vector<scene::Vertex>& vertices,
                                   std::vector<std::uint32_t>& indices);

/// Sets the current vertex array's attributes for a bound GL_ARRAY_BUFFER of scene::Vertex: location 0 position, 1
/// normal, 2 tangent, 3 uv.
void set_vertex_attributes();

/// The order in which triangles are drawn.
enum class TriangleOrder { stored, reversed };

/// All models of a scene in one vertex array on the GPU. If any model has details, the array has two more attributes:
/// location 4 colour, 5 uv of normal map and emission.
class MeshStore {
 public:
  /// throws     gl::Unsupported where vertices or indices would take 2^31 bytes or more, too many for drivers
  /// is_sorted  whether the chunks of a material keep their triangles
  MeshStore(const std::vector<scene::Model>& models, const std::function<bool(const std::string&)>& is_sorted);

  /// The chunks of a model, by its index in the constructor's vector.
  const std::vector<Chunk>& chunks(std::size_t model) const { return chunks_[model]; }
  /// Makes the vertex array current, laid out by set_vertex_attributes().
  void bind() const;
  /// Draws a range of the chunks' indices.
  void draw(std::size_t first, std::size_t count, TriangleOrder order) const;
  /// Binds these indices instead of the chunks', until the next bind().
  void bind_sorted(const std::vector<std::uint32_t>& indices) const;
  /// Draws a range of the indices of bind_sorted().
  void draw_sorted(std::size_t first, std::size_t count) const;

 private:
  std::vector<std::vector<Chunk>> chunks_;
  std::size_t index_count_;  // in stored order; followed by as many in reverse order of triangles
  gl::VertexArrayName vertex_array_;
  gl::BufferName vertices_;
  gl::BufferName details_;  // empty where no model has any
  gl::BufferName indices_;
  gl::BufferName sorted_indices_;  // replaced in each frame
};

}  // namespace litfog::render
