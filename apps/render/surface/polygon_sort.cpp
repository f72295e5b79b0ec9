// SPDX-License-Identifier: Apache-2.0
#include "render/surface/polygon_sort.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "render/light/light_finder.h"
#include "render/light/scene_lights.h"

namespace litfog::render {
namespace {

class Reach {
 public:
  Reach(const scene::Scene& scene, const RenderSettings& settings)
      : lights_(scene, settings),
        local_(lights_.lights().first(lights_.local_count()), lights_.extents().first(lights_.local_count())) {}

  const glm::dvec3& origin() const { return lights_.origin(); }
  bool covers(const scene::Bounds& box) const {
    const auto carried = lights_.lights().subspan(lights_.local_count());
    return std::ranges::any_of(carried, [&](const PlacedLight& light) { return can_reach(light, kFarthest, box); }) ||
           !local_.reaching(box).empty();
  }

 private:
  static constexpr double kFarthest = std::numeric_limits<double>::infinity();

  SceneLights lights_;
  LightFinder local_;
};

/// Copies triangles from one mesh to another, each vertex once.
class MeshCopy {
 public:
  void add(const scene::Mesh& mesh, std::size_t first_index) {
    for (std::size_t i = first_index; i < first_index + 3; ++i) {
      const auto [entry, is_new] = copies_.try_emplace(mesh.indices[i], std::uint32_t(copy_.vertices.size()));
      if (is_new) copy_.vertices.push_back(mesh.vertices[mesh.indices[i]]);
      copy_.indices.push_back(entry->second);
    }
  }
  scene::Mesh take() { return std::move(copy_); }

 private:
  scene::Mesh copy_;
  std::map<std::uint32_t, std::uint32_t> copies_;
};

scene::Bounds triangle_box(const scene::Mesh& mesh, std::size_t first_index, const glm::mat4& world_from_model) {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  scene::Bounds box{glm::vec3(kFar), glm::vec3(-kFar)};
  for (std::size_t i = first_index; i < first_index + 3; ++i) {
    const glm::vec3 corner(world_from_model * glm::vec4(mesh.vertices[mesh.indices[i]].position, 1));
    box = united(box, {corner, corner});
  }
  return box;
}

}  // namespace

scene::Scene sort_polygons(const scene::Scene& scene, const RenderSettings& settings) {
  const Reach reach(scene, settings);
  scene::Scene sorted = scene;
  sorted.instances.clear();
  for (const scene::Instance& instance : scene.instances) {
    const scene::Model& model = scene.models[instance.model];
    const glm::mat4 world_from_model = placed_relative_to(reach.origin(), instance);
    if (!reach.covers(transformed(bounds(model), world_from_model))) {
      sorted.instances.push_back(instance);
      sorted.instances.back().is_beyond_lights = true;
      continue;
    }
    std::array<scene::Model, 2> halves;  // [0] beyond the lights' reach, [1] within it
    for (const scene::Part& part : model) {
      std::array<MeshCopy, 2> copies;
      for (std::size_t i = 0; i < part.mesh.indices.size(); i += 3) {
        copies[reach.covers(triangle_box(part.mesh, i, world_from_model))].add(part.mesh, i);
      }
      for (std::size_t half = 0; half < 2; ++half) {
        scene::Mesh mesh = copies[half].take();
        if (!mesh.indices.empty()) halves[half].push_back({part.material, std::move(mesh)});
      }
    }
    for (std::size_t half = 0; half < 2; ++half) {
      if (halves[half].empty()) continue;
      sorted.instances.push_back({sorted.models.size(), instance.world_from_model, half == 0});
      sorted.models.push_back(std::move(halves[half]));
    }
  }
  return sorted;
}

}  // namespace litfog::render
