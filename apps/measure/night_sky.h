// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace litfog::measure {

/// The sky in double, without fog: a gradient, stars and the moon, as render/shaders/night_sky.glsl draws it.
///
/// direction  unit
glm::dvec3 night_sky(const scene::Environment& environment, const glm::dvec3& direction);

/// How far a ray to the sky runs through fog that ends at a height: metres, at most render::kSkyDistance, which stands
/// for infinity. A ray leaves the fog where it rises to the height, at the eye itself if the eye is above. A ray
/// that does not rise never leaves the fog, for the sky below the horizon has no ground before it; from above the fog
/// it enters and stays, except the level one, which never meets it.
///
/// fog_above_eye  metres from the eye up to the fog's top; negative where the eye is above, infinite: no top
/// direction      unit
double fog_before_sky(double fog_above_eye, const glm::dvec3& direction);

}  // namespace litfog::measure
