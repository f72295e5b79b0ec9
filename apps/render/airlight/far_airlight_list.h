// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "litfog/airlight.h"
#include "litfog/fog.h"
#include "render/light/scene_lights.h"

namespace litfog::render {

/// The lights whose airlight beyond their extents a picture shows: those of one profile (FogLightInstance) lie
/// together. A ray is cut into sections, of which those far from the eye need fewer lights.
struct FarAirlightList {
  static constexpr int kSections = 4;

  struct Range {
    int profile;
    int first;
    std::array<int, kSections> counts;  ///< of each section the first so many; never more than of the one before
  };

  std::vector<std::int32_t> lights;  ///< of SceneLights
  std::vector<Range> ranges;
  double depth = 0;  ///< metres from the eye, beyond which they add nothing that is visible; at most kSkyDistance

  /// Where a section begins, and where the last one ends: metres from the eye. Sections grow with the distance.
  double section_begin(int section) const { return depth * section * section / (kSections * kSections); }
};

/// Of what lights without shafts add beyond their extents, at most kFarShare of a step of the display is left out in
/// any pixel. Lights that cut shafts end at their extents in the fog.
///
/// Proof. Of a ray from a distance S from the eye on, let R be the larger of the light's extent and S - L, L being the
/// distance from the eye to the light. There, beyond the extent, r >= R. The weights -f'(s) of the eye's leg sum to at
/// most f(S). So the light adds at most c a(R) f(R) f(S), c being its colour times the phase function, both where they
/// are largest. Where -f'(s) f(r) is at most w, it also adds at most c w pi / (Q R): a(r) <= 1 / (Q r^2), and the
/// integral of 1 / r^2 over what is outside the ball of radius R is largest on the line that touches it. In exp fog w
/// is d e^(-d X), with X the larger of L and S + R. In exp2 fog it is 1.2131 d e^(-d^2 Y), with Y the larger of L^2 / 3
/// and S^2 / 2 + R^2 (litfog/shaders/glow.glsl).
///
/// exposure  EV at which the picture is shown
/// casters   of each light: at least 0 if it cuts shafts; empty: none does
FarAirlightList list_far_airlight(const SceneLights& lights, const Fog& fog, const Scattering& scattering,
                                  const glm::dvec3& eye, double exposure, std::span<const std::int32_t> casters = {});

}  // namespace litfog::render
