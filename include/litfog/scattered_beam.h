// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "litfog/atmosphere.h"
#include "litfog/cone.h"
#include "litfog/value_error.h"

namespace litfog {

struct ScatteringTable;

// How fog that scatters in all orders distributes a cone's light, compared with a point lamp's.
//
// The light that a thin beam sends to a point, summed over directions, is what an eye at the lamp that looks along the
// beam would receive from a point lamp at that point (reciprocity: Kenneth Case 1957, "Transfer Problems and the
// Reciprocity Principle"). airlight() and scattered_at() compute it. A cone is a sum of thin beams. The mean direction
// from which that light arrives is a guess fitted to random walks: it comes from a point on the beam, at the fraction
// kApparentStart of the distance from lamp to point.

inline constexpr int kBeamOrders = 48;  ///< Legendre polynomials per angular shape
inline constexpr int kBeamDepths = 16;  ///< from 0.02 to 12
inline constexpr int kBeamAngles = 24;  ///< from the axis to its opposite
inline constexpr double kApparentStart = 0.6;

/// The mean over all directions of a light's angular shape times each Legendre polynomial of the cosine to the axis.
/// The first is the shape's flux over a point lamp's, the second is the first times the mean cosine.
using BeamMoments = std::array<double, kBeamOrders>;

/// throws  std::invalid_argument naming field, value and rule
BeamMoments beam_moments(const Cone& cone);

/// Moments of a thin beam's light that has been scattered at least once, by optical depth from its lamp.
struct ThinBeams {
  struct Row {
    BeamMoments share;   ///< the light from all directions
    BeamMoments radial;  ///< its flow away from the lamp
    BeamMoments turned;  ///< the function whose gradient is its flow away from the beam
    double forward = 0;  ///< mean cosine between a point lamp's light and the direction away from it
  };
  std::array<Row, kBeamDepths> rows;
};

/// What is wrong with thin beams, or nothing: moments are at most 1000 in magnitude, `forward` is in (0, 1].
std::optional<ValueError> find_error(const ThinBeams& beams);

/// table   made for the atmosphere
/// throws  std::invalid_argument naming field, value and rule
ThinBeams make_thin_beams(const Atmosphere& atmosphere, const ScatteringTable& table);

/// A cone's light that has been scattered at least once, over a point lamp's, by optical depth and angle to the axis.
/// Shaders read it as a texture (litfog/shaders/multiple_scattering.glsl).
struct ScatteredBeam {
  struct Texel {
    float share;    ///< the light from all directions
    float radial;   ///< the flow away from the lamp
    float turned;   ///< the flow away from the axis, over the point lamp's flow away from the lamp
    float forward;  ///< the point lamp's flow over its light
  };
  std::array<std::array<Texel, kBeamAngles>, kBeamDepths> texels;
};

ScatteredBeam make_scattered_beam(const BeamMoments& moments, const ThinBeams& beams);

}  // namespace litfog
