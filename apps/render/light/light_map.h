// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "litfog/attenuation.h"
#include "litfog/cone.h"
#include "litfog/photometry/cookie.h"
#include "render/plan/paper_settings.h"

namespace litfog::render {

// The texels of the light maps: 16-bit fractions, x running fastest, then y, then z or the face. Texel i of `size` is
// at the coordinate i / (size - 1), as in Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs": the
// first texel is at 0 and the last at 1.
using MapTexels = std::vector<std::uint16_t>;

/// Range attenuation over a fraction of the extent E: its three parameters scaled by powers of E. Lights with equal
/// profiles share a range map, because the map's coordinates are also fractions of E.
struct RangeProfile {
  float constant;
  float linear;     ///< L E
  float quadratic;  ///< Q E^2

  auto operator<=>(const RangeProfile&) const = default;
};
/// extent  metres; infinite where the attenuation is constant
RangeProfile range_profile(const Attenuation& attenuation, double extent);

/// 3-D range map over (s, t, r) = 0.5 + P / (2 E), where P is the vector from the light. It is 0 beyond the extent and
/// at its boundaries (Hales 2004, "Embedding Range Attenuation in a Texture Map", where R2 > E means R > E).
MapTexels make_range_volume(const RangeProfile& profile, int size);

/// The pair of 2-D maps that replaces the 3-D map (same section): q = 0.5 + |(Px, Py)| / (2 E) over (s, t), clamped to
/// 1, and the attenuation over (q, r), which is 0 beyond the extent and at the boundaries.
MapTexels make_distance_map(int size);
MapTexels make_range_map(const RangeProfile& profile, int size);
/// The side of a pair of 2-D maps with as many texels as a 3-D map: 1024 for 128.
int pair_size(int volume_size);

/// x^2 + y^2 over (s, t) and z^2 over r. Coordinates are 0.5 + P / (2 R), squares are of P / R and clamped to 1 (Ronald
/// Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL", section "Calculating Attenuation").
MapTexels make_square_map(int size);
MapTexels make_square_ramp(int size);

/// The direction of a light's axis in its cube map.
enum class CubeAxis {
  plus_x,   ///< Hales
  minus_z,  ///< Frazier
};

/// Whether a cone's map is scaled by tan(90 deg - half angle), so that the cone spans the axis's face and the other
/// faces are dark (Hales: a; Frazier: scaleFactor). Otherwise the map has scale 1 and extends over all faces.
///
/// The papers scale every cone below 90 degrees and have no wider cones. The texels at the middle of a scaled map are 2
/// tan(half angle) / (size - 1) apart. At a size of 128 that is 1.6 degrees for a cone of 60 degrees, 5 for 80 degrees,
/// and 49 for 89 degrees, where the map's middle is lost (light_map_test.cpp). ConeMaps::even scales only up to 60
/// degrees.
bool is_scaled(const Cone& cone, ConeMaps maps);

/// The scale of the coordinates across the axis in a cone's cube map.
double cone_map_scale(const Cone& cone, ConeMaps maps);

/// The cone that a cone's cube map holds. For ConeMaps::one_disc it is a disc, whatever the cone's profile, because
/// Frazier has one map for every angle.
Cone mapped_cone(const Cone& cone, ConeMaps maps);

/// Six faces in OpenGL's order: +x -x +y -y +z -z.
MapTexels make_cone_cube(const Cone& cone, CubeAxis axis, int size, ConeMaps maps);

/// The six faces of a cookie, unscaled.
MapTexels make_cookie_cube(const Cookie& cookie);

/// The factor of the coordinates across the axis in look-ups: the map's scale. A scale other than 1 is reduced by half
/// a texel at each end of a face, because in OpenGL texel i is at (i + 0.5) / size.
double cone_coordinate_scale(const Cone& cone, int size, ConeMaps maps);

}  // namespace litfog::render
