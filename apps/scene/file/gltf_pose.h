// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <initializer_list>
#include <string>
#include <vector>

#include "scene/file/gltf_file.h"
#include "scene/mesh.h"

namespace litfog::scene {

/// The rest pose of a node's mesh: displaced by its morph targets, then moved by the joints of its skin.
struct GltfPose {
  std::vector<double> weights;              ///< one per morph target; missing ones are 0
  std::vector<glm::dmat4> world_from_mesh;  ///< one per joint; empty: no skin, and vertices stay in mesh space
};

/// The pose's data of one primitive (glTF 2.0, 3.7.2.2 and 3.7.3).
class GltfPosing {
 public:
  /// A vertex attribute's numbers by its name; data are null if it is not given.
  using Attribute = std::function<GltfNumbers(const std::string& name, std::initializer_list<GltfType> types,
                                              std::initializer_list<GltfComponent> components)>;

  /// pose    must outlive this object
  /// throws  InputError
  GltfPosing(const GltfFile& file, const JsonValue& primitive, const GltfPose& pose, const Attribute& attribute,
             std::size_t vertex_count);

  /// Moves a vertex. Its normal and tangent are as in the file, not yet of unit length.
  ///
  /// throws  InputError for a joint that the skin lacks
  void apply(std::size_t index, Vertex& vertex) const;

 private:
  struct Target {
    double weight;
    GltfNumbers positions;
    GltfNumbers normals;
    GltfNumbers tangents;
  };
  struct Influences {  // of four joints on each vertex
    GltfNumbers joints;
    GltfNumbers weights;
  };

  glm::dmat4 world_from_mesh(std::size_t vertex) const;

  JsonValue primitive_;
  const GltfPose& pose_;
  std::vector<Target> targets_;
  std::vector<Influences> influences_;
};

}  // namespace litfog::scene
