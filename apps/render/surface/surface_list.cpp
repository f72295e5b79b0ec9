// SPDX-License-Identifier: Apache-2.0
#include "render/surface/surface_list.h"

#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "litfog/gl/unsupported.h"
#include "render/gpu/data_texture.h"
#include "render/light/light_finder.h"
#include "render/light/light_selection.h"
#include "scene/srgb.h"

namespace litfog::render {
namespace {

constexpr std::size_t kMaxListed = 1 << 25;            // lights in all surfaces' lists: 128 MiB
constexpr std::size_t kMaxListedBeyondEnds = 1 << 22;  // the same, if a shorter reach is left

scene::Bounds around(const std::vector<scene::Bounds>& boxes) {
  scene::Bounds whole = boxes.front();
  for (const scene::Bounds& box : boxes) whole = united(whole, box);
  return whole;
}

/// A scene's textures on the GPU, each uploaded once.
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

const std::string& material_name(const SurfaceMaterial& material) { return material.material.name; }

/// The largest component of a material's base texture, and its largest gloss. Mipmaps and filters only average texels.
struct Largest {
  double albedo;
  double gloss;
};
Largest largest_of(const scene::Texels& texels) {
  std::uint8_t albedo = 0;
  std::uint8_t gloss = 0;
  const std::vector<std::uint8_t>& rgba = texels.rgba;
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    albedo = std::max({albedo, rgba[i], rgba[i + 1], rgba[i + 2]});
    gloss = std::max(gloss, rgba[i + 3]);
  }
  return {double(scene::linear_from_srgb(float(albedo) / 255)), gloss / 255.0};
}
Largest largest_of(const scene::Material& material) {
  if (material.plain_albedo) return {largest_component(*material.plain_albedo), 1};
  const Largest most = largest_of(*material.albedo);
  return {most.albedo, material.least_coverage ? 1 : most.gloss};
}

bool is_flat(const scene::Texels& normals) {
  const std::vector<std::uint8_t>& rgba = normals.rgba;
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    // With an alpha of 255, 127.5 would be flat (scene::Material::normal).
    if (rgba[i] != 128 || rgba[i + 1] != 128 || rgba[i + 2] <= 128 || rgba[i + 3] == 255) return false;
  }
  return true;
}

/// The largest component of a material's emission.
double most_emitted(const scene::Material& material, const Largest& most) {
  const double emissive = largest_component(material.emissive);
  if (material.is_unlit) return emissive * most.albedo;
  return material.emission ? emissive * largest_of(*material.emission).albedo : emissive;
}

/// Uploads a scene's materials, sorted by name.
///
/// earlier  kept where names agree
std::vector<SurfaceMaterial> upload(std::vector<scene::Material> materials, bool has_normal_maps,
                                    std::vector<SurfaceMaterial> earlier = {}) {
  std::ranges::sort(materials, {}, &scene::Material::name);
  TextureStore textures;
  std::vector<SurfaceMaterial> uploaded;
  for (scene::Material& material : materials) {
    const auto known = std::ranges::find(earlier, material.name, material_name);
    if (known != earlier.end()) {
      uploaded.push_back(std::move(*known));
      uploaded.back().number = float(uploaded.size() - 1);
      continue;
    }
    const Largest most = largest_of(material);
    const double diffuse = material.is_unlit ? 0 : most.albedo;
    const double reflectance = diffuse + most.gloss * largest_component(material.specular);
    const double ambient = std::max(diffuse, material.ambient ? largest_component(*material.ambient) : 0.0);
    const double emitted = most_emitted(material, most);
    const bool has_flat_normals = is_flat(*material.normal);
    auto albedo = material.plain_albedo ? std::make_shared<const Texture>(glm::vec4(*material.plain_albedo, 1.0f))
                                        : textures.upload(material.albedo, Texture::Encoding::srgb);
    std::shared_ptr<const Texture> normal;
    if (has_normal_maps) normal = textures.upload(material.normal, Texture::Encoding::linear);
    std::shared_ptr<const Texture> emission;
    if (material.emission) emission = textures.upload(material.emission, Texture::Encoding::srgb);
    std::shared_ptr<const Texture> second;
    if (material.second) second = textures.upload(material.second, Texture::Encoding::srgb);
    material.albedo.reset();
    material.normal.reset();
    material.emission.reset();
    material.second.reset();
    uploaded.push_back({std::move(material), float(uploaded.size()), reflectance, ambient, emitted, has_flat_normals,
                        std::move(albedo), std::move(normal), std::move(emission), std::move(second)});
  }
  return uploaded;
}

}  // namespace

SurfaceList::SurfaceList(const scene::Scene& scene, const SceneLights& lights, Skipping skipping, bool has_normal_maps)
    : has_normal_maps_(has_normal_maps),
      materials_(upload(scene.materials, has_normal_maps)),
      meshes_(upload_meshes(scene)) {
  set_lights(scene, lights, skipping);
}

void SurfaceList::set_objects(const scene::Scene& scene) {
  surfaces_.clear();  // they point into what is replaced below
  materials_ = upload(scene.materials, has_normal_maps_, std::move(materials_));
  meshes_ = upload_meshes(scene);
}

MeshStore SurfaceList::upload_meshes(const scene::Scene& scene) const {
  return {scene.models, [this](const std::string& name) { return material(name).is_pane(); }};
}

void SurfaceList::set_lights(const scene::Scene& scene, const SceneLights& lights, Skipping skipping) {
  // A frame's light list also holds the carried lights, and twice as many texels as there are points.
  const std::size_t most = std::min(kMaxListed, BufferTexture::max_texels());
  const std::size_t room = most - std::min(most, 2 * lights.size());
  const bool has_ends = !lights.light_surfaces_beyond_end();
  for (const double reach : kReaches) {
    if (has_ends && reach != 1) continue;
    reach_ = reach;
    if (list_lights(scene, lights, skipping, reach == 1 ? room : std::min(room, kMaxListedBeyondEnds))) return;
  }
  throw gl::Unsupported("the scene's surfaces are reached by too many lights: at most " + std::to_string(most) +
                        " can be listed for all of them together");
}

bool SurfaceList::list_lights(const scene::Scene& scene, const SceneLights& lights, Skipping skipping,
                              std::size_t most) {
  surfaces_.clear();
  list_.clear();
  std::vector<double> ranges;
  for (const double extent : lights.extents()) ranges.push_back(range_of(extent));
  const LightFinder finder(lights.lights().first(lights.local_count()), std::span(ranges).first(lights.local_count()));
  if (skipping == Skipping::off) {
    list_.resize(lights.size());
    std::iota(list_.begin(), list_.end(), 0);
  }
  for (const scene::Instance& instance : scene.instances) {
    const auto& chunks = meshes_.chunks(instance.model);
    const glm::mat4 world_from_model = placed_relative_to(lights.origin(), instance);
    std::vector<scene::Bounds> boxes;
    for (const Chunk& chunk : chunks) boxes.push_back(transformed(chunk.bounds, world_from_model));
    std::vector<std::int32_t> near;  // lights that can reach the instance
    const bool is_listed = skipping == Skipping::on && !instance.is_beyond_lights;
    if (is_listed && !boxes.empty()) near = finder.reaching(around(boxes));
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      Surface surface{.material = &material(chunks[i].material),
                      .chunk = &chunks[i],
                      .world_from_model = world_from_model,
                      .bounds = boxes[i],
                      .is_fog_lit = !instance.is_beyond_lights,
                      .list_first = 0,
                      .list_count = instance.is_beyond_lights ? 0 : int(lights.size())};
      if (is_listed) {
        const LightSelection selection = select_lights(lights, ranges, finder.reaching(boxes[i], near), boxes[i]);
        surface.is_fog_lit = selection.is_fog_lit;
        surface.list_first = int(list_.size());
        surface.list_count = int(selection.surface.size());
        list_.insert(list_.end(), selection.surface.begin(), selection.surface.end());
        if (list_.size() > most) return false;
      }
      surfaces_.push_back(surface);
    }
  }
  // By name, not by address: the order decides which of two coplanar surfaces is visible.
  std::ranges::stable_sort(surfaces_, {}, [](const Surface& surface) { return surface.material->material.name; });
  return true;
}

const SurfaceMaterial& SurfaceList::material(const std::string& name) const {
  const auto found = std::ranges::lower_bound(materials_, name, {}, material_name);
  if (found == materials_.end() || material_name(*found) != name)
    throw std::invalid_argument("material = " + name + ": must be one of the scene's");
  return *found;
}

std::vector<scene::Material> SurfaceList::materials() const {
  std::vector<scene::Material> materials;
  for (const SurfaceMaterial& material : materials_) materials.push_back(material.material);
  return materials;
}

}  // namespace litfog::render
