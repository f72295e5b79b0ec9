// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace litfog::measure {

/// The sky in double, without fog: a gradient, stars and the moon, as render/shaders/sky.frag draws it.
///
/// direction  unit
glm::dvec3 night_sky(const scene::Environment& environment, const glm::dvec3& direction);

}  // namespace litfog::measure
