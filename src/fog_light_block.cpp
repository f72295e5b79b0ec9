// SPDX-License-Identifier: Apache-2.0
#include "litfog/fog_light_block.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "require.h"
#include "unchecked.h"

namespace litfog {
namespace {

/// A value >= 0 as a float, without the two that a shader may stumble over: infinity, of which the product with 0 is
/// NaN, as the largest float; -0 as 0.
float finite_float(double x) { return float(std::min(std::abs(x), double(std::numeric_limits<float>::max()))); }
glm::vec3 finite_floats(const glm::dvec3& v) { return {finite_float(v.x), finite_float(v.y), finite_float(v.z)}; }

glm::vec4 pack_cone(const Cone& cone) {
  switch (cone.profile) {
    case ConeProfile::cosine:
      return {std::cos(cone.half_angle), finite_float(cone.exponent), 0, 0};
    case ConeProfile::smoothstep:
      return {std::cos(cone.outer), std::cos(cone.inner), 0, 0};
    case ConeProfile::none:
      break;
  }
  return glm::vec4{0};
}

float pack_profile(ConeProfile profile) {
  switch (profile) {
    case ConeProfile::cosine:
      return 1;
    case ConeProfile::smoothstep:
      return 2;
    case ConeProfile::none:
      break;
  }
  return 0;
}

}  // namespace

FogLight unchecked::pack_fog_light(const PlacedLight& placed, const FogIntensity& solution) {
  const auto& [light, position, direction, carried] = placed;
  const Attenuation& attenuation = light.attenuation;
  return {.position_extent = {glm::vec3(position), finite_float(solution.extent)},
          .axis_profile = {glm::vec3(direction), pack_profile(light.cone.profile)},
          .color_intensity = {finite_floats(light.color), carried ? float(solution.intensity) : 0.0f},
          .attenuation = {finite_float(attenuation.constant), finite_float(attenuation.linear),
                          finite_float(attenuation.quadratic), finite_float(light.density_scale)},
          .cone = pack_cone(light.cone)};
}

FogLight pack_fog_light(const PlacedLight& light, const FogIntensity& solution) {
  require(check(light));
  return unchecked::pack_fog_light(light, solution);
}

FogLightBlock pack_fog_light_block(const Fog& fog, const glm::dvec3& ambient_fog_color,
                                   std::span<const PlacedLight> lights, std::span<const FogIntensity> solutions) {
  require(check(fog));
  require(check_color(ambient_fog_color, {"ambient_fog_color.r", "ambient_fog_color.g", "ambient_fog_color.b"}));
  if (lights.size() > kMaxFogLights) require(ValueError{"lights", double(lights.size()), "must be at most 128"});
  if (solutions.size() != lights.size()) {
    require(ValueError{"solutions", double(solutions.size()), "must be as many as the lights"});
  }
  FogLightBlock block{};
  block.fog = {finite_float(fog.density), fog.mode == FogMode::exp2 ? 1.0f : 0.0f, float(lights.size()), 0.0f};
  block.ambient_fog_color = glm::vec4(finite_floats(ambient_fog_color), 0.0f);
  std::ranges::transform(lights, solutions, block.lights.begin(), pack_fog_light);
  return block;
}

}  // namespace litfog
