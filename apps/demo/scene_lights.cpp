// SPDX-License-Identifier: Apache-2.0
#include "scene_lights.h"

namespace litfog::demo {
namespace {

FogLight packed(const PlacedLight& light, double extent) {
  return pack_fog_light(light, {.intensity = 0, .peak_range = 0, .extent = extent, .status = {}});
}

}  // namespace

SceneLights::SceneLights(const Scene& scene) {
  for (const PlacedLight& light : scene.lights) {
    const double reach = litfog::extent(light.light.attenuation, light.light.threshold);
    if (light.carried) {
      carried_.push_back(light);
      carried_extents_.push_back(reach);
    } else if (reach > 0) {
      local_.push_back(light);
      local_extents_.push_back(reach);
    }
  }
  for (std::size_t i = 0; i < size(); ++i) packed_.push_back(demo::packed(light(i), extent(i)));
  local_texture_ =
      std::make_unique<BufferTexture>(packed_.data(), local_.size() * sizeof(FogLight), BufferTexture::Texel::float4);
}

}  // namespace litfog::demo
