// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "litfog/fog.h"
#include "litfog/value_error.h"

namespace litfog {

/// Density of fog at a height.
template <typename Real>
struct BasicDensityKnot {
  Real height = 0;   ///< metres, at most 16777216 in magnitude
  Real density = 0;  ///< 1/m, [0, 1e300]

  friend bool operator==(const BasicDensityKnot&, const BasicDensityKnot&) = default;
};
using DensityKnot = BasicDensityKnot<double>;

inline constexpr std::size_t kMaxDensityKnots = 8;

/// Density of exp fog over height: linear between knots, constant below the first and above the last. Without knots it
/// is 0. Only the functions below, and litfog/shaders/density_profile.glsl, whose text they share, know its shape.
template <typename Real>
struct BasicDensityProfile {
  std::array<BasicDensityKnot<Real>, kMaxDensityKnots> knots{};  ///< heights strictly rise; unused knots are 0
  std::size_t count = 0;                                         ///< knots in use, at most kMaxDensityKnots

  friend bool operator==(const BasicDensityProfile&, const BasicDensityProfile&) = default;

  std::span<const BasicDensityKnot<Real>> used() const { return std::span(knots).first(count); }
};
using DensityProfile = BasicDensityProfile<double>;
using DensityProfileF = BasicDensityProfile<float>;

/// The profile through some knots.
///
/// throws  std::invalid_argument naming field, value and rule
DensityProfile make_density_profile(std::span<const DensityKnot> knots);

/// What is wrong with a profile, or nothing. The functions below need a profile that passes.
std::optional<ValueError> find_error(const DensityProfile& profile);

/// A layer of fog, as Weather Control of the Common Image Generator Interface states it. The visibility gives the
/// density within the layer. The transition bands lie outside it, below the base and above the top; there the density
/// falls linearly to 0. (A vendor's description puts bands above or below a layer. The interface control document was
/// not available, and the linear fall is litfog's choice.) Finite heights, bands included, are at most 16777216 in
/// magnitude.
struct FogLayer {
  double base = -std::numeric_limits<double>::infinity();  ///< metres; -infinity: no base
  double top = std::numeric_limits<double>::infinity();    ///< metres, above the base; infinity: no top
  double transition = 0;  ///< metres, finite, >= 0: height of each band; at least kSharpestTransition is used
  double visibility = std::numeric_limits<double>::infinity();  ///< metres, >= kLeastLayerVisibility; infinity: no fog

  friend bool operator==(const FogLayer&, const FogLayer&) = default;
};

/// Smallest height in metres of a transition band's ramp.
inline constexpr double kSharpestTransition = 0.01;

/// Metres: with any contrast, a sum of layers this dense is within the range of a knot's density.
inline constexpr double kLeastLayerVisibility = 1e-290;

/// What is wrong with a layer, or nothing.
std::optional<ValueError> find_error(const FogLayer& layer);

/// The profile of layers, which add up where they overlap. A layer without base or top needs 2 knots, any other 4.
///
/// contrast  of the layers' visibilities, (0, 1)
/// throws    std::invalid_argument naming field, value and rule; also if more than kMaxDensityKnots are needed
DensityProfile make_density_profile(std::span<const FogLayer> layers, double contrast = kContrastMor);

/// Density at a height in metres, which may be infinite.
double profile_density_at(const DensityProfile& profile, double height);

/// Largest relative error of mean_density and optical_depth for densities that are 0 or at least 1e-250.
inline constexpr double kMeanDensityMaxError = 2e-15;

/// Mean density between two heights, in either order, along any straight line from one to the other. At equal heights
/// it is the density there, which is also the limit.
///
/// height_a, height_b  metres, finite; those less than 1e-30 apart count as equal. The rise from one to the other, and
///                     that times the largest density, at most 1e300
/// max error           kMeanDensityMaxError relative                               (density_profile_test.cpp)
double mean_density(const DensityProfile& profile, double height_a, double height_b);

/// Optical depth of a straight line between two heights.
///
/// length     metres, >= 0, finite
/// max error  kMeanDensityMaxError relative, plus one rounding                     (density_profile_test.cpp)
double optical_depth(const DensityProfile& profile, double height_a, double height_b, double length);

/// Optical depth of an endless ray.
///
/// height   of the ray's origin, metres, finite
/// slope    sine of its elevation, [-1, 1]
/// returns  infinity where the ray ends in fog or stays in it
double optical_depth_to_sky(const DensityProfile& profile, double height, double slope);

/// Largest and smallest density between two heights, lowest <= highest, which may be infinite. For bounds.
double largest_density(const DensityProfile& profile, double lowest = -std::numeric_limits<double>::infinity(),
                       double highest = std::numeric_limits<double>::infinity());
double smallest_density(const DensityProfile& profile, double lowest = -std::numeric_limits<double>::infinity(),
                        double highest = std::numeric_limits<double>::infinity());

/// Least mean density, 1/m, between `height` and any height from lowest to highest, lowest <= highest, which may be
/// infinite. For bounds: a straight line between two such points has at least this optical depth per metre, except for
/// the fraction 1e-14. (density_profile_test.cpp)
///
/// height  metres, finite
double least_mean_density(const DensityProfile& profile, double height, double lowest, double highest);

/// The profile for a class of lights: each density times the class's scale, which is finite and >= 0.
DensityProfile scaled(const DensityProfile& profile, double density_scale);

/// Largest density of the shaders' knots, 1/m. Its product with any height in metres is finite in floats.
inline constexpr float kMaxKnotDensity = 1e30f;

/// The profile in floats, for shaders. Denser knots become kMaxKnotDensity. Knots whose heights round to one float
/// stay, as a step.
DensityProfileF to_floats(const DensityProfile& profile);

}  // namespace litfog
