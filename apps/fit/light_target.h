// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "litfog/files/light_spec_file.h"
#include "litfog/fit/attenuation_fit.h"
#include "litfog/fit/cone_fit.h"
#include "litfog/photometry/luminaire.h"

namespace litfog::fit {

/// Asymmetry up to which a beam is taken for a round one.
inline constexpr double kRoundBeam = 0.1;

/// Source radius in metres of a light for which none is stated.
inline constexpr double kDefaultSourceRadius = 0.05;

/// Texels along a cookie's edge if --cookie-size does not state them.
inline constexpr int kUnstatedCookieSize = 256;

/// Which direction of a luminaire is the axis of its light.
struct AxisChoice {
  enum class Kind {
    best,   ///< down, or up where the peak lies above the horizon; the peak where a beam is aimed elsewhere
    peak,   ///< the largest intensity
    down,   ///< the photometric axis: the nadir in type C, H = V = 0 in types A and B
    up,     ///< its opposite
    given,  ///< horizontal and vertical
  };
  Kind kind = Kind::best;
  double horizontal = 0;  ///< radians, in the file's own angles
  double vertical = 0;
};

/// What the fit is asked for besides what the file states.
struct FitChoices {
  /// Replaces the file's own; nothing within is the best of all.
  std::optional<std::optional<ConeProfile>> profile = std::nullopt;
  AxisChoice axis = {};
  double tilt = 0;         ///< radians, by which a luminaire with tilt data is tilted as it is mounted
  int cookie_size = 0;     ///< texels along an edge of the cookie that replaces the light's cone; 0: none
  bool has_spill = false;  ///< the beam's spill becomes a light of its own
  bool is_robust = false;  ///< outliers of a falloff table count less
};

/// A line of equal intensity of an elliptical beam, by its full angles.
struct BeamEllipse {
  double level;  ///< fraction of the peak
  FullAngles angles;
};

/// A light that is to be fitted, from a light-spec file (litfog/files/light_spec_file.h) or a photometric file.
struct LightTarget {
  std::string file = {};
  std::string name = {};
  std::vector<std::string> source = {};
  std::vector<std::string> derived = {};  ///< how figures were made of the file's, a step each
  glm::dvec3 color{1.0};
  double size = 1;  ///< the light's colour is `color` times this
  double density_scale = 1;
  std::optional<double> source_radius = std::nullopt;  ///< metres, as stated
  double opening_radius = 0;                           ///< metres, of a luminaire's opening; 0: not known
  InputLocation source_radius_location = {};           ///< where it is stated
  Flash flash = {};
  std::optional<AttenuationTarget> range = std::nullopt;
  std::optional<double> peak = std::nullopt;  ///< candela, the beam's largest, stated or derived
  /// Candela, the light's own where its cone or its cookie is 1: its size and extent follow from this. The cone of a
  /// luminaire is fitted to means over the turn, so that it has their largest; a cookie has the beam's. Nothing where
  /// the extent is stated.
  std::optional<double> light_peak = std::nullopt;
  std::vector<RangeSpec::Illuminance> illuminance = {};  ///< where the beam is brightest, as stated
  std::optional<double> end_illuminance = std::nullopt;  ///< lx, from which the extent follows, if it does
  std::optional<double> flux = std::nullopt;             ///< lumens, as stated
  /// With the luminaire's profile about the axis as its samples, if there is a luminaire. With the circles of equal
  /// solid angle as its angles, if those are an elliptical beam's.
  std::optional<ConeTarget> cone = std::nullopt;
  std::vector<BeamEllipse> ellipses = {};  ///< elliptical beam, from the inner ellipse to the outer
  std::optional<Luminaire> luminaire = std::nullopt;
  IntensityPeak luminaire_peak = {};   ///< if there is a luminaire
  glm::dvec3 axis = kPhotometricAxis;  ///< the light's, in the luminaire frame; unit
  double asymmetry = 0;                ///< the luminaire's or elliptical beam's, about `axis`
  int cookie_size = 0;                 ///< as chosen
};

/// Reads a light-spec file and the photometric file that it names. Throws InputError, also for what the fits do not
/// take.
LightTarget read_spec(const std::string& path, const FitChoices& choices = {});

/// Reads a photometric file: the beam about its axis, white, with C = 1, L = 0 and the extent where the light's peak
/// gives 1 lx. Throws InputError, also for what the fits do not take.
LightTarget read_photometric_spec(const std::string& path, const FitChoices& choices = {});

/// The target of a luminaire that was read already.
///
/// path  path of its file
LightTarget target_of(Luminaire stated, const std::string& path, const FitChoices& choices = {});

/// A part of a luminaire's beam as a light of its own, which ends where it gives the same illuminance as the whole.
///
/// whole  a target with a luminaire and an end_illuminance
/// what   names the part
/// cone   candela, of the part
LightTarget part_of(const LightTarget& whole, const std::string& what, ConeTarget cone);

/// Whether a luminaire's photometric axis points down, as in files of type C, and not ahead.
bool hangs(const Luminaire& luminaire);

/// A luminaire's axis in words, as --axis takes it: "down, the photometric axis", "up, opposite to the photometric
/// axis", of one that does not hang "ahead" and "behind", or "40 deg from the photometric axis, --axis 0,40" in the
/// file's angles.
std::string describe_axis(const Luminaire& luminaire, const glm::dvec3& axis);

}  // namespace litfog::fit
