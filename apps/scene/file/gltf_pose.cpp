// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_pose.h"

#include <fmt/format.h>

#include "scene/file/gltf_value.h"

namespace litfog::scene {

using enum GltfComponent;

GltfPosing::GltfPosing(const GltfFile& file, const JsonValue& primitive, const GltfPose& pose,
                       const Attribute& attribute, std::size_t vertex_count)
    : primitive_(primitive), pose_(pose) {
  const std::vector<JsonValue> targets = items_of(primitive, "targets");
  for (std::size_t i = 0; i < targets.size() && i < pose.weights.size(); ++i) {
    if (pose.weights[i] == 0) continue;
    const auto displacements = [&](const char* name) {
      const auto index = targets[i].optional(name);
      if (!index) return GltfNumbers{};
      // Takes all component types, also those of KHR_mesh_quantization.
      const GltfNumbers given = file.numbers(*index, {kGltfVec3}, {floating, signed_byte, signed_short});
      if (given.count != vertex_count) index->fail("must have as many elements as POSITION");
      return given;
    };
    targets_.push_back({pose.weights[i], displacements("POSITION"), displacements("NORMAL"), displacements("TANGENT")});
  }
  for (std::size_t set = 0; !pose.world_from_mesh.empty(); ++set) {
    const GltfNumbers joints = attribute(fmt::format("JOINTS_{}", set), {kGltfVec4}, {unsigned_byte, unsigned_short});
    if (!joints.data && set > 0) break;
    if (!joints.data) primitive.member("attributes").member("JOINTS_0");  // fails
    const GltfNumbers weights =
        attribute(fmt::format("WEIGHTS_{}", set), {kGltfVec4}, {floating, unsigned_byte, unsigned_short});
    if (!weights.data) primitive.member("attributes").member(fmt::format("WEIGHTS_{}", set));  // fails
    influences_.push_back({joints, weights});
  }
}

glm::dmat4 GltfPosing::world_from_mesh(std::size_t vertex) const {
  glm::dmat4 sum(0.0);
  double total = 0;
  for (const Influences& influences : influences_) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double weight = influences.weights.at(vertex, i);
      if (weight == 0) continue;
      const auto joint = std::size_t(influences.joints.at(vertex, i));
      if (joint >= pose_.world_from_mesh.size()) primitive_.fail("must have joints that its skin has");
      sum += weight * pose_.world_from_mesh[joint];
      total += weight;
    }
  }
  return total > 0 ? sum / total : pose_.world_from_mesh.front();
}

void GltfPosing::apply(std::size_t index, Vertex& vertex) const {
  for (const Target& target : targets_) {
    const auto displace = [&](auto& vector, const GltfNumbers& by) {
      if (by.data) vector += glm::vec3(target.weight * glm::dvec3(by.vec3(index)));
    };
    displace(vertex.position, target.positions);
    displace(vertex.normal, target.normals);
    glm::vec3 tangent(vertex.tangent);
    displace(tangent, target.tangents);
    vertex.tangent = glm::vec4(tangent, vertex.tangent.w);
  }
  if (pose_.world_from_mesh.empty()) return;
  const glm::dmat4 matrix = world_from_mesh(index);
  const glm::dmat3 linear(matrix);
  vertex.position = glm::dvec3(matrix * glm::dvec4(vertex.position, 1));
  // The cofactors are the inverse transpose times the determinant, which may be 0 between joints.
  const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                             glm::cross(linear[0], linear[1]));
  const double side = glm::determinant(linear) < 0 ? -1 : 1;
  const auto unit = [](const glm::dvec3& vector) {
    const double length = glm::length(vector);
    return length > 0 ? vector / length : vector;
  };
  vertex.normal = unit(side * (cofactors * glm::dvec3(vertex.normal)));
  vertex.tangent = glm::vec4(unit(linear * glm::dvec3(vertex.tangent)), vertex.tangent.w);
}

}  // namespace litfog::scene
