// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace litfog::scene {

/// Every material of the catalogue, sorted.
std::span<const std::string_view> material_names();

/// Paints a material, both pictures square and a power of two a side; the same name gives the same bytes.
/// throws std::invalid_argument for an unknown name
Material make_material(std::string_view name);

/// Paints several at once, in parallel.
std::vector<Material> make_materials(std::span<const std::string> names);

/// Paints the materials that a scene's parts name and that it lacks.
void add_materials(Scene& scene);

}  // namespace litfog::scene
