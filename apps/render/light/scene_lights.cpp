// SPDX-License-Identifier: Apache-2.0
#include "render/light/scene_lights.h"

#include <algorithm>
#include <limits>

#include "litfog/formulas.h"
#include "render/light/light_map.h"

namespace litfog::render {
namespace {

constexpr double kSkipsNothing = 0;  // in 1/255: the reference has every light

glm::vec4 cookie_cone(const PlacedLight& light, const scene::CookieUse& use) {
  const glm::dvec3 up = glm::transpose(scene::cookie_from_world(light.direction, use.roll))[1];
  return {float(use.cookie), glm::vec3(up)};
}

}  // namespace

bool lights_fog_beyond_end(const RenderSettings& settings) {
  return settings.fog_lighting == FogLighting::airlight && settings.path->range != RangeLaw::radial;
}

bool lights_surfaces_beyond_end(const RenderSettings& settings) {
  return lights_fog_beyond_end(settings) && settings.path->evaluation == Evaluation::fragment;
}

bool has_scattered_light(const RenderSettings& settings) {
  return settings.fog_lighting == FogLighting::airlight && settings.scattering == Scattering::all &&
         settings.path->takes_scattered_light;
}

Light drawn_light(const Light& light, const RenderSettings& settings, double exposure) {
  const bool is_airlight = settings.fog_lighting == FogLighting::airlight;
  const bool has_maps = settings.path->maps != LightMapSet::none;
  Light drawn = is_airlight && !has_maps ? photometric(light) : light;
  if (lights_fog_beyond_end(settings)) drawn.threshold = airlight_threshold(drawn, exposure);
  drawn.flash = {};  // the colour is already the one at the scene's time
  if (has_maps) drawn.cone = mapped_cone(drawn.cone, settings.papers.cone_maps);
  return drawn;
}

glm::dvec3 placed_relative_to(const glm::dvec3& origin, const PlacedLight& light) {
  const glm::dvec3 position = light.position - origin;
  const glm::dvec3 size = glm::abs(position);
  const double largest = std::max({size.x, size.y, size.z});
  if (!(largest > kMaxPosition)) return position;
  return glm::clamp(position * (kMaxPosition / largest), -kMaxPosition, kMaxPosition);
}

SceneLights::SceneLights(const scene::Scene& scene, const RenderSettings& settings, double exposure)
    : origin_(scene::local_origin(scene.camera.position)),
      exposure_(exposure),
      light_surfaces_beyond_end_(lights_surfaces_beyond_end(settings)),
      updater_(kSkipsNothing) {
  for (const bool is_carried : {false, true}) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      PlacedLight light = scene::lit_light(scene, i);
      if (light.carried != is_carried || light.light.color == glm::dvec3(0)) continue;
      light.position = placed_relative_to(origin_, light);
      light.light = drawn_light(light.light, settings, exposure);
      const bool has_end = settings.path->range != RangeLaw::unbounded;
      const double extent = has_end ? compute_extent(light.light.attenuation, light.light.threshold)
                                    : std::numeric_limits<double>::infinity();
      if (!is_carried && !(extent > 0)) continue;
      const auto use = scene.cookie_uses.find(i);
      lights_.push_back(light);
      scene_lights_.push_back(i);
      extents_.push_back(extent);
      source_radii_.push_back(scene.lights[i].light.source_radius);
      const auto mount = scene.mounts.find(i);
      mounts_.push_back(mount == scene.mounts.end() ? scene::Mount{.light = scene::bearing_of(light.direction)}
                                                    : mount->second);
      cookies_.push_back(use == scene.cookie_uses.end() ? nullptr : &use->second);
      light.carried = is_carried && settings.path->has_lit_fog && settings.fog_lighting == FogLighting::peak;
      updater_.add(light);
    }
    if (!is_carried) local_count_ = lights_.size();
  }
  updater_.set_fog(Fog{});
  instances_.assign(updater_.instances().begin(), updater_.instances().end());
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    if (!cookies_[i]) continue;
    instances_[i].axis_profile.w = float(LITFOG_PROFILE_COOKIE);
    instances_[i].color.w = float(cookie_cones_.size());
    cookie_cones_.push_back(cookie_cone(lights_[i], *cookies_[i]));
  }
}

PackedLight SceneLights::packed(std::size_t index) const {
  const FogLightInstance& instance = instances_[index];
  return {.kind = kinds()[std::size_t(instance.position_kind.w)], .instance = instance};
}

}  // namespace litfog::render
