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

/// Where a picture shows a point of the world, as fractions of its width and height from the top left corner. Nothing
/// for a point behind the near plane.
///
/// aspect  width / height
std::optional<glm::dvec2> place_in_picture(const scene::Camera& camera, double aspect, const glm::dvec3& point);

/// The ray that a picture shows at a place, without an end.
///
/// place  fractions of its width and height
EyeRay ray_through(const scene::Camera& camera, double aspect, const glm::dvec2& place);

/// The lamp that a click means: of those shown at most `reach` from there that are not black, the nearest to the eye;
/// what is farther from the click counts as farther away.
///
/// place  fractions of the picture's width and height
/// reach  fraction of its height
std::optional<std::size_t> light_at(const scene::Camera& camera, double aspect, std::span<const PlacedLight> lights,
                                    const glm::dvec2& place, double reach);

}  // namespace litfog::window
