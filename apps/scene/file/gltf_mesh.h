// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "scene/file/gltf_file.h"
#include "scene/file/gltf_material.h"
#include "scene/file/gltf_pose.h"
#include "scene/mesh.h"

namespace litfog::scene {

/// Counts triangles and vertices up to a scene's limits (kMaxTriangles, kMaxVertices).
class MeshBudget {
 public:
  /// primitive  what is counted
  /// throws     InputError at the primitive that exceeds a limit
  void take(const JsonValue& primitive, std::size_t triangles, std::size_t vertices);

 private:
  std::size_t triangles_ = 0;
  std::size_t vertices_ = 0;
};

/// Whether a primitive is of points or lines, which have no surface.
bool is_without_surface(const JsonValue& primitive);

/// Reads a primitive's triangles in their pose: normals made unit, flat if not given; tangents computed if not given;
/// the backs of faces, too, if its material is double-sided; details if it has colours or its pictures differ in their
/// coordinates.
///
/// pose    with a skin, the mesh is in world space
/// budget  counts the mesh before its memory is allocated
/// throws  InputError
Mesh read_gltf_primitive(const GltfFile& file, const JsonValue& primitive, const GltfMaterial& material,
                         const GltfPose& pose, MeshBudget& budget);

}  // namespace litfog::scene
