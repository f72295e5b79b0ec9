// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <span>
#include <type_traits>

#include "litfog/airlight.h"
#include "litfog/atmosphere.h"
#include "litfog/batch.h"
#include "litfog/c/litfog.h"
#include "litfog/cone.h"
#include "litfog/density_profile.h"
#include "litfog/fog.h"
#include "litfog/fog_light_block.h"
#include "litfog/light.h"
#include "litfog/light_bounds.h"
#include "litfog/light_clusters.h"
#include "litfog/multiple_scattering.h"
#include "litfog/solve.h"
#include "litfog/updater.h"
#include "litfog/view_frustum.h"

namespace litfog::c {

/// Maps a C struct to the C++ struct with the same members at the same offsets; other structs have none.
template <typename C>
struct Counterpart;

#define LITFOG_COUNTERPART(C, Cpp)                                                                           \
  template <>                                                                                                \
  struct Counterpart<C> {                                                                                    \
    using type = Cpp;                                                                                        \
  };                                                                                                         \
  static_assert(sizeof(C) == sizeof(Cpp) && alignof(C) == alignof(Cpp) && std::is_trivially_copyable_v<C> && \
                std::is_trivially_copyable_v<Cpp>)
#define LITFOG_MEMBER(C, Cpp, member) \
  static_assert(offsetof(C, member) == offsetof(Cpp, member) && sizeof(C::member) == sizeof(Cpp::member))

LITFOG_COUNTERPART(litfog_fog, Fog);
LITFOG_MEMBER(litfog_fog, Fog, mode);
LITFOG_MEMBER(litfog_fog, Fog, density);

LITFOG_COUNTERPART(litfog_attenuation, Attenuation);
LITFOG_MEMBER(litfog_attenuation, Attenuation, constant);
LITFOG_MEMBER(litfog_attenuation, Attenuation, linear);
LITFOG_MEMBER(litfog_attenuation, Attenuation, quadratic);

LITFOG_COUNTERPART(litfog_cone, Cone);
LITFOG_MEMBER(litfog_cone, Cone, profile);
LITFOG_MEMBER(litfog_cone, Cone, half_angle);
LITFOG_MEMBER(litfog_cone, Cone, exponent);
LITFOG_MEMBER(litfog_cone, Cone, inner);
LITFOG_MEMBER(litfog_cone, Cone, outer);

LITFOG_COUNTERPART(litfog_single_flash, SingleFlash);
LITFOG_MEMBER(litfog_single_flash, SingleFlash, start);
LITFOG_MEMBER(litfog_single_flash, SingleFlash, duration);
LITFOG_MEMBER(litfog_single_flash, SingleFlash, intensity);

LITFOG_COUNTERPART(litfog_flash, Flash);
LITFOG_MEMBER(litfog_flash, Flash, period);
LITFOG_MEMBER(litfog_flash, Flash, count);
LITFOG_MEMBER(litfog_flash, Flash, flashes);

LITFOG_COUNTERPART(litfog_fog_intensity, FogIntensity);
LITFOG_MEMBER(litfog_fog_intensity, FogIntensity, intensity);
LITFOG_MEMBER(litfog_fog_intensity, FogIntensity, peak_range);
LITFOG_MEMBER(litfog_fog_intensity, FogIntensity, extent);
LITFOG_MEMBER(litfog_fog_intensity, FogIntensity, status);

LITFOG_COUNTERPART(litfog_phase_lobe, PhaseLobe);
LITFOG_MEMBER(litfog_phase_lobe, PhaseLobe, asymmetry);
LITFOG_MEMBER(litfog_phase_lobe, PhaseLobe, alpha);

LITFOG_COUNTERPART(litfog_phase, Phase);
LITFOG_MEMBER(litfog_phase, Phase, first);
LITFOG_MEMBER(litfog_phase, Phase, second);
LITFOG_MEMBER(litfog_phase, Phase, weight);

LITFOG_COUNTERPART(litfog_density_knot, DensityKnot);
LITFOG_MEMBER(litfog_density_knot, DensityKnot, height);
LITFOG_MEMBER(litfog_density_knot, DensityKnot, density);

LITFOG_COUNTERPART(litfog_density_profile, DensityProfile);
LITFOG_MEMBER(litfog_density_profile, DensityProfile, knots);
LITFOG_MEMBER(litfog_density_profile, DensityProfile, count);

LITFOG_COUNTERPART(litfog_fog_layer, FogLayer);
LITFOG_MEMBER(litfog_fog_layer, FogLayer, base);
LITFOG_MEMBER(litfog_fog_layer, FogLayer, top);
LITFOG_MEMBER(litfog_fog_layer, FogLayer, transition);
LITFOG_MEMBER(litfog_fog_layer, FogLayer, visibility);

LITFOG_COUNTERPART(litfog_atmosphere, Atmosphere);
LITFOG_MEMBER(litfog_atmosphere, Atmosphere, fog);
LITFOG_MEMBER(litfog_atmosphere, Atmosphere, phase);
LITFOG_MEMBER(litfog_atmosphere, Atmosphere, albedo);
LITFOG_MEMBER(litfog_atmosphere, Atmosphere, top);
LITFOG_MEMBER(litfog_atmosphere, Atmosphere, ambient_fog_color);
LITFOG_MEMBER(litfog_atmosphere, Atmosphere, profile);

LITFOG_COUNTERPART(litfog_eye_ray, EyeRay);
LITFOG_MEMBER(litfog_eye_ray, EyeRay, origin);
LITFOG_MEMBER(litfog_eye_ray, EyeRay, direction);
LITFOG_MEMBER(litfog_eye_ray, EyeRay, length);

LITFOG_COUNTERPART(litfog_scattering_table, ScatteringTable);
LITFOG_MEMBER(litfog_scattering_table, ScatteringTable, logs);

LITFOG_COUNTERPART(litfog_fog_light_kind, FogLightKind);
LITFOG_MEMBER(litfog_fog_light_kind, FogLightKind, attenuation_extent);
LITFOG_MEMBER(litfog_fog_light_kind, FogLightKind, cone_scale_intensity);

LITFOG_COUNTERPART(litfog_fog_light_instance, FogLightInstance);
LITFOG_MEMBER(litfog_fog_light_instance, FogLightInstance, position_kind);
LITFOG_MEMBER(litfog_fog_light_instance, FogLightInstance, axis_profile);
LITFOG_MEMBER(litfog_fog_light_instance, FogLightInstance, color);

LITFOG_COUNTERPART(litfog_fog_header, FogHeader);
LITFOG_MEMBER(litfog_fog_header, FogHeader, fog);
LITFOG_MEMBER(litfog_fog_header, FogHeader, ambient_fog_color);
LITFOG_MEMBER(litfog_fog_header, FogHeader, phase_lobes);
LITFOG_MEMBER(litfog_fog_header, FogHeader, density_knots);

LITFOG_COUNTERPART(litfog_fog_light_block, FogLightBlock);
LITFOG_MEMBER(litfog_fog_light_block, FogLightBlock, header);
LITFOG_MEMBER(litfog_fog_light_block, FogLightBlock, kinds);
LITFOG_MEMBER(litfog_fog_light_block, FogLightBlock, instances);

LITFOG_COUNTERPART(litfog_light_handle, FogLightHandle);
LITFOG_MEMBER(litfog_light_handle, FogLightHandle, slot);
LITFOG_MEMBER(litfog_light_handle, FogLightHandle, generation);

LITFOG_COUNTERPART(litfog_entry_range, EntryRange);
LITFOG_MEMBER(litfog_entry_range, EntryRange, begin);
LITFOG_MEMBER(litfog_entry_range, EntryRange, end);

LITFOG_COUNTERPART(litfog_fog_update_statistics, FogUpdateStatistics);
LITFOG_MEMBER(litfog_fog_update_statistics, FogUpdateStatistics, kinds_solved);
LITFOG_MEMBER(litfog_fog_update_statistics, FogUpdateStatistics, kinds_skipped);
LITFOG_MEMBER(litfog_fog_update_statistics, FogUpdateStatistics, lights_skipped);
LITFOG_MEMBER(litfog_fog_update_statistics, FogUpdateStatistics, bytes_dirty);

LITFOG_COUNTERPART(litfog_light_bounds, LightBounds);
LITFOG_MEMBER(litfog_light_bounds, LightBounds, position);
LITFOG_MEMBER(litfog_light_bounds, LightBounds, direction);
LITFOG_MEMBER(litfog_light_bounds, LightBounds, range);
LITFOG_MEMBER(litfog_light_bounds, LightBounds, half_angle);

LITFOG_COUNTERPART(litfog_view, View);
LITFOG_MEMBER(litfog_view, View, eye);
LITFOG_MEMBER(litfog_view, View, forward);
LITFOG_MEMBER(litfog_view, View, up);
LITFOG_MEMBER(litfog_view, View, left);
LITFOG_MEMBER(litfog_view, View, right);
LITFOG_MEMBER(litfog_view, View, bottom);
LITFOG_MEMBER(litfog_view, View, top);
LITFOG_MEMBER(litfog_view, View, nearest);
LITFOG_MEMBER(litfog_view, View, farthest);

LITFOG_COUNTERPART(litfog_cluster_grid, ClusterGrid);
LITFOG_MEMBER(litfog_cluster_grid, ClusterGrid, columns);
LITFOG_MEMBER(litfog_cluster_grid, ClusterGrid, rows);
LITFOG_MEMBER(litfog_cluster_grid, ClusterGrid, slices);
LITFOG_MEMBER(litfog_cluster_grid, ClusterGrid, first_depth);

LITFOG_COUNTERPART(litfog_cluster, Cluster);
LITFOG_MEMBER(litfog_cluster, Cluster, first);
LITFOG_MEMBER(litfog_cluster, Cluster, count);

#undef LITFOG_COUNTERPART
#undef LITFOG_MEMBER

/// Enumerators are the same numbers, constants the same values.
template <typename Enum>
constexpr bool is_same(int c, Enum cpp) {
  return c == int(cpp);
}
static_assert(is_same(LITFOG_FOG_EXP, FogMode::exp) && is_same(LITFOG_FOG_EXP2, FogMode::exp2));
static_assert(is_same(LITFOG_CONE_NONE, ConeProfile::none) && is_same(LITFOG_CONE_COSINE, ConeProfile::cosine) &&
              is_same(LITFOG_CONE_SMOOTHSTEP, ConeProfile::smoothstep) &&
              kConeProfiles.size() == LITFOG_CONE_SMOOTHSTEP + 1);
static_assert(is_same(LITFOG_SOLVE_OK, SolveStatus::ok) &&
              is_same(LITFOG_SOLVE_NOT_CONVERGED, SolveStatus::not_converged));
static_assert(is_same(LITFOG_SOLVE_OK, BatchStatus::ok) &&
              is_same(LITFOG_SOLVE_NOT_CONVERGED, BatchStatus::not_converged) &&
              is_same(LITFOG_SOLVE_INVALID, BatchStatus::invalid) && sizeof(BatchStatus) == 1);
static_assert(is_same(LITFOG_LAMP_LEG_CLEAR, LampLeg::clear) && is_same(LITFOG_LAMP_LEG_FOGGED, LampLeg::fogged));
static_assert(LITFOG_CONTRAST_MOR == kContrastMor && LITFOG_CONTRAST_KOSCHMIEDER == kContrastKoschmieder &&
              LITFOG_CONTRAST_FLIGHTGEAR == kContrastFlightgear && LITFOG_DEFAULT_THRESHOLD == kDefaultThreshold &&
              LITFOG_MAX_POSITION == kMaxPosition && LITFOG_DIRECTION_TOLERANCE == kDirectionTolerance &&
              LITFOG_MAX_FLASHES == kMaxFlashes && LITFOG_MAX_FOG_LIGHTS == kMaxFogLights &&
              LITFOG_MAX_DENSITY_KNOTS == kMaxDensityKnots && LITFOG_SCATTERING_DEPTHS == kScatteringDepths &&
              LITFOG_SCATTERING_ANGLES == kScatteringAngles && LITFOG_DEFAULT_SKIP_BUDGET_255 == kDefaultSkipBudget255);

/// A C struct as its C++ counterpart. Its enumerators are not checked here (c/convert.h).
template <typename C>
auto to_cpp(const C& c) {
  return std::bit_cast<typename Counterpart<C>::type>(c);
}

/// A C++ struct as a C struct of the same layout.
template <typename C>
C to_c(const typename Counterpart<C>::type& cpp) {
  return std::bit_cast<C>(cpp);
}

/// A table of C++ structs viewed as C structs, without a copy.
template <typename C>
const C* view_as(std::span<const typename Counterpart<C>::type> table) {
  return reinterpret_cast<const C*>(table.data());
}

/// A table of C structs viewed as C++ structs, without a copy.
template <typename C>
std::span<const typename Counterpart<C>::type> view_as_cpp(std::span<const C> table) {
  return {reinterpret_cast<const typename Counterpart<C>::type*>(table.data()), table.size()};
}

}  // namespace litfog::c
