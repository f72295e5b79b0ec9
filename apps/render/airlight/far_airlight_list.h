// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "litfog/atmosphere.h"
#include "litfog/formulas.h"
#include "render/airlight/higher_orders.h"
#include "render/light/scene_lights.h"

namespace litfog::render {

/// The lights whose airlight beyond their extents, or of higher orders, a picture shows, grouped by profile
/// (FogLightInstance). A ray is cut into sections, and the farther from the eye a section lies, the fewer lights it
/// needs.
struct FarAirlightList {
  static constexpr int kSections = 4;
  /// Radians: smaller angles of scattering count as this one. The rest, a peak of the phase function too narrow for the
  /// sum's texels, is drawn light by light (litfog/shaders/far_airlight.glsl).
  static constexpr double kPeakAngle = LITFOG_FAR_PEAK_ANGLE;

  struct Range {
    int profile;
    int first;
    std::array<int, kSections> counts;  ///< a section has the first counts[section] lights; never increases
  };

  std::vector<std::int32_t> lights;  ///< indices i in SceneLights; -1 - i: what it scatters once is not wanted
  std::vector<Range> ranges;
  double visible_step = 0;  ///< of the display, linear (hidden_range.h)
  double depth = 0;         ///< metres from the eye, beyond which nothing visible is added; at most kSkyDistance

  /// Where a section begins without layers, and where the last one ends: metres from the eye. Sections grow with the
  /// distance. In layers all sections have all lights.
  double section_begin(int section) const { return depth * section * section / (kSections * kSections); }
};

/// Leaves out at most kFarShare of a step of the display in any pixel of what lights without shafts add beyond their
/// extents. Lights that cut shafts end at their extents in the fog.
///
/// exposure       EV at which the picture is shown
/// higher_orders  of the lights
/// casters        of each light: at least 0 if it cuts shafts; empty: none does
/// beyond_extents whether lights without shafts light the fog beyond their extents
FarAirlightList list_far_airlight(const SceneLights& lights, const Atmosphere& atmosphere, const glm::dvec3& eye,
                                  double exposure, const HigherOrders& higher_orders = {},
                                  std::span<const std::int32_t> casters = {}, bool beyond_extents = true);

}  // namespace litfog::render
