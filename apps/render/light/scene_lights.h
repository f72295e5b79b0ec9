// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "litfog/fog_light_block.h"
#include "litfog/updater.h"
#include "render/light/light_threshold.h"
#include "render/render_settings.h"
#include "scene/scene.h"

namespace litfog::render {

/// Whether lights light the fog beyond their ends. Hundreds of cut-off tails, each too faint to be seen, add up.
bool lights_fog_beyond_end(const RenderSettings& settings);

/// Whether lights light surfaces beyond their ends, up to SurfaceList::range_of(). On paths with light maps lights end
/// where the maps do. On paths that light vertices the tails are smaller than the paths' own error.
bool lights_surfaces_beyond_end(const RenderSettings& settings);

/// Whether light that the fog scatters reaches surfaces, in atmospheres without a find_scattering_error().
bool has_scattered_light(const RenderSettings& settings);

/// A light as a renderer draws it. By airlight it is photometric(), except on paths with light maps, whose texels are
/// too large near a lamp. By airlight it ends at airlight_threshold(), except on paths with the radial range law, which
/// falls to 0 at the end: a farther end would make it brighter everywhere. Paths with light maps have the cone of their
/// maps (mapped_cone).
///
/// exposure  EV at which the picture is shown; below 0 counts as 0
Light drawn_light(const Light& light, const RenderSettings& settings, double exposure = 0);

/// A light's position relative to an origin. A light beyond the library's largest distance is moved to that distance,
/// in its direction.
glm::dvec3 placed_relative_to(const glm::dvec3& origin, const PlacedLight& light);

/// A light for shaders that take it as uniforms: vec4s in the order of shaders/light_batch.glsl.
struct PackedLight {
  FogLightKind kind;
  FogLightInstance instance;
};
inline constexpr std::size_t kPackedVectors = sizeof(PackedLight) / sizeof(glm::vec4);

/// The lights of a scene as the renderer takes them: local lights first, then carried lights (on the eye's vehicle;
/// they also light the fog). Lights that are off are left out: black ones, and local ones of extent 0, which light
/// nothing and have no visible point. Positions are relative to an origin near the scene's camera, so that floats are
/// precise around it.
class SceneLights {
 public:
  /// scene     must outlive this object
  /// settings  path and fog_lighting decide whether carried lights light the fog by their intensity, and where lights
  ///           end
  /// exposure  EV at which the picture is shown (drawn_light)
  SceneLights(const scene::Scene& scene, const RenderSettings& settings, double exposure = 0);

  const glm::dvec3& origin() const { return origin_; }
  double exposure() const { return exposure_; }  ///< EV for which the lights' ends are chosen
  std::size_t size() const { return lights_.size(); }
  std::size_t local_count() const { return local_count_; }
  std::size_t carried_count() const { return size() - local_count_; }
  std::span<const PlacedLight> lights() const { return lights_; }
  /// The extent of each light, metres.
  std::span<const double> extents() const { return extents_; }
  /// lights_surfaces_beyond_end() of the settings.
  bool light_surfaces_beyond_end() const { return light_surfaces_beyond_end_; }
  /// The cookie that replaces a light's cone, or null.
  const scene::CookieUse* cookie(std::size_t light) const { return cookies_[light]; }
  /// Metres; 0 where none is known.
  double source_radius(std::size_t light) const { return source_radii_[light]; }
  /// A light's index in Scene::lights.
  std::size_t scene_light(std::size_t light) const { return scene_lights_[light]; }

  /// A light's direction as seen from its vehicle; without one, from the world's origin looking along -Z.
  const scene::Mount& mount(std::size_t light) const { return mounts_[light]; }

  /// Changes the fog. Returns the changed ranges of the tables, valid until the next call.
  FogLightChanges set_fog(const Fog& fog) { return updater_.set_fog(fog); }
  /// The tables that shaders read: instance i is light i.
  std::span<const FogLightKind> kinds() const { return updater_.kinds(); }
  std::span<const FogLightInstance> instances() const { return instances_; }
  /// A light for shaders that take lights as uniforms.
  PackedLight packed(std::size_t index) const;
  /// For each light with a cookie, the cookie and its y axis in world space. The instance's color.w is the index
  /// (cube_cookie.glsl).
  std::span<const glm::vec4> cookie_cones() const { return cookie_cones_; }

 private:
  glm::dvec3 origin_;
  double exposure_;
  bool light_surfaces_beyond_end_;
  std::vector<PlacedLight> lights_;
  std::size_t local_count_ = 0;
  std::vector<double> extents_;
  std::vector<double> source_radii_;
  std::vector<const scene::CookieUse*> cookies_;
  std::vector<std::size_t> scene_lights_;
  std::vector<scene::Mount> mounts_;
  FogUpdater updater_;
  std::vector<FogLightInstance> instances_;  // the updater's instances, with cookies
  std::vector<glm::vec4> cookie_cones_;
};

}  // namespace litfog::render
