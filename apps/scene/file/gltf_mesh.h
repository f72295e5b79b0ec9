// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/file/gltf_file.h"
#include "scene/mesh.h"

namespace litfog::scene {

/// Reads a primitive's triangles: normals made unit, flat ones where none are given; tangents computed where they are
/// not; the backs of faces where its material shows them.
///
/// place   the primitive's
/// throws  InputError
Mesh read_gltf_primitive(const GltfFile& file, const GltfPlace& place, const tinygltf::Primitive& primitive);

}  // namespace litfog::scene
