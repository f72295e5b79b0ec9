// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/render_settings.h"
#include "scene/scene.h"

namespace litfog::render {

/// Sorts a scene's polygons: each instance is cut into the triangles that lights can reach and the rest, which is then
/// drawn by a program without lights. "The polygons within the extent of the light (and within the cone angle) can be
/// sorted from those outside the extent of the light (or outside the cone angle)." (Steven Hales 2004, "Realtime Pixel
/// Lighting Using Fragment Programs", section "Graphics Cards Performance"). A light reaches a triangle if it reaches
/// its bounding box. A carried light reaches any distance in its cone, because it lights the fog there.
scene::Scene sort_polygons(const scene::Scene& scene, const RenderSettings& settings);

}  // namespace litfog::render
