// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace litfog::bench {

/// A scene with another number of lights, to measure the cost of a light. The scene's own lights come first: carried
/// lights in their order, then local lights, the nearest to the eye first. If they are too few, copies of the local
/// lights (or else of the carried ones) are spread evenly, at their heights, over the field of view of a 16:9 picture,
/// out to one and a half times the range of the camera's target. All copies together are as bright as their originals.
///
/// scene  has at least one light; its camera does not look straight up or down
/// count  >= 1
scene::Scene with_light_count(scene::Scene scene, std::size_t count);

}  // namespace litfog::bench
