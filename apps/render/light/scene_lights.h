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

/// Where a light ends: at its own threshold or, lit by airlight, at airlight_threshold(). On a path of the radial range
/// law always at its own: that law falls to 0 there, and is brighter everywhere the farther off the end is.
///
/// settings  of which the path and the fog's lighting matter
/// exposure  EV at which the picture is shown; below 0 ends are those of 0 EV
double threshold_of(const Light& light, const RenderSettings& settings, double exposure = 0);

/// Whether lights light the fog beyond their ends, too: hundreds of tails that are cut off, each too faint to be seen,
/// would add up.
bool lights_fog_beyond_end(const RenderSettings& settings);

/// Whether they light surfaces beyond their ends likewise, as far as SurfaceList::range_of() says. Paths that look
/// lights up end where their maps do, and those that light vertices are farther from the formula than tails are bright.
bool lights_surfaces_beyond_end(const RenderSettings& settings);

/// A light's cone as a renderer draws it: its own, but for paths whose maps hold another (mapped_cone).
Cone drawn_cone(const Cone& cone, const RenderSettings& settings);

/// A light's position as seen from an origin. One on the other side of the world, farther away than the library takes
/// lights, is as far away in its direction as can be.
glm::dvec3 placed_relative_to(const glm::dvec3& origin, const PlacedLight& light);

/// A light for shaders that take it as uniforms: vec4s, as shaders/light_batch.glsl counts them.
struct PackedLight {
  FogLightKind kind;
  FogLightInstance instance;
};
inline constexpr std::size_t kPackedVectors = sizeof(PackedLight) / sizeof(glm::vec4);

/// The lights of a scene as the renderer takes them: first the local lights, then those that the eye's vehicle carries,
/// which light the fog too. Lights that are off are left out: black ones, and local ones of extent 0, which light
/// nothing and have no visible point. Their positions are relative to an origin near the scene's camera, from which
/// floats measure them and all that they light.
class SceneLights {
 public:
  /// scene     has to outlive this
  /// settings  of which the path and the fog's lighting say whether carried lights light the fog by their intensity,
  ///           and where lights end
  /// exposure  EV at which the picture is shown (threshold_of)
  SceneLights(const scene::Scene& scene, const RenderSettings& settings, double exposure = 0);

  const glm::dvec3& origin() const { return origin_; }
  double exposure() const { return exposure_; }  ///< EV, for which ends are chosen
  std::size_t size() const { return lights_.size(); }
  std::size_t local_count() const { return local_count_; }
  std::size_t carried_count() const { return size() - local_count_; }
  std::span<const PlacedLight> lights() const { return lights_; }
  /// Metres, one a light.
  std::span<const double> extents() const { return extents_; }
  /// lights_surfaces_beyond_end() of the settings.
  bool light_surfaces_beyond_end() const { return light_surfaces_beyond_end_; }
  /// The cookie that replaces a light's cone, or null.
  const scene::CookieUse* cookie(std::size_t light) const { return cookies_[light]; }
  /// A light's index in Scene::lights.
  std::size_t scene_light(std::size_t light) const { return scene_lights_[light]; }

  /// Where a light points as seen from its vehicle, or from the world's origin, which looks along -Z.
  const scene::Mount& mount(std::size_t light) const { return mounts_[light]; }

  /// Takes a change of the fog. Returns what has changed of the tables, good until the next call.
  FogLightChanges set_fog(const Fog& fog) { return updater_.set_fog(fog); }
  /// The tables that shaders read: instance i is light i.
  std::span<const FogLightKind> kinds() const { return updater_.kinds(); }
  std::span<const FogLightInstance> instances() const { return instances_; }
  /// Of an instance.
  PackedLight packed(std::size_t index) const;
  /// A cookie and the cookie's y axis in world space, for each light that has one: color.w of its instance is the index
  /// (cube_cookie.glsl).
  std::span<const glm::vec4> cookie_cones() const { return cookie_cones_; }

 private:
  glm::dvec3 origin_;
  double exposure_;
  bool light_surfaces_beyond_end_;
  std::vector<PlacedLight> lights_;
  std::size_t local_count_ = 0;
  std::vector<double> extents_;
  std::vector<const scene::CookieUse*> cookies_;
  std::vector<std::size_t> scene_lights_;
  std::vector<scene::Mount> mounts_;
  FogUpdater updater_;
  std::vector<FogLightInstance> instances_;  // the updater's, with cookies
  std::vector<glm::vec4> cookie_cones_;
};

}  // namespace litfog::render
