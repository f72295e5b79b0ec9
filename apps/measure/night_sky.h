// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace litfog::measure {

/// The sky in double, without fog: a gradient, stars and the moon, as render/shaders/night_sky.glsl draws it.
///
/// direction  unit
glm::dvec3 night_sky(const scene::Environment& environment, const glm::dvec3& direction);

/// The length within the fog of a ray to the sky, where the fog ends at a height: metres, at most render::kSkyDistance,
/// which stands for infinity. A rising ray leaves the fog at that height, or at the eye if the eye is above it. A ray
/// that does not rise never leaves the fog, because no ground lies before the sky. From above, it enters the fog and
/// stays; only a level ray never meets it.
///
/// fog_above_eye  metres from the eye up to the fog's top; negative: the eye is above it; infinite: no top
/// direction      unit
double fog_before_sky(double fog_above_eye, const glm::dvec3& direction);

}  // namespace litfog::measure
