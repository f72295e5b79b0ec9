// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "litfog/fog.h"
#include "litfog/light.h"
#include "scene/scene.h"

namespace litfog::measure {

/// A light of a scene in double, with everything that does not depend on the position it lights.
struct ReferenceLight {
  glm::dvec3 position;
  glm::dvec3 axis;
  glm::dvec3 color;
  Attenuation attenuation;
  Cone cone;
  double extent;                 ///< metres
  double fog_intensity;          ///< 0 unless the light is carried by the eye's vehicle
  const Cookie* cookie;          ///< replaces the cone; null: none
  glm::dmat3 cookie_from_world;  ///< rotation

  /// The fraction of the axial intensity that the light sends into a unit direction.
  double emitted(const glm::dvec3& direction) const;
};

/// A scene's lights, in its order.
///
/// scene  has to outlive them: they point to its cookies
std::vector<ReferenceLight> reference_lights(const scene::Scene& scene, const Fog& fog);

}  // namespace litfog::measure
