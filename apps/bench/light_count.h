// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace litfog::bench {

/// A scene with another number of lights, to see what a light costs. Its own come first: those that the eye's vehicle
/// carries in their order, then the local ones as they are near the eye. Where it has too few, copies of its local
/// lights (of its carried ones where it has no others), at their heights, are strewn evenly over the field of view of a
/// picture of 16:9, out to one and a half times the range of the camera's target. All of them together are as bright as
/// the lights that they copy were.
///
/// scene  with a light at least, its camera not straight up or down
/// count  >= 1
scene::Scene with_light_count(scene::Scene scene, std::size_t count);

}  // namespace litfog::bench
