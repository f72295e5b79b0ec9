// SPDX-License-Identifier: Apache-2.0
#include "render/surface_list.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "litfog/gl/unsupported.h"
#include "render/light_finder.h"

namespace litfog::render {
namespace {

constexpr std::size_t kMaxListed = 1 << 25;  // lights in all surfaces' lists: 128 MiB

scene::Bounds around(const std::vector<scene::Bounds>& boxes) {
  scene::Bounds whole = boxes.front();
  for (const scene::Bounds& box : boxes) whole = {glm::min(whole.low, box.low), glm::max(whole.high, box.high)};
  return whole;
}

/// A scene's pictures on the GPU, each once.
class TextureStore {
 public:
  std::shared_ptr<const Texture> upload(const std::shared_ptr<const scene::Texels>& texels,
                                        Texture::Encoding encoding) {
    std::shared_ptr<const Texture>& texture = textures_[{texels.get(), encoding}];
    if (!texture) texture = std::make_shared<const Texture>(*texels, encoding);
    return texture;
  }

 private:
  std::map<std::pair<const scene::Texels*, Texture::Encoding>, std::shared_ptr<const Texture>> textures_;
};

/// A scene's materials on the GPU, sorted by name.
std::vector<SurfaceMaterial> upload(std::vector<scene::Material> materials) {
  std::ranges::sort(materials, {}, &scene::Material::name);
  TextureStore textures;
  std::vector<SurfaceMaterial> uploaded;
  for (scene::Material& material : materials) {
    auto albedo = material.plain_albedo ? std::make_shared<const Texture>(glm::vec4(*material.plain_albedo, 1.0f))
                                        : textures.upload(material.albedo, Texture::Encoding::srgb);
    auto normal = textures.upload(material.normal, Texture::Encoding::linear);
    material.albedo.reset();
    material.normal.reset();
    uploaded.push_back({std::move(material), float(uploaded.size()), std::move(albedo), std::move(normal)});
  }
  return uploaded;
}

}  // namespace

SurfaceList::SurfaceList(const scene::Scene& scene, const SceneLights& lights, Skipping skipping)
    : meshes_(scene.models), materials_(upload(scene.materials)), list_texture_(list_lights(scene, lights, skipping)) {}

BufferTexture SurfaceList::list_lights(const scene::Scene& scene, const SceneLights& lights, Skipping skipping) {
  const std::size_t local_count = lights.local_count();
  const std::size_t most = std::min(kMaxListed, BufferTexture::max_texels());
  list_.resize(lights.size());
  std::iota(list_.begin(), list_.end(), 0);
  // The carried ones to the front.
  std::rotate(list_.begin(), list_.begin() + std::ptrdiff_t(local_count), list_.end());
  const auto first_local = int(lights.size() - local_count);
  const LightFinder finder(lights.lights().first(local_count), lights.extents().first(local_count));
  for (const scene::Instance& instance : scene.instances) {
    const auto& chunks = meshes_.chunks(instance.model);
    std::vector<scene::Bounds> boxes;
    for (const Chunk& chunk : chunks) boxes.push_back(transformed(chunk.bounds, instance.world_from_model));
    std::vector<std::int32_t> near;  // lights that can reach the instance
    const bool is_listed = skipping == Skipping::on && !instance.is_beyond_lights;
    if (is_listed && !boxes.empty()) near = finder.reaching(around(boxes));
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      Surface surface{.material = &material(chunks[i].material),
                      .chunk = &chunks[i],
                      .world_from_model = instance.world_from_model,
                      .bounds = boxes[i],
                      .list_first = first_local,
                      .list_count = instance.is_beyond_lights ? 0 : int(local_count),
                      .is_beyond_lights = instance.is_beyond_lights};
      if (is_listed) {
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
  // By name, not by address, because the order decides which of two coplanar surfaces is visible.
  std::ranges::stable_sort(surfaces_, {}, [](const Surface& surface) { return surface.material->material.name; });
  return BufferTexture(list_.data(), list_.size() * sizeof(std::int32_t), BufferTexture::Texel::int1);
}

const SurfaceMaterial& SurfaceList::material(const std::string& name) const {
  const auto name_of = [](const SurfaceMaterial& each) -> const std::string& { return each.material.name; };
  const auto found = std::ranges::lower_bound(materials_, name, {}, name_of);
  if (found == materials_.end() || name_of(*found) != name)
    throw std::invalid_argument("material = " + name + ": must be one of the scene's");
  return *found;
}

std::vector<scene::Material> SurfaceList::materials() const {
  std::vector<scene::Material> materials;
  for (const SurfaceMaterial& material : materials_) materials.push_back(material.material);
  return materials;
}

}  // namespace litfog::render
