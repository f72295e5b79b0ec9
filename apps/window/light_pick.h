// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "litfog/airlight.h"
#include "litfog/light.h"
#include "scene/scene.h"

namespace litfog::window {

/// The position of a point of the world in a picture, as fractions of its width and height from the top left corner.
/// Nothing for a point behind the near plane.
///
/// aspect  width / height
std::optional<glm::dvec2> place_in_picture(const scene::Camera& camera, double aspect, const glm::dvec3& point);

/// The ray, without an end, through a position in a picture.
///
/// place  fractions of its width and height
EyeRay ray_through(const scene::Camera& camera, double aspect, const glm::dvec2& place);

/// The lamp that a click means: of the lamps shown within `reach` that are not black, the nearest to the eye. Lamps
/// farther from the click count as farther away.
///
/// place  fractions of the picture's width and height
/// reach  fraction of the height
std::optional<std::size_t> light_at(const scene::Camera& camera, double aspect, std::span<const PlacedLight> lights,
                                    const glm::dvec2& place, double reach);

}  // namespace litfog::window
