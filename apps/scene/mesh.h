// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace litfog::scene {

/// Metres, right-handed, Y up. The bitangent, the direction in which v grows, is cross(normal, tangent.xyz) *
/// tangent.w.
struct Vertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec4 tangent;  ///< xyz: the direction in which u grows; w: +1 or -1
  glm::vec2 uv;       ///< metres of surface; one tile covers Material::size_m
};

/// Vertex data that only some meshes have.
struct VertexDetail {
  glm::vec4 color{1};       ///< linear RGB and coverage, [0, 1]; multiplies the base texture's
  glm::vec2 normal_uv{};    ///< Vertex::uv of the normal map
  glm::vec2 emission_uv{};  ///< Vertex::uv of Material::emission
};

/// Indexed triangles, front faces counter-clockwise. Plain data: no GL.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<VertexDetail> details = {};  ///< one per vertex; empty: white, all pictures at Vertex::uv
};

/// The detail of one vertex.
VertexDetail detail_of(const Mesh& mesh, std::size_t vertex);

/// A mesh and its material's name (Scene::materials).
struct Part {
  std::string material;
  Mesh mesh;
};

/// An object for a scene: one part per material. The origin is on the ground at the centre, and fronts face -Z, unless
/// the builder states otherwise. A deque, so that a reference from part() survives later parts.
using Model = std::deque<Part>;

struct Bounds {
  glm::vec3 low;
  glm::vec3 high;
};

/// The axis-aligned box around the vertices; low > high if there are none.
Bounds bounds(const Mesh& mesh);
Bounds bounds(const Model& model);

/// The box around two boxes.
Bounds united(const Bounds& a, const Bounds& b);

/// The box around a transformed box.
Bounds transformed(const Bounds& box, const glm::mat4& to_from_box);

/// Metres from a point to the nearest and to the farthest point of a box.
double nearest_distance(const glm::dvec3& point, const Bounds& box);
double farthest_distance(const glm::dvec3& point, const Bounds& box);

std::size_t triangle_count(const Model& model);

/// Adds a transformed copy. A mirroring transform keeps front faces in front.
void append(Mesh& whole, const Mesh& piece, const glm::mat4& whole_from_piece = glm::mat4(1.0f));
void append(Mesh& whole, const Mesh& piece, const glm::dmat4& whole_from_piece);
void append(Model& whole, const Model& piece, const glm::mat4& whole_from_piece = glm::mat4(1.0f));

/// The mesh of a model's part with that material, added if there is none.
Mesh& part(Model& model, std::string_view material);

/// Rotation by yaw about +Y (radians; counter-clockwise seen from above), then translation.
glm::mat4 place(const glm::vec3& position, float yaw = 0.0f);

/// Computes the tangents from positions, normals and uv, which must be final. If uv is constant, any perpendicular of
/// the normal.
void compute_tangents(Mesh& mesh);

/// Adds the back of every face: leaves and blades are seen from both sides, and back faces are culled.
void add_back_faces(Mesh& mesh);

}  // namespace litfog::scene
