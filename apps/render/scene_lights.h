// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "litfog/fog_light_block.h"
#include "litfog/updater.h"
#include "render/render_settings.h"
#include "scene/scene.h"

namespace litfog::render {

/// Where a light ends: at its own threshold or, lit by airlight, where its colour's largest component is below 1/255, so
/// that no end is seen on surfaces or in the fog.
double threshold_of(const Light& light, FogLighting fog_lighting);

/// The lights of a scene as the renderer takes them: first the local lights, then those that the eye's vehicle carries,
/// which light the fog too. Local lights of extent 0 are left out: they light nothing and have no visible point.
class SceneLights {
 public:
  /// scene  has to outlive this
  /// settings  of which the path and the fog's lighting say whether carried lights light the fog by their intensity, and
  ///           where lights end
  SceneLights(const scene::Scene& scene, const RenderSettings& settings);

  std::size_t size() const { return lights_.size(); }
  std::size_t local_count() const { return local_count_; }
  std::span<const PlacedLight> lights() const { return lights_; }
  /// Metres, one a light.
  std::span<const double> extents() const { return extents_; }
  /// The cookie that replaces a light's cone, or null.
  const scene::CookieUse* cookie(std::size_t light) const { return cookies_[light]; }

  /// Takes a change of the fog. Returns the entries that changed, good until the next call.
  std::span<const EntryRange> set_fog(const Fog& fog);
  /// The lights as shaders read them, in the updater's order. A cookie is profile 3 (cube_cookie.glsl).
  std::span<const FogLight> entries() const { return entries_; }
  std::size_t entry_of(std::size_t light) const { return entry_of_[light]; }
  const FogLight& packed(std::size_t light) const { return entries_[entry_of_[light]]; }

 private:
  std::vector<PlacedLight> lights_;
  std::size_t local_count_ = 0;
  std::vector<double> extents_;
  std::vector<const scene::CookieUse*> cookies_;
  FogUpdater updater_;
  std::vector<std::size_t> entry_of_;
  std::vector<FogLight> entries_;  // the updater's, with cookies
};

}  // namespace litfog::render
