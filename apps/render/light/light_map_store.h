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

/// The light maps of a path on the GPU, each made once for all lights that agree in its parameters (Steven Hales 2004,
/// "Realtime Pixel Lighting Using Fragment Programs", section "Multiple Light Sources"). Needs a current GL context.
class LightMapStore {
 public:
  /// settings.map_size  texels a side of a 3-D map, a cube map's face and Frazier's maps; the 2-D pair has a volume's
  ///                    texels
  /// throws  gl::Unsupported where this OpenGL has no textures of that size, or where the maps of all shapes of lights
  ///         would take more than 1 GiB
  LightMapStore(const scene::Scene& scene, const SceneLights& lights, const RenderSettings& settings);

  /// One number a light: lights of the same number share their maps. Empty where the path has no maps.
  std::span<const int> kinds() const { return kinds_; }
  /// Turns vectors from the light into coordinates of its cube map.
  const glm::mat3& cone_from_world(std::size_t light) const { return cones_from_world_[light]; }
  /// Binds the maps of such a number.
  void bind(int kind) const;

 private:
  struct Maps {
    const LookupTexture* range;
    const LookupTexture* cone;

    friend bool operator==(const Maps&, const Maps&) = default;
  };

  /// Before the first map is made.
  void expect_room(const SceneLights& lights) const;
  bool is_volume() const { return set_ == LightMapSet::volume; }
  int range_side() const;
  int cone_side(const Cone& cone) const;
  /// The cone whose map a cone takes.
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
  std::optional<LookupTexture> squares_;   // of x and y
  std::optional<LookupTexture> distance_;  // q, or the square of z
  std::vector<Maps> maps_;
  std::vector<int> kinds_;  // in maps_, one a light
  std::vector<glm::mat3> cones_from_world_;
};

/// All cookies in one array, each as large as the largest: the layers of cube_cookie.glsl.
///
/// throws  gl::Unsupported if the driver's layer or size limit is exceeded
LayeredTexture upload_cookies(const std::vector<Cookie>& cookies);

}  // namespace litfog::render
