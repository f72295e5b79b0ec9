// SPDX-License-Identifier: Apache-2.0
#include <future>
#include <set>
#include <utility>

#include "scene/paint/material_catalogue.h"

namespace litfog::scene {

std::vector<Material> make_materials(std::span<const std::string> names) {
  std::vector<std::future<Material>> painted;  // without a free thread a material is painted by get()
  for (const std::string& name : names) {
    // An lvalue, which is copied: libstdc++ would move it into a thread that does not start.
    const auto paint = [name] { return make_material(name); };
    painted.push_back(std::async(paint));
  }
  std::vector<Material> materials;
  for (std::future<Material>& material : painted) materials.push_back(material.get());
  return materials;
}

void add_materials(Scene& scene) {
  std::set<std::string> missing;
  for (const Model& model : scene.models) {
    for (const Part& part : model) missing.insert(part.material);
  }
  for (const Material& own : scene.materials) missing.erase(own.name);
  for (Material& made : make_materials(std::vector(missing.begin(), missing.end()))) {
    scene.materials.push_back(std::move(made));
  }
}

}  // namespace litfog::scene
