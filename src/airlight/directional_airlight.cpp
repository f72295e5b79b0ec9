// SPDX-License-Identifier: Apache-2.0
#include "litfog/directional_airlight.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "model/density_profile_text.h"
#include "model/float_limit.h"
#include "model/phase_text.h"
#include "model/require.h"
#include "require_rays.h"

namespace litfog {
namespace {

/// The formulas as C++: the text that the shaders share.
struct DirectionalText : DensityProfileText<double> {
  static double exp(double x) { return std::exp(x); }

#define LITFOG_REAL double
#define LITFOG_FUNCTION
#define litfog_expm1 std::expm1
#include "litfog/shaders/directional_airlight.glsl"  // undefines the first two
#undef litfog_expm1
};

constexpr double kTotalFog = 1e25;  // density, 1/m, that stands for infinity: any depth in it is endless

void require_all(const Atmosphere& atmosphere, const glm::dvec3& to_light) {
  require(find_error(atmosphere));
  if (atmosphere.fog.mode != FogMode::exp) require(ValueError{"fog.mode", double(atmosphere.fog.mode), "must be exp"});
  require(find_direction_error(to_light, "to_light"));
}

/// A ray's length, at most 1e30 m: what lies beyond it in a ray without end adds nothing, and heights at its end have
/// finite differences from any top.
double finite_length(const Atmosphere& air, double height, double rise, double length) {
  constexpr double kDarkDepth = 800;  // e^-800 is 0
  constexpr double kEndless = 1e30;
  if (std::isfinite(length)) return std::min(length, kEndless);
  double last_edge = 0;
  if (rise != 0) {
    for (const DensityKnot& knot : air.profile.used()) last_edge = std::max(last_edge, (knot.height - height) / rise);
    last_edge = std::max(last_edge, (air.light_top() - height) / rise);
  }
  const double end = rise == 0 ? height : std::copysign(std::numeric_limits<double>::infinity(), rise);
  const double density = air.fog_at(end).density;
  return std::min(last_edge + (density > 0 ? kDarkDepth / std::min(density, kTotalFog) : 0), kEndless);
}

}  // namespace

double directional_fog_factor(const Atmosphere& atmosphere, const glm::dvec3& to_light, double height) {
  require_all(atmosphere, to_light);
  if (!is_within(height, -kMaxPosition, kMaxPosition)) {
    require(ValueError{"height", height, "must be at most 16777216 in magnitude"});
  }
  const double density = std::min(atmosphere.fog.density, kTotalFog);
  DirectionalText text{{atmosphere.profile}};
  return std::exp(-text.litfog_depth_to_light(density, height, glm::normalize(to_light).y, atmosphere.light_top()));
}

void directional_airlight(const Atmosphere& atmosphere, const glm::dvec3& to_light, std::span<const EyeRay> rays,
                          std::span<double> airlights) {
  assert(rays.size() == airlights.size());
  require_all(atmosphere, to_light);
  require_rays(rays);
  const glm::dvec3 light = glm::normalize(to_light);
  const double density = std::min(atmosphere.fog.density, kTotalFog);
  const auto phase = phase_text::pack<double>(atmosphere.phase);
  const double top = atmosphere.light_top();
  DirectionalText text{{atmosphere.profile}};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const EyeRay& ray = rays[i];
    const glm::dvec3 direction = glm::normalize(ray.direction);
    const glm::dvec3 turn = direction - light;
    const double length = finite_length(atmosphere, ray.origin.y, direction.y, ray.length);
    airlights[i] = phase_text::litfog_phase(phase, glm::dot(turn, turn) / 2) *
                   text.litfog_directional_scattering(density, ray.origin.y, direction.y, length, light.y, top);
  }
}

}  // namespace litfog
