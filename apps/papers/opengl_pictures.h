// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "render/picture.h"
#include "scene/scene.h"

namespace litfog::papers {

/// A scene drawn by OpenGL's fixed pipeline, which Steven Hales 2004 measured (table 1, "legacy"), and the time of the
/// path `legacy`, a program that mimics it.
struct FixedPipeline {
  render::Picture picture;
  double mimic_ratio;  ///< median frame time of `legacy` over the pipeline's, frames interleaved
};

/// Draws ambient, directional and up to seven lamps' diffuse light at the vertices, one texture, fog of one colour by
/// depth, no sky. A spot whose cone OpenGL lacks ends at its cut-off. Uses its own context.
///
/// returns  nothing if the driver has no compatibility profile
std::optional<FixedPipeline> draw_by_fixed_pipeline(const scene::Scene& scene, const Fog& fog, int width, int height,
                                                    int frames);

/// Finds the pixels that a lamp lights, by stencil: "To implement shadows, you could combine this technique with either
/// stencil shadowing or depth buffer shadow casting" (Ronald Frazier 2000, "Improvements"). The shadow of each triangle
/// is a volume; its faces behind the visible surface are counted (John Carmack 2000, William Bilodeau and Michael Songy
/// 1999: "depth fail"). A shadow begins a centimetre behind its caster. Needs a current GL context.
///
/// returns  1 for each lit pixel, else 0
render::Picture draw_stencil_shadow(const scene::Scene& scene, const glm::dvec3& lamp, int width, int height);

}  // namespace litfog::papers
