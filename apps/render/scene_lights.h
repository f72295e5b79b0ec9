// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "litfog/fog_light_block.h"
#include "render/gpu/texture.h"
#include "scene/scene.h"

namespace litfog::render {

/// The lights of a scene as the renderer takes them: those that the eye's vehicle carries, which light the fog too, and
/// the local ones, less those of extent 0, which light nothing and must not show as points either. Needs a current GL
/// context.
class SceneLights {
 public:
  /// throws  gl::Unsupported where a buffer texture cannot hold the local lights
  /// scene  has to outlive this
  explicit SceneLights(const scene::Scene& scene);

  const std::vector<PlacedLight>& carried() const { return carried_; }
  const std::vector<PlacedLight>& local() const { return local_; }
  const std::vector<double>& local_extents() const { return local_extents_; }
  /// Binds the local lights as a buffer texture of FogLights.
  void bind_local(unsigned unit) const { local_texture_->bind(unit); }

  /// Local and carried lights in one row, the local ones first.
  std::size_t size() const { return local_.size() + carried_.size(); }
  const PlacedLight& light(std::size_t i) const { return i < local_.size() ? local_[i] : carried_[i - local_.size()]; }
  /// Without its fog intensity. A cookie is profile 3 (see cube_cookie.glsl).
  const FogLight& packed(std::size_t i) const { return packed_[i]; }
  /// The cookie in place of a light's cone; null where there is none.
  const scene::CookieUse* cookie(std::size_t i) const { return cookies_[i]; }
  double extent(std::size_t i) const {
    return i < local_.size() ? local_extents_[i] : carried_extents_[i - local_.size()];
  }

 private:
  std::vector<PlacedLight> carried_;
  std::vector<PlacedLight> local_;
  std::vector<double> carried_extents_;
  std::vector<double> local_extents_;
  std::vector<const scene::CookieUse*> cookies_;  // one a light
  std::vector<FogLight> packed_;
  std::unique_ptr<BufferTexture> local_texture_;
};

}  // namespace litfog::render
