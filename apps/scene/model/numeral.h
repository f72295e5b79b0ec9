// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/mesh.h"

namespace litfog::scene {

/// Adds a number in [0, 99] in block digits, 1 high and centred on the origin of the plane z = 0, facing +Z;
/// `mesh_from_numeral` scales and places it. Numbers below 10 have a leading zero only if `digits` is 2.
void add_numeral(Mesh& mesh, int number, int digits, const glm::mat4& mesh_from_numeral);

}  // namespace litfog::scene
