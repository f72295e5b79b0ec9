// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "render/picture.h"
#include "scene/scene.h"

namespace litfog::papers {

/// A scene by OpenGL's fixed pipeline, as Steven Hales 2004 measured his cards' (table 1, "legacy"), beside the path
/// `legacy`, which is a program that mimics it.
struct FixedPipeline {
  render::Picture picture;
  double mimic_ratio;  ///< the program's median frame time over the pipeline's, frames interleaved
};

/// Draws ambient, directional and up to seven lamps' diffuse light at the vertices, one texture, fog of one colour by
/// the depth, no sky. Where OpenGL has no such cone, a spot ends at its cut-off. In a context of its own.
///
/// returns  nothing where the driver has no compatibility profile
std::optional<FixedPipeline> draw_by_fixed_pipeline(const scene::Scene& scene, const Fog& fog, int width, int height,
                                                    int frames);

/// Where a lamp's light is not hidden, by stencil: "To implement shadows, you could combine this technique with either
/// stencil shadowing or depth buffer shadow casting" (Ronald Frazier 2000, "Improvements"). The shadow of each triangle
/// is a volume, whose faces behind what is seen are counted (John Carmack 2000, William Bilodeau and Michael Songy
/// 1999: "depth fail"). A shadow begins a centimetre behind what casts it. Needs a current GL context.
///
/// returns  of each pixel 1 or 0
render::Picture draw_stencil_shadow(const scene::Scene& scene, const glm::dvec3& lamp, int width, int height);

}  // namespace litfog::papers
