// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "render/gpu/data_texture.h"
#include "render/light/light_map.h"
#include "render/light/scene_lights.h"
#include "render/render_settings.h"

namespace litfog::render {

/// The light maps of a path on the GPU. Lights that agree in a map's parameters share the map (Steven Hales 2004,
/// "Realtime Pixel Lighting Using Fragment Programs", section "Multiple Light Sources"). Needs a current GL context.
class LightMapStore {
 public:
  /// settings.papers.map_size  texels along a side of a 3-D map, a cube map's face and Frazier's maps; the 2-D pair has
  ///                           as many texels as a 3-D map
  /// throws  gl::Unsupported where this OpenGL has no textures of that size, or where all maps together would take more
  ///         than 1 GiB
  LightMapStore(const scene::Scene& scene, const SceneLights& lights, const RenderSettings& settings);

  /// One number a light; lights with the same number share their maps. Empty where the path has no maps.
  std::span<const int> kinds() const { return kinds_; }
  /// Turns vectors from the light into coordinates of its cube map.
  const glm::mat3& cone_from_world(std::size_t light) const { return cones_from_world_[light]; }
  /// Binds the maps of a number from kinds().
  void bind(int kind) const;

 private:
  struct Maps {
    const LookupTexture* range;  // null: squares_, which moves with this object
    const LookupTexture* cone;

    friend bool operator==(const Maps&, const Maps&) = default;
  };

  /// Throws gl::Unsupported if all maps together would take too much memory.
  void expect_room(const SceneLights& lights) const;
  bool is_volume() const { return set_ == LightMapSet::volume; }
  int range_side() const;
  int cone_side(const Cone& cone) const;
  /// The cone whose map a cone shares.
  Cone stored_cone(const Cone& cone) const;
  const LookupTexture* range_map(const PlacedLight& light, double extent);
  const LookupTexture* cone_map(const Cone& cone);
  const LookupTexture* cookie_map(const scene::Scene& scene, std::size_t cookie);

  LightMapSet set_;
  int size_;
  ConeMaps cone_coverage_;
  std::map<RangeProfile, LookupTexture> range_maps_;
  std::deque<std::pair<Cone, LookupTexture>> cone_maps_;
  std::map<std::size_t, LookupTexture> cookie_maps_;
  std::optional<LookupTexture> squares_;   // x^2 + y^2
  std::optional<LookupTexture> distance_;  // q, or z^2
  std::vector<Maps> maps_;
  std::vector<int> kinds_;  // index in maps_, one a light
  std::vector<glm::mat3> cones_from_world_;
};

/// Uploads cookies into one array texture, each scaled to the size of the largest: the layers of cube_cookie.glsl.
///
/// throws  gl::Unsupported if the driver's layer or size limit is exceeded
LayeredTexture upload_cookies(const std::vector<Cookie>& cookies);

}  // namespace litfog::render
