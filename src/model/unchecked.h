// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/attenuation.h"
#include "litfog/fog.h"
#include "litfog/fog_light_block.h"
#include "litfog/light.h"
#include "litfog/solve.h"

// The public calls of the same names for arguments that have passed find_error(). Internal: a call checks what it is
// given once, at its edge, and uses these from there on.

namespace litfog::unchecked {

/// What a ScatteringSource has of a light with an attenuation whose class sees a fog.
struct PointSource {
  double intensity = 0, soft_range = 0;
};
PointSource point_source(const Attenuation& attenuation, const Fog& seen_fog, double phase_cosine);
double compute_extent(const Attenuation& attenuation, double threshold);
Fog scaled(const Fog& fog, double density_scale);
FogIntensity solve_fog_intensity(const Attenuation& attenuation, const Fog& fog, double threshold);
FogLightKind pack_fog_light_kind(const PlacedLight& light, const FogIntensity& solution);
FogLightInstance pack_fog_light_instance(const PlacedLight& light, std::size_t kind);

}  // namespace litfog::unchecked
