// SPDX-License-Identifier: Apache-2.0
#include "litfog/fog_light_block.h"

#include <algorithm>
#include <limits>

#include "fog_light_count.h"
#include "model/packed_cone.h"
#include "model/phase_text.h"
#include "model/require.h"
#include "model/unchecked.h"

namespace litfog {
namespace {

/// A value as a float, without two that may harm a shader: infinity, whose product with 0 is NaN, becomes the largest
/// float; -0 becomes 0.
float finite_float(double x) {
  constexpr double kMax = std::numeric_limits<float>::max();
  return float(std::clamp(x, -kMax, kMax)) + 0.0f;
}
glm::vec3 finite_floats(const glm::dvec3& v) { return {finite_float(v.x), finite_float(v.y), finite_float(v.z)}; }

}  // namespace

FogLightKind unchecked::pack_fog_light_kind(const PlacedLight& placed, const FogIntensity& solution) {
  const Light& light = placed.light;
  const auto& [constant, linear, quadratic] = light.attenuation;
  const PackedCone<double> cone = packed_cone<double>(light.cone);
  return {.attenuation_extent = {finite_float(constant), finite_float(linear), finite_float(quadratic),
                                 finite_float(solution.extent)},
          .cone_scale_intensity = {finite_float(cone.x), finite_float(cone.y), finite_float(light.density_scale),
                                   placed.carried ? float(solution.intensity) : 0.0f}};
}

FogLightInstance unchecked::pack_fog_light_instance(const PlacedLight& placed, std::size_t kind) {
  return {.position_kind = {glm::vec3(placed.position), float(kind)},
          .axis_profile = {glm::vec3(placed.direction), float(placed.light.cone.profile)},
          .color = {finite_floats(placed.light.color), 0.0f}};
}

FogLightKind pack_fog_light_kind(const PlacedLight& light, const FogIntensity& solution) {
  require(find_error(light));
  return unchecked::pack_fog_light_kind(light, solution);
}

FogLightInstance pack_fog_light_instance(const PlacedLight& light, std::size_t kind) {
  require(find_error(light));
  if (kind > 1u << 24) fail_count("kind", kind, "must be at most 16777216");
  return unchecked::pack_fog_light_instance(light, kind);
}

FogHeader pack_fog_header(const Atmosphere& atmosphere, std::size_t instances) {
  require(find_error(atmosphere));
  require_fog_light_count("instances", instances);
  const Fog& fog = atmosphere.fog;
  const auto phase = phase_text::pack<double>(atmosphere.phase);
  // (1 - g)^2 for the largest float g below 1: the power 3/2 of less would be 0 in floats.
  static constexpr double kLeastBase = 0x1p-48;
  const auto floats = [](const phase_text::PackedLobe<double>& lobe) {
    return glm::vec4(std::max(lobe.base, kLeastBase), lobe.slope, lobe.scale, lobe.alpha);
  };
  const glm::vec3 ambient = finite_floats(atmosphere.ambient_fog_color);
  FogHeader header{.fog = {finite_float(fog.density), float(fog.mode), float(instances), float(atmosphere.albedo)},
                   .ambient_fog_color = glm::vec4(ambient, float(atmosphere.profile.count)),
                   .phase_lobes = {floats(phase.first), floats(phase.second)},
                   .density_knots = {}};
  const DensityProfileF profile = to_floats(atmosphere.profile);
  for (std::size_t i = 0; i < profile.count; ++i) {
    header.density_knots[i] = {profile.knots[i].height, profile.knots[i].density, 0.0f, 0.0f};
  }
  return header;
}

FogLightBlock pack_fog_light_block(const Atmosphere& atmosphere, std::span<const PlacedLight> lights,
                                   std::span<const FogIntensity> solutions) {
  require_fog_light_count("lights", lights.size());
  if (solutions.size() != lights.size()) {
    require(ValueError{"solutions", double(solutions.size()), "must be as many as the lights"});
  }
  FogLightBlock block{};
  block.header = pack_fog_header(atmosphere, lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    block.kinds[i] = pack_fog_light_kind(lights[i], solutions[i]);
    block.instances[i] = unchecked::pack_fog_light_instance(lights[i], i);
  }
  return block;
}

}  // namespace litfog
