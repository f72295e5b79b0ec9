// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "litfog/atmosphere.h"
#include "litfog/cone.h"
#include "litfog/value_error.h"

namespace litfog {

struct ScatteringTable;

// How the light of a cone is spread in fog that scatters it in all orders, compared with that of a point lamp.
//
// The light that a thin beam sends to a place, over all directions there, is what an eye in the lamp that looks along
// the beam would receive from a point lamp at that place (reciprocity: Kenneth Case 1957, "Transfer Problems and the
// Reciprocity Principle"), which airlight() and scattered_at() know. A cone is a sum of thin beams. From where that
// light arrives on average is a guess, fitted to random walks: as from a point on the beam at kApparentStart of the
// place's distance from the lamp.

inline constexpr int kBeamOrders = 48;  ///< Legendre polynomials of an angular shape
inline constexpr int kBeamDepths = 16;  ///< from 0.02 to 12
inline constexpr int kBeamAngles = 24;  ///< from the axis to its opposite
inline constexpr double kApparentStart = 0.6;

/// The mean over all directions of a light's angular shape times each Legendre polynomial of the cosine to the axis:
/// the first is the flux of the shape over that of a point lamp, the second that times the mean cosine.
using BeamMoments = std::array<double, kBeamOrders>;

/// throws  std::invalid_argument naming field, value and rule
BeamMoments beam_moments(const Cone& cone);

/// Moments of the light of a thin beam that has been scattered once or more often, at depths from its lamp.
struct ThinBeams {
  struct Row {
    BeamMoments share;   ///< of the light from all directions
    BeamMoments radial;  ///< of its flow away from the lamp
    BeamMoments turned;  ///< of what its flow away from the beam is the gradient of
    double forward = 0;  ///< mean cosine between light of a point lamp and the direction away from it
  };
  std::array<Row, kBeamDepths> rows;
};

/// What is wrong with thin beams, or nothing: moments are at most 1000 in magnitude, `forward` is in (0, 1].
std::optional<ValueError> find_error(const ThinBeams& beams);

/// table   that of the atmosphere
/// throws  std::invalid_argument naming field, value and rule
ThinBeams make_thin_beams(const Atmosphere& atmosphere, const ScatteringTable& table);

/// The light of a cone that has been scattered once or more often, at depths and angles to its axis, over that of a
/// point lamp. It is for shaders, as a texture (litfog/shaders/multiple_scattering.glsl).
struct ScatteredBeam {
  struct Texel {
    float share;    ///< of the light from all directions
    float radial;   ///< flow away from the lamp
    float turned;   ///< flow away from the axis, over the point lamp's away from it
    float forward;  ///< the point lamp's flow over its light
  };
  std::array<std::array<Texel, kBeamAngles>, kBeamDepths> texels;
};

ScatteredBeam make_scattered_beam(const BeamMoments& moments, const ThinBeams& beams);

}  // namespace litfog
