// SPDX-License-Identifier: Apache-2.0
#include "render/scene_lights.h"

#include <algorithm>

#include "scene/light_frame.h"

namespace litfog::render {
namespace {

constexpr double kSkipsNothing = 0;  // in 1/255: the reference that pictures are compared with has every light

void set_cookie(FogLight& packed, const PlacedLight& light, const scene::CookieUse& use) {
  const glm::dvec3 up = glm::transpose(scene::cookie_from_world(light.direction, use.roll))[1];
  packed.axis_profile.w = 3;
  packed.cone = glm::vec4(float(use.cookie), glm::vec3(up));
}

}  // namespace

double threshold_of(const Light& light, FogLighting fog_lighting) {
  if (fog_lighting == FogLighting::peak) return light.threshold;
  constexpr double kInvisible = 1 / 255.0;  // on a surface, that reflects a part of it
  return std::min(light.threshold, kInvisible / std::max({light.color.r, light.color.g, light.color.b, 1.0}));
}

SceneLights::SceneLights(const scene::Scene& scene, const RenderSettings& settings) : updater_(kSkipsNothing) {
  std::vector<FogLightHandle> handles;
  for (const bool is_carried : {false, true}) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      PlacedLight light = scene.lights[i];
      if (light.carried != is_carried) continue;
      light.light.threshold = threshold_of(light.light, settings.fog_lighting);
      const double extent = compute_extent(light.light.attenuation, light.light.threshold);
      if (!is_carried && !(extent > 0)) continue;
      const auto use = scene.cookie_uses.find(i);
      lights_.push_back(light);
      extents_.push_back(extent);
      cookies_.push_back(use == scene.cookie_uses.end() ? nullptr : &use->second);
      light.carried = is_carried && settings.path->has_lit_fog && settings.fog_lighting == FogLighting::peak;
      handles.push_back(updater_.add(light));
    }
    if (!is_carried) local_count_ = lights_.size();
  }
  updater_.set_fog(Fog{});
  entries_.assign(updater_.entries().begin(), updater_.entries().end());
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    entry_of_.push_back(updater_.entry_of(handles[i]));
    if (cookies_[i]) set_cookie(entries_[entry_of_[i]], lights_[i], *cookies_[i]);
  }
}

std::span<const EntryRange> SceneLights::set_fog(const Fog& fog) {
  const std::span<const EntryRange> changed = updater_.set_fog(fog);
  for (const EntryRange& range : changed) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      entries_[i].color_intensity = updater_.entries()[i].color_intensity;
    }
  }
  return changed;
}

}  // namespace litfog::render
