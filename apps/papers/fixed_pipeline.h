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

}  // namespace litfog::papers
