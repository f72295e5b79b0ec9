// SPDX-License-Identifier: Apache-2.0
#include "render/scene_lights.h"

#include "scene/light_frame.h"

namespace litfog::render {
namespace {

FogLight packed(const PlacedLight& light, double extent, const scene::CookieUse* cookie) {
  FogLight packed = pack_fog_light(light, {.intensity = 0, .peak_range = 0, .extent = extent, .status = {}});
  if (cookie) {
    const glm::dvec3 up = glm::transpose(scene::cookie_from_world(light.direction, cookie->roll))[1];
    packed.axis_profile.w = 3;
    packed.cone = glm::vec4(float(cookie->cookie), glm::vec3(up));
  }
  return packed;
}

}  // namespace

SceneLights::SceneLights(const scene::Scene& scene) {
  std::vector<const scene::CookieUse*> carried_cookies;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const PlacedLight& light = scene.lights[i];
    const auto use = scene.cookie_uses.find(i);
    const scene::CookieUse* const cookie = use == scene.cookie_uses.end() ? nullptr : &use->second;
    const double reach = litfog::compute_extent(light.light.attenuation, light.light.threshold);
    if (light.carried) {
      carried_.push_back(light);
      carried_cookies.push_back(cookie);
      carried_extents_.push_back(reach);
    } else if (reach > 0) {
      local_.push_back(light);
      cookies_.push_back(cookie);
      local_extents_.push_back(reach);
    }
  }
  cookies_.insert(cookies_.end(), carried_cookies.begin(), carried_cookies.end());
  for (std::size_t i = 0; i < size(); ++i) packed_.push_back(render::packed(light(i), extent(i), cookies_[i]));
  local_texture_ =
      std::make_unique<BufferTexture>(packed_.data(), local_.size() * sizeof(FogLight), BufferTexture::Texel::float4);
}

}  // namespace litfog::render
