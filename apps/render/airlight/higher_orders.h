// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec4.hpp>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "litfog/gl/gl_name.h"
#include "litfog/multiple_scattering.h"
#include "litfog/photometry/cookie.h"
#include "litfog/scattered_beam.h"
#include "render/airlight/airlight_bound.h"
#include "render/gpu/data_texture.h"
#include "render/gpu/pass_textures.h"
#include "render/light/scene_lights.h"

namespace litfog::render {

/// What of a scene's lights is scattered twice and more often (litfog/multiple_scattering.h). It is summed with what
/// lights add beyond their extents (far_airlight.h), but for its peak around a lamp, which is drawn light by light
/// (shaders/airlight/higher_orders.glsl). Shadows do not darken it.
struct HigherOrders {
  std::optional<ScatteringTable> table;  ///< empty: fog scatters once
  /// Of each light the intensity of its ScatteringSource, its beam's index, the phase function's mean cosine and the
  /// soft range.
  std::vector<glm::vec4> sources;
  std::vector<ScatteredBeam> beams;     ///< of the different cones and cookies
  static constexpr int kPointBeam = 0;  ///< that of point lamps

  HigherOrders() = default;
  /// last  of the same cookies, whose moments it takes (27 ms for one of 512 texels), and what the phase function alone
  ///       decides (10 ms), where that is the same
  HigherOrders(const SceneLights& lights, std::span<const Cookie> cookies, const Atmosphere& atmosphere,
               const HigherOrders& last = {});

  PointGlow of(std::size_t light) const {
    return table ? PointGlow{&*table, double(sources[light].x), double(sources[light].w)} : PointGlow{};
  }

 private:
  std::map<std::size_t, BeamMoments> cookie_moments_;
  Phase phase_;
  ThinBeams thin_;
};

/// Holds them for shaders. Needs a current GL context.
class HigherOrderTextures {
 public:
  void set(const HigherOrders& orders);
  bool is_empty() const { return !sources_; }
  /// Lets a pass read them (shaders/airlight/higher_orders.glsl).
  void bind(PassTextures& textures) const;

 private:
  gl::TextureName table_, beams_;
  std::optional<BufferTexture> sources_;
};

}  // namespace litfog::render
