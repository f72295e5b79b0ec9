// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "litfog/airlight.h"
#include "litfog/fog.h"
#include "litfog/light.h"
#include "litfog/multiple_scattering.h"
#include "render/render_settings.h"
#include "scene/scene.h"

namespace litfog::measure {

/// A light of a scene in double, with everything that does not depend on the position it lights.
struct ReferenceLight {
  PlacedLight placed;            ///< as render::drawn_light has it
  double extent;                 ///< metres, on surfaces
  double fog_threshold;          ///< where it ends in the fog
  double fog_extent;             ///< metres: that end
  double fog_intensity;          ///< 0 unless the light is carried by the eye's vehicle, and in airlight
  const Cookie* cookie;          ///< replaces the cone; null: none
  glm::dmat3 cookie_from_world;  ///< rotation
  ScatteringSource source = {};  ///< where fog scatters more than once
  bool casts_shadows = false;    ///< one of the renderer's that do

  /// The fraction of the axial intensity that the light sends into a unit direction.
  double emitted(const glm::dvec3& direction) const;
  /// Its airlight along a ray, its own leg fogged.
  double airlight(const Atmosphere& atmosphere, const EyeRay& ray) const;
};

/// What the ends of all lights together may cut off the airlight of a ray, of what the exposure shows as white.
inline constexpr double kCutOff = 1e-6;

/// A scene's lights, in its order. Where the renderer lights the fog beyond a light's end on surfaces, it ends where
/// kCutOff allows.
///
/// scene     has to outlive them: they point to its cookies
/// exposure  EV, for which the renderer chooses ends
std::vector<ReferenceLight> reference_lights(const scene::Scene& scene, const Atmosphere& atmosphere,
                                             const render::RenderSettings& settings, double exposure = 0);

/// A bound of a light's airlight along a ray, through fog that dims the lamp's leg too: cheap enough to find the few
/// lights of thousands that matter. Cookies count as if they let all light through.
///
/// The largest weight of the fog, -f'(s) f(r), times the integral of the attenuation over the ray bounds the airlight.
/// The integral is at most the attenuation at the point nearest to the lamp times the length within the extent; and
/// with D the attenuation's denominator and h the lamp's distance from the ray's line, at most pi / sqrt(Q D(h)),
/// because D >= D(h) + Q x^2 at the distance x from the closest approach. The attenuation at the nearest point alone is
/// a bound, too: the fog's -f' adds up to at most 1. All of them are multiplied with the cone at the smallest angle
/// from its axis, and with the largest value of the phase function.
///
/// returns  >= airlight, >= 0; may be infinite only where the attenuation is
double airlight_bound(const ReferenceLight& light, const EyeRay& ray, const Atmosphere& atmosphere);

}  // namespace litfog::measure
