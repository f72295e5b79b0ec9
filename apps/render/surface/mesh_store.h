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

/// One of a chunk's, for those that are sorted in each frame.
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
  std::vector<SortedTriangle> triangles = {};  ///< of a material that is sorted
};

/// A model's parts as chunks: large parts are cut into cells. Appends their vertices, and the indices to draw.
std::vector<Chunk> cut_into_chunks(const scene::Model& model, std::vector<scene::Vertex>& vertices,
                                   std::vector<std::uint32_t>& indices);

/// Lays the current vertex array out over the bound GL_ARRAY_BUFFER of scene::Vertex: locations 0 position, 1 normal,
/// 2 tangent, 3 uv.
void set_vertex_attributes();

/// In which order triangles are drawn.
enum class TriangleOrder { stored, reversed };

/// All models of a scene in one vertex array on the GPU. Where any of them has details, so has the array: locations 4
/// color, 5 the normal map's uv and the emission's.
class MeshStore {
 public:
  /// throws     gl::Unsupported where its vertices or indices would take 2^31 bytes or more, which drivers do not hold
  /// is_sorted  whether the chunks of a material keep their triangles
  MeshStore(const std::vector<scene::Model>& models, const std::function<bool(const std::string&)>& is_sorted);

  /// Of a model, by its index in the constructor's vector.
  const std::vector<Chunk>& chunks(std::size_t model) const { return chunks_[model]; }
  /// Makes the vertex array current, laid out by set_vertex_attributes().
  void bind() const;
  /// Draws a run of the chunks' indices.
  void draw(std::size_t first, std::size_t count, TriangleOrder order) const;
  /// Takes indices in place of those of the chunks, until the next bind().
  void bind_sorted(const std::vector<std::uint32_t>& indices) const;
  /// Draws a run of those indices.
  void draw_sorted(std::size_t first, std::size_t count) const;

 private:
  std::vector<std::vector<Chunk>> chunks_;
  std::size_t index_count_;  // in stored order; as many follow with the triangles reversed
  gl::VertexArrayName vertex_array_;
  gl::BufferName vertices_;
  gl::BufferName details_;  // empty where no model has any
  gl::BufferName indices_;
  gl::BufferName sorted_indices_;  // of a frame
};

}  // namespace litfog::render
