// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/picture.h"
#include "scene/scene.h"

namespace litfog::papers {

/// Where a lamp's light is not hidden, by stencil: "To implement shadows, you could combine this technique with either
/// stencil shadowing or depth buffer shadow casting" (Ronald Frazier 2000, "Improvements"). The shadow of each triangle
/// is a volume, whose faces behind what is seen are counted (John Carmack 2000, William Bilodeau and Michael Songy
/// 1999: "depth fail"). A shadow begins a centimetre behind what casts it. Needs a current GL context.
///
/// returns  of each pixel 1 or 0
render::Picture draw_stencil_shadow(const scene::Scene& scene, const glm::dvec3& lamp, int width, int height);

}  // namespace litfog::papers
