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

/// A light of a scene in double, with everything that does not depend on the lit position.
struct ReferenceLight {
  PlacedLight placed;            ///< by render::drawn_light
  double extent;                 ///< metres, on surfaces
  double fog_threshold;          ///< attenuation at its end in the fog
  double fog_extent;             ///< range of that end, metres
  double fog_intensity;          ///< by peak, of lights that the eye's vehicle carries; else 0
  const Cookie* cookie;          ///< replaces the cone; null: none
  glm::dmat3 cookie_from_world;  ///< rotation
  ScatteringSource source = {};  ///< where fog scatters more than once
  bool casts_shadows = false;    ///< in the renderer

  /// The fraction of the axial intensity that the light sends into a unit direction.
  double emitted(const glm::dvec3& direction) const;
  /// The light's airlight along a ray, with fog on the leg from the lamp.
  double airlight(const Atmosphere& atmosphere, const EyeRay& ray) const;
};

/// Airlight of a ray that the ends of all lights together may cut off, as a fraction of the exposure's white.
inline constexpr double kCutOff = 1e-6;

/// A scene's lights, in its order. If the renderer lights the fog beyond a light's end on surfaces, the light ends
/// where kCutOff allows.
///
/// scene     must outlive them: they point to its cookies
/// exposure  EV, for which the renderer chooses ends
std::vector<ReferenceLight> reference_lights(const scene::Scene& scene, const Atmosphere& atmosphere,
                                             const render::RenderSettings& settings, double exposure = 0);

/// Upper bound of a light's airlight along a ray, through fog that also dims the leg from the lamp. Cheap enough to
/// find the few lights of thousands that matter. Cookies count as 1.
///
/// The largest weight of the fog, -f'(s) f(r), times the integral of the attenuation over the ray bounds the airlight.
/// The integral is at most the attenuation at the point nearest to the lamp times the length within the extent. With D
/// the attenuation's denominator and h the lamp's distance from the ray's line, it is also at most pi / sqrt(Q D(h)),
/// because D >= D(h) + Q x^2 at the distance x from the closest approach. The attenuation at the nearest point alone is
/// a bound, too: the fog's -f' adds up to at most 1. Each bound is multiplied by the cone at the smallest angle from
/// its axis, and by the largest value of the phase function.
///
/// returns  >= airlight, >= 0; infinite only where the attenuation is
double airlight_bound(const ReferenceLight& light, const EyeRay& ray, const Atmosphere& atmosphere);

}  // namespace litfog::measure
