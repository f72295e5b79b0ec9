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
#include "litfog/scattered_beam.h"
#include "litfog/solve.h"
#include "litfog/updater.h"
#include "litfog/view_frustum.h"

namespace litfog::c {

/// Maps a C struct to the C++ struct with the same members at the same offsets; other structs have none.
template <typename C>
struct Counterpart;

#define LITFOG_COUNTERPART(C, Cpp, ...)                                                                      \
  template <>                                                                                                \
  struct Counterpart<C> {                                                                                    \
    using type = Cpp;                                                                                        \
  };                                                                                                         \
  static_assert(sizeof(C) == sizeof(Cpp) && alignof(C) == alignof(Cpp) && std::is_trivially_copyable_v<C> && \
                std::is_trivially_copyable_v<Cpp>);                                                          \
  LITFOG_MEMBERS(C, Cpp, __VA_ARGS__)
// Asserts the first member and names itself for the others, which each scan by LITFOG_ONCE expands once more. A member
// beyond what the scans reach would leave LITFOG_NEXT, which does not compile.
#define LITFOG_MEMBERS(...) LITFOG_AGAIN(LITFOG_AGAIN(LITFOG_MEMBER(__VA_ARGS__)))
#define LITFOG_AGAIN(...) LITFOG_ONCE(LITFOG_ONCE(LITFOG_ONCE(LITFOG_ONCE(__VA_ARGS__))))
#define LITFOG_ONCE(...) __VA_ARGS__
#define LITFOG_MEMBER(C, Cpp, member, ...)                                                                \
  static_assert(offsetof(C, member) == offsetof(Cpp, member) && sizeof(C::member) == sizeof(Cpp::member)) \
      __VA_OPT__(; LITFOG_NEXT LITFOG_NO_MORE()()(C, Cpp, __VA_ARGS__))
#define LITFOG_NEXT() LITFOG_MEMBER
#define LITFOG_NO_MORE()

LITFOG_COUNTERPART(litfog_fog, Fog, mode, density);
LITFOG_COUNTERPART(litfog_attenuation, Attenuation, constant, linear, quadratic);
LITFOG_COUNTERPART(litfog_cone, Cone, profile, half_angle, exponent, inner, outer);
LITFOG_COUNTERPART(litfog_single_flash, SingleFlash, start, duration, intensity);
LITFOG_COUNTERPART(litfog_flash, Flash, period, count, flashes);
LITFOG_COUNTERPART(litfog_fog_intensity, FogIntensity, intensity, peak_range, extent, status);
LITFOG_COUNTERPART(litfog_phase_lobe, PhaseLobe, asymmetry, alpha);
LITFOG_COUNTERPART(litfog_phase, Phase, first, second, weight);
LITFOG_COUNTERPART(litfog_density_knot, DensityKnot, height, density);
LITFOG_COUNTERPART(litfog_density_profile, DensityProfile, knots, count);
LITFOG_COUNTERPART(litfog_fog_layer, FogLayer, base, top, transition, visibility);
LITFOG_COUNTERPART(litfog_atmosphere, Atmosphere, fog, phase, albedo, top, ambient_fog_color, profile);
LITFOG_COUNTERPART(litfog_eye_ray, EyeRay, origin, direction, length);
LITFOG_COUNTERPART(litfog_scattering_table, ScatteringTable, logs);
LITFOG_COUNTERPART(litfog_thin_beam, ThinBeams::Row, share, radial, turned, forward);
LITFOG_COUNTERPART(litfog_thin_beams, ThinBeams, rows);
LITFOG_COUNTERPART(litfog_scattered_beam, ScatteredBeam, texels);
LITFOG_COUNTERPART(litfog_diffuse_light, DiffuseLight, all, flow);
LITFOG_COUNTERPART(litfog_fog_light_kind, FogLightKind, attenuation_extent, cone_scale_intensity);
LITFOG_COUNTERPART(litfog_fog_light_instance, FogLightInstance, position_kind, axis_profile, color);
LITFOG_COUNTERPART(litfog_fog_header, FogHeader, fog, ambient_fog_color, phase_lobes, density_knots);
LITFOG_COUNTERPART(litfog_fog_light_block, FogLightBlock, header, kinds, instances);
LITFOG_COUNTERPART(litfog_fog_light_source, FogLightSource, intensity, soft_range);
LITFOG_COUNTERPART(litfog_light_handle, FogLightHandle, slot, generation);
LITFOG_COUNTERPART(litfog_entry_range, EntryRange, begin, end);
LITFOG_COUNTERPART(litfog_fog_update_statistics, FogUpdateStatistics, kinds_solved, kinds_skipped, lights_skipped,
                   bytes_dirty, sources_solved);
LITFOG_COUNTERPART(litfog_light_bounds, LightBounds, position, direction, range, half_angle);
LITFOG_COUNTERPART(litfog_view, View, eye, forward, up, left, right, bottom, top, nearest, farthest);
LITFOG_COUNTERPART(litfog_cluster_grid, ClusterGrid, columns, rows, slices, first_depth);
LITFOG_COUNTERPART(litfog_cluster, Cluster, first, count);

#undef LITFOG_COUNTERPART
#undef LITFOG_MEMBERS
#undef LITFOG_AGAIN
#undef LITFOG_ONCE
#undef LITFOG_MEMBER
#undef LITFOG_NEXT
#undef LITFOG_NO_MORE

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
              LITFOG_SCATTERING_ANGLES == kScatteringAngles && LITFOG_BEAM_ORDERS == kBeamOrders &&
              LITFOG_BEAM_DEPTHS == kBeamDepths && LITFOG_BEAM_ANGLES == kBeamAngles &&
              LITFOG_DEFAULT_SKIP_BUDGET_255 == kDefaultSkipBudget255);

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
