// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fit/light_target.h"
#include "litfog/light.h"
#include "litfog/photometry/cookie.h"

namespace litfog::fit {

/// The stated illuminance that a light is farthest from.
struct IlluminanceError {
  double range;  ///< metres
  double error;  ///< the light's lux over the stated, minus 1
};

/// A light made from its spec, with all that is known of the fits.
struct LightFit {
  LightTarget target;
  std::optional<AttenuationFit> range;  ///< without a target the attenuation is 1 everywhere
  std::optional<ConeFit> cone;          ///< without a target it is a point light
  Light light;

  std::optional<IntensityDistribution> elliptical_beam;  ///< if the target has ellipses
  /// The measured or elliptical beam that the cone stands for, which a cookie keeps; nothing where the cone is all.
  const IntensityDistribution* beam() const;
  double peak_angle = 0;         ///< photometric file: radians from the axis to the largest intensity
  std::optional<Cookie> cookie;  ///< the beam, replaces the cone if the target chooses so
  /// Candela of the light as it is written, where its cone or cookie is 1. Nothing where it is
  /// infinite, without an inverse square.
  std::optional<double> peak;
  std::optional<double> flux;  ///< lumens of the light as it is written
  /// The light's flux over the data's, minus 1. The data's is the whole luminaire's, or as a spec states it.
  std::optional<double> flux_error;
  /// Not of a cookie: the light's intensity over the data's, minus 1, where a luminaire's is largest, or of a spec's
  /// peak.
  std::optional<double> peak_error;
  std::optional<IlluminanceError> illuminance_error;  ///< where its illuminance is stated
  bool is_proven() const;                             ///< every fit is feasible, and shown to be the best

  /// How far the light's cone or cookie is from its beam, whatever the axis: sqrt(integral of (light - I)^2 / integral
  /// of I^2) over the sphere, for intensities I. Nothing without a beam.
  std::optional<double> beam_error() const;
  /// The same of any light with a beam about the axis, by its candela at an angle from there. Needs a beam.
  double beam_error_of(const std::function<double(double angle)>& candela) const;

 private:
  double beam_error_of(const std::function<double(double angle, const glm::dvec3& direction)>& candela) const;
};

/// Metres, of the disc of a luminaire's opening, or the default.
double unstated_source_radius(const LightTarget& target);

/// Lux of a light, by its cone, on a surface that faces it, as photometric() gives it.
///
/// range  metres
/// angle  radians from the axis
double illuminance_at(const Light& light, double range, double angle);

/// lux  of the light, at a range in metres where the beam is brightest
std::optional<IlluminanceError> largest_error(const std::vector<RangeSpec::Illuminance>& stated,
                                              const std::function<double(double range)>& lux);

/// Throws InputError for a stated source radius that the light's law cannot have.
LightFit fit_light(LightTarget target);

/// The text of the bounds and given figures that hold a cone.
std::vector<std::string> active_constraints(const Cone& cone, const ConeTarget& target);

/// The meaning of optimal, unproven and infeasible in reports.
const char* name_of(AttenuationFitStatus status);
const char* name_of(ConeFitStatus status);

/// What the data state of a beam, whatever was fitted to it.
struct BeamData {
  std::optional<double> peak;  ///< candela
  std::optional<double> flux;  ///< lumens
  /// Full angles at 50 % and 10 % of the peak, radians: none where it is not known, one of a round beam, else two, in
  /// the light's horizontal and vertical planes.
  std::vector<double> beam_angle;
  std::vector<double> field_angle;
};

/// A luminaire's data, else the angles that a spec states or its samples have.
BeamData beam_data(const LightFit& fit);

/// The same of the light as it is written. A cookie has its beam's angles, a point light has none.
BeamData light_beam(const LightFit& fit);

}  // namespace litfog::fit
