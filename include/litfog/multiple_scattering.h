// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include "litfog/airlight.h"
#include "litfog/atmosphere.h"
#include "litfog/attenuation.h"
#include "litfog/light.h"
#include "litfog/scattered_beam.h"
#include "litfog/value_error.h"

namespace litfog {

// Light that fog scatters to the eye twice and more often, M, adds to the airlight A, which is scattered once. A
// picture shows airlight_unit() * colour * (A + M). At the distance of one visibility from a lamp, M is several times
// A. It is known for exp fog of albedo 1 that is isotropic, of Henyey and Greenstein's phase function with 0 <= g <=
// 0.95, or of droplets; no ground and no wall takes part in it. Light leaves layers of fog above and below. Fog below
// the lowest knot of a profile goes on: a layer that begins at the ground is one over a dark ground.

inline constexpr int kScatteringDepths = 61;  ///< from 0.02 to 30
inline constexpr int kScatteringAngles = 69;  ///< from 0.2 to 180 degrees

/// M of a point lamp for a phase function: the natural logarithm of M / (I d^2) for the attenuation I / r^2 in endless
/// fog of density d, by the optical depth between eye and lamp and by the angle between the ray and the direction to
/// the lamp. It is for shaders, as a texture (litfog/shaders/multiple_scattering.glsl), and for multiple_scattering().
struct ScatteringTable {
  std::array<std::array<float, kScatteringAngles>, kScatteringDepths> logs;
};

/// Why an atmosphere has no scattering table, or nothing: its fog is not exp, its albedo is not 1, or its phase
/// function is another than those above.
std::optional<ValueError> find_scattering_error(const Atmosphere& atmosphere);

/// The table of an atmosphere's phase function, between those of data/scattering/point.csv.
///
/// throws  std::invalid_argument naming field, value and rule (find_error, find_scattering_error)
ScatteringTable make_scattering_table(const Atmosphere& atmosphere);

/// What is wrong with a table for an atmosphere, or nothing: the atmosphere has one (find_scattering_error), the
/// logarithms are at most 100 in magnitude, and at three corners they are those of the phase function.
std::optional<ValueError> find_error(const ScatteringTable& table, const Atmosphere& atmosphere);

/// M / (I d^2) of a table, between its numbers.
///
/// depth  optical, >= 0; below 0.02 it counts as that, and beyond 30 the light falls by 1 / depth, as diffusion has it
/// angle  radians, [0, pi]; below 0.2 degrees it counts as that
double scattered_at(const ScatteringTable& table, double depth, double angle);

/// Largest relative error of effective_intensity.
inline constexpr double kEffectiveIntensityMaxError = 1e-8;

/// The intensity of a lamp with 1 / r^2 that loses as much light to the fog as a light with an attenuation does: the
/// integral of d e^(-d r) r^2 a(r) over r, m^2. A photometric light has 1 / Q of thin fog.
///
/// density    d, 1/m, finite, > 0; below 1e-100 and above 1e100 it counts as that
/// max error  kEffectiveIntensityMaxError relative                                       (multiple_scattering_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double effective_intensity(const Attenuation& attenuation, double density);

/// Largest error of soft_range in isotropic fog, mean free paths.
inline constexpr double kSoftRangeMaxError = 1e-8;

/// How far from the lamp of effective_intensity(), which has 1 / r^2, rays count as passing it where the light itself
/// is weaker near it, metres. It is 0 of 1 / r^2. With m the mean of (d r)^(-1/2) over where light is scattered first,
/// that is weighted by d e^(-d r) r^2 a(r), and x = pi^(1/2) / m - 1,
///   (1 + g) / d  x^2 / (0.3 + 1.3 x)^(1/2),
/// where g is the phase function's mean cosine. It was fitted to M of 17 laws in 11 fogs.
///
/// density    d, 1/m, as above
/// max error  kSoftRangeMaxError / d in isotropic fog                                    (multiple_scattering_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double soft_range(const Attenuation& attenuation, double density, const Phase& phase = {});

/// A light as M knows it, for all rays.
struct ScatteringSource {
  double intensity = 0;     ///< source_intensity(), m^2
  double soft_range = 0;    ///< soft_range(), metres
  double phase_cosine = 0;  ///< mean cosine of the phase function
  bool is_cone = false;     ///< else a point lamp
  ScatteredBeam beam = {};  ///< of its shape
};

/// Effective intensity of a light in its fog, in layers in the densest, m^2; 0 in clear air, in total fog and in exp2
/// fog.
///
/// light   its class sees the fog at its density scale
/// throws  std::invalid_argument naming field, value and rule
double source_intensity(const Light& light, const Atmosphere& atmosphere);

/// A light as a point lamp for multiple_scattering(): it has no beam. FogUpdater::sources() has those of the lights
/// that it holds.
///
/// throws  std::invalid_argument naming field, value and rule
ScatteringSource scattering_source(const Light& light, const Atmosphere& atmosphere);

/// beams   of the atmosphere
/// throws  std::invalid_argument naming field, value and rule
ScatteringSource scattering_source(const Light& light, const Atmosphere& atmosphere, const ThinBeams& beams);

/// The same of a light with another angular shape than its cone's.
ScatteringSource scattering_source(const Light& light, const BeamMoments& shape, const Atmosphere& atmosphere,
                                   const ThinBeams& beams);

/// Largest errors of A + M, that is airlight() and multiple_scattering(), as fractions of the true A + M: of a point
/// lamp with 1 / r^2 in uniform fog, at optical depths of 0.02 to 10 between lamp and eye and angles of 0.2 to 180
/// degrees.
///
/// | rays, endless or 0.02 mean free paths long or longer | bound                   |
/// |------------------------------------------------------|-------------------------|
/// | half of them                                         | kScatteringMedianError  |
/// | 9 of 10                                              | kScatteringTypicalError |
/// | all                                                  | kScatteringMaxError     |
///
/// Of a ray that ends long before it passes the lamp M is the difference of two numbers that are almost the same.
inline constexpr double kScatteringMedianError = 0.003;
inline constexpr double kScatteringTypicalError = 0.02;
inline constexpr double kScatteringMaxError = 0.2;

/// The same at depths of 10 to 30; the largest error is kScatteringMaxError there, too.
inline constexpr double kFarScatteringMedianError = 0.01;
inline constexpr double kFarScatteringTypicalError = 0.08;

/// The same of a point lamp with another law, at depths of up to 10: one that leaves 1 / r^2 within 0.01 to 30 mean
/// free paths.
inline constexpr double kSoftScatteringMedianError = 0.02;
inline constexpr double kSoftScatteringTypicalError = 0.08;
inline constexpr double kSoftScatteringMaxError = 0.5;

/// The same of cones with half angles of 3 degrees or more, aimed anywhere, at depths of up to 3 in isotropic fog and
/// in droplets. In droplets a beam that points away from the eye may glow several times too brightly.
inline constexpr double kConeScatteringMedianError = 0.04;
inline constexpr double kConeScatteringTypicalError = 0.1;
inline constexpr double kDropletConeScatteringMedianError = 0.25;
inline constexpr double kDropletConeScatteringTypicalError = 0.8;
inline constexpr double kSoftConeScatteringMedianError = 0.1;
inline constexpr double kSoftConeScatteringTypicalError = 0.25;
inline constexpr double kSoftDropletConeScatteringMedianError = 0.3;
inline constexpr double kSoftDropletConeScatteringTypicalError = 0.8;

/// The same of point lamps in layers of 0.1 to 10 optical depths, in them or beside, with clear air beyond. In thinner
/// layers, M of a lamp several optical depths along the layer may be far too bright.
inline constexpr double kLayeredScatteringMedianError = 0.05;
inline constexpr double kLayeredScatteringTypicalError = 0.2;

/// The same of point lamps with another law in layers, and of cones aimed anywhere.
inline constexpr double kSoftLayeredScatteringMedianError = 0.1;
inline constexpr double kSoftLayeredScatteringTypicalError = 0.45;
inline constexpr double kLayeredConeScatteringMedianError = 0.1;
inline constexpr double kLayeredConeScatteringTypicalError = 0.35;

/// M of a light along a ray, in the unit of airlight(). The table is not checked.
///
/// source     the light's; of a point lamp that without a beam is enough
/// table      that of the atmosphere
/// max error  of A + M, as above                                                        (multiple_scattering_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double multiple_scattering(const PlacedLight& light, const ScatteringSource& source, const Atmosphere& atmosphere,
                           const ScatteringTable& table, const EyeRay& ray);

/// M along many rays. Columns of different lengths are a bug of the caller and assert.
///
/// throws     std::invalid_argument naming field, value and rule, before any result is written
void multiple_scattering(const PlacedLight& light, const Atmosphere& atmosphere, const ScatteringTable& table,
                         std::span<const EyeRay> rays, std::span<double> scattered);

inline double multiple_scattering(const PlacedLight& light, const Atmosphere& atmosphere, const ScatteringTable& table,
                                  const EyeRay& ray) {
  double scattered = 0;
  multiple_scattering(light, atmosphere, table, {&ray, 1}, {&scattered, 1});
  return scattered;
}

/// Light that comes from many directions, of one lamp or of several: the lights of lamps add up.
struct DiffuseLight {
  double all = 0;        ///< the integral of the radiance over all directions
  glm::dvec3 flow{0.0};  ///< that of the radiance times the direction in which it travels

  DiffuseLight& operator+=(const DiffuseLight& other) { return all += other.all, flow += other.flow, *this; }
  friend DiffuseLight operator*(double scale, const DiffuseLight& light) {
    return {.all = scale * light.all, .flow = scale * light.flow};
  }
};

/// What is wrong with a diffuse light, or nothing: `all` is in [0, 1e100], and a component of the flow at most 1e100 in
/// magnitude.
std::optional<ValueError> find_error(const DiffuseLight& light);

/// What the fog around places has scattered of a lamp's light, once or more often. Irradiances are in the unit of
/// a(r) cone(u) f(r) cos, which a surface receives from the lamp itself. Columns of different lengths are a bug of the
/// caller and assert.
///
/// source     the light's, with its beam, also of a point lamp: scattering_source() with ThinBeams
/// positions  of the places, metres
/// scattered  the flow is no longer than `all`, but for rounding                         (multiple_scattering_test.cpp)
/// throws     std::invalid_argument naming field, value and rule, before any result is written
void scattered_light(const PlacedLight& light, const ScatteringSource& source, const Atmosphere& atmosphere,
                     std::span<const glm::dvec3> positions, std::span<DiffuseLight> scattered);

inline DiffuseLight scattered_light(const PlacedLight& light, const ScatteringSource& source,
                                    const Atmosphere& atmosphere, const glm::dvec3& position) {
  DiffuseLight scattered;
  scattered_light(light, source, atmosphere, {&position, 1}, {&scattered, 1});
  return scattered;
}

/// Largest error of the irradiance() of a point lamp's scattered_light(), as a fraction of (1 - f) I / r^2, what of the
/// lamp's light is scattered on a distance r with the fog factor f; and of the sum of several lamps', which is largest
/// between two lamps that shine at each other.
inline constexpr double kScatteredIrradianceMaxError = 0.04;
inline constexpr double kSummedIrradianceMaxError = 0.25;

/// Of lamps with another law it errs by these fractions of what a surface receives that faces the lamp, at half of all
/// places and at 9 of 10.
inline constexpr double kSoftIrradianceMedianError = 0.1;
inline constexpr double kSoftIrradianceTypicalError = 0.4;

/// Below layers it is right within these factors, at half of all places and at 9 of 10.
inline constexpr double kLayeredIrradianceMedianFactor = 1.5;
inline constexpr double kLayeredIrradianceTypicalFactor = 3;

/// What a surface receives of diffuse light. At the distance of one visibility from a lamp its scattered light is
/// several times the lamp's own.
///
/// normal     its length is 1 within kDirectionTolerance
/// max error  as above                                                                  (multiple_scattering_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double irradiance(const DiffuseLight& light, const glm::dvec3& normal);

}  // namespace litfog
