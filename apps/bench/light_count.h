// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace litfog::bench {

/// A scene with another number of lights, to measure what a light costs. The scene's own lights come first: those that
/// the eye's vehicle carries in their order, then the local ones from the nearest to the eye on. If they are too few,
/// copies of the local lights (of the carried ones if there are no others) are spread evenly, at their heights, over
/// the field of view of a picture of 16:9, out to one and a half times the range of the camera's target. All copies
/// together are as bright as the lights that they copy were.
///
/// scene  has at least one light; its camera does not look straight up or down
/// count  >= 1
scene::Scene with_light_count(scene::Scene scene, std::size_t count);

}  // namespace litfog::bench
