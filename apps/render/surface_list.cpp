// SPDX-License-Identifier: Apache-2.0
#include "render/surface_list.h"

#include <algorithm>
#include <future>
#include <numeric>

#include "litfog/gl/unsupported.h"

namespace litfog::render {
namespace {

constexpr std::size_t kMaxListed = 1 << 25;  // lights in all surfaces' lists: 128 MiB

scene::Bounds around(const std::vector<scene::Bounds>& boxes) {
  scene::Bounds whole = boxes.front();
  for (const scene::Bounds& box : boxes) whole = {glm::min(whole.low, box.low), glm::max(whole.high, box.high)};
  return whole;
}

}  // namespace

SurfaceList::SurfaceList(const scene::Scene& scene, std::span<const PlacedLight> local, std::span<const double> extents,
                         Skipping skipping)
    : meshes_(scene.models) {
  load_materials(scene);
  const LightFinder finder(local, extents);
  const std::size_t most = std::min(kMaxListed, BufferTexture::max_texels());
  if (skipping == Skipping::off) {  // one list for all
    list_.resize(local.size());
    std::iota(list_.begin(), list_.end(), 0);
  }
  for (const scene::Instance& instance : scene.instances) {
    const auto& chunks = meshes_.chunks(instance.model);
    std::vector<scene::Bounds> boxes;
    for (const Chunk& chunk : chunks) boxes.push_back(transformed(chunk.bounds, instance.world_from_model));
    std::vector<std::int32_t> near;  // lights that can reach the instance
    if (skipping == Skipping::on && !boxes.empty()) near = finder.reaching(around(boxes));
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      Surface surface{.material = &materials_.at(chunks[i].material),
                      .chunk = &chunks[i],
                      .world_from_model = instance.world_from_model,
                      .bounds = boxes[i],
                      .list_first = 0,
                      .list_count = int(list_.size())};
      if (skipping == Skipping::on) {
        const std::vector<std::int32_t> reaching = finder.reaching(boxes[i], near);
        surface.list_first = int(list_.size());
        surface.list_count = int(reaching.size());
        list_.insert(list_.end(), reaching.begin(), reaching.end());
        if (list_.size() > most) {
          throw gl::Unsupported("the scene's surfaces are reached by too many lights: at most " + std::to_string(most) +
                                " can be listed for all of them together");
        }
      }
      surfaces_.push_back(surface);
    }
  }
  // By name, not by address: where surfaces lie in one plane the order decides, and pictures have to come out the same.
  std::ranges::stable_sort(surfaces_, {}, [](const Surface& surface) { return surface.material->material.name; });
  list_texture_ =
      std::make_unique<BufferTexture>(list_.data(), list_.size() * sizeof(std::int32_t), BufferTexture::Texel::int1);
}

void SurfaceList::load_materials(const scene::Scene& scene) {
  std::map<std::string, std::future<scene::Material>> made;  // in parallel: each is some 10 ms of noise
  for (std::size_t model = 0; model < scene.models.size(); ++model) {
    for (const Chunk& chunk : meshes_.chunks(model)) {
      auto& material = made[chunk.material];
      if (!material.valid()) {
        const auto own = std::ranges::find(scene.materials, chunk.material, &scene::Material::name);
        material = own != scene.materials.end()
                       ? std::async(std::launch::deferred, [own] { return *own; })
                       : std::async(std::launch::async | std::launch::deferred, [name = chunk.material] { return scene::make_material(name); });
      }
    }
  }
  for (auto& [name, future] : made) {
    scene::Material material = future.get();
    Texture albedo = material.plain_albedo ? Texture(glm::vec4(*material.plain_albedo, 1.0f))
                                           : Texture(material.albedo, Texture::Encoding::srgb);
    Texture normal(material.normal, Texture::Encoding::linear);
    material.albedo = {};
    material.normal = {};
    const auto number = float(materials_.size());
    materials_.emplace(name, SurfaceMaterial{std::move(material), number, std::move(albedo), std::move(normal)});
  }
}

std::vector<scene::Material> SurfaceList::materials() const {
  std::vector<scene::Material> materials;
  for (const auto& [name, material] : materials_) materials.push_back(material.material);
  return materials;
}

}  // namespace litfog::render
