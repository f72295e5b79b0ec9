// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "litfog/gl/shader_library.h"
#include "render/plan/lighting_path.h"

namespace litfog::papers {

// Programs that the papers print or describe besides the renderer's, only for their figures.

/// The spaces in which the Cg Tutorial lights vertices.
enum class Space { world, object, eye };

/// The Cg Tutorial's attenuation and spots at the vertices, as printed (examples 5-4 to 5-10).
const render::LightingPath& cg_at_vertices(Space space);
/// The path `cg` with lights of separate specular colour.
const render::LightingPath& cg_with_two_colors();

/// Frazier's spot lights in two passes each; their cube maps filter each other's light.
const render::LightingPath& frazier_in_two_passes();
/// Frazier's path `radial` with bump mapping, gloss and highlights, one of his improvements.
const render::LightingPath& frazier_with_bumps();

/// The files of apps/papers/shaders, embedded.
std::span<const gl::ShaderSource> paper_shaders();

}  // namespace litfog::papers
