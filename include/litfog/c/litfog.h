// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stddef.h>
#include <stdint.h>

// The C API of litfog (component `c`), for C and for every language that can call C. Each call is a call of the C++
// header named above it, which states its formula, its source and its largest errors.
//
// Declarations for Ada and C#, with an example host each, are in apps/examples.
//
// Units     metres, 1/m, radians, linear RGB; world space in doubles.
// Results   a call that can fail returns a litfog_status. Results are the last parameters, written only on LITFOG_OK.
//           Otherwise litfog_last_error() says what is wrong: "attenuation.linear = -1: must be finite and >= 0".
//           No C++ exception leaves a call. A null pointer is an error, except where a comment gives it a meaning, or
//           for an array without entries. Memory for results must not overlap any other argument.
// Memory    a call keeps no pointer from its caller. litfog owns the memory that results point to: callers never free
//           it, and it goes with the handle that it came from. Strings end with a NUL.
// Structs   plain. Every call checks the structs that it is given, by the rules of find_error() in C++.
// Handles   each *_create is undone by its *_destroy, which also takes NULL.
// Threads   calls without a handle may run on any threads concurrently. Different handles are independent. Calls that
//           take a handle as const may run concurrently; any other call on it must run alone. No handle belongs to a
//           thread.
// ABI       within a minor version (0.1.x) functions and enumerators are only added; structs keep size and layout.

#ifdef __cplusplus
extern "C" {
#endif

#define LITFOG_API __attribute__((visibility("default")))

#define LITFOG_VERSION_MAJOR 0
#define LITFOG_VERSION_MINOR 1
#define LITFOG_VERSION_PATCH 0

/// Version of the library at run time: "0.1.0". Never freed, never NULL.
LITFOG_API const char* litfog_version(void);

// --- errors ---

typedef int32_t litfog_status;
enum {
  LITFOG_OK = 0,
  LITFOG_INVALID_ARGUMENT = 1,  ///< from any call: a value breaks its rule
  LITFOG_BAD_FILE = 2,          ///< litfog_read_light cannot use the file; the error begins with file:line:column
  LITFOG_OUT_OF_MEMORY = 3,     ///< from any call, unless its comment says that it allocates nothing
  LITFOG_FAULT = 4              ///< a bug in litfog: please report it
};

/// The error of the last call that failed on this thread; empty if none has. One sentence in UTF-8, except that a
/// file's name is the caller's bytes. Calls that succeed do not change it. Never NULL. Valid until the next call that
/// fails on this thread, or until the thread ends.
LITFOG_API const char* litfog_last_error(void);

// --- fog (litfog/fog.h) ---

enum {
  LITFOG_FOG_EXP = 0,  ///< f(r) = e^(-d r)
  LITFOG_FOG_EXP2 = 1  ///< f(r) = e^(-(d r)^2)
};

typedef struct litfog_fog {
  int32_t mode;    ///< LITFOG_FOG_*
  double density;  ///< d, 1/m, >= 0. 0 is clear air, infinity total fog.
} litfog_fog;

/// A lobe of a phase function, by Draine's formula.
typedef struct litfog_phase_lobe {
  double asymmetry;  ///< g, (-1, 1); 0 is isotropic if alpha is 0
  double alpha;      ///< [0, 1e6]; 0 is Henyey and Greenstein's function, 1 Cornette and Shanks's
} litfog_phase_lobe;

/// A phase function with two lobes. With a weight of 1 it is the first lobe alone.
typedef struct litfog_phase {
  litfog_phase_lobe first;
  litfog_phase_lobe second;
  double weight;  ///< [0, 1]: the first lobe's; the second has the rest
} litfog_phase;

/// Density of fog at a height (litfog/density_profile.h).
typedef struct litfog_density_knot {
  double height;   ///< metres, at most 16777216 in magnitude
  double density;  ///< 1/m, [0, 1e300]
} litfog_density_knot;

#define LITFOG_MAX_DENSITY_KNOTS 8

/// Density of exp fog over height: linear between knots, constant below the first and above the last, 0 without knots.
typedef struct litfog_density_profile {
  litfog_density_knot knots[LITFOG_MAX_DENSITY_KNOTS];  ///< heights strictly rise
  size_t count;                                         ///< knots in use
} litfog_density_profile;

/// A layer of fog, with transition bands outside it in which the density falls linearly to 0.
typedef struct litfog_fog_layer {
  double base;        ///< metres; -INFINITY: no base
  double top;         ///< metres, above the base; INFINITY: no top
  double transition;  ///< metres, finite, >= 0: height of each band
  double visibility;  ///< metres, >= 1e-290; INFINITY is no fog
} litfog_fog_layer;

/// Everything about the air. Its density at a height is the fog's plus the profile's.
typedef struct litfog_atmosphere {
  litfog_fog fog;
  litfog_phase phase;
  double albedo;                   ///< [0, 1]: scattering over extinction; all orders of scattering need 1
  double top;                      ///< metres: height at which rays to the sky leave the fog, unless a layer reaches
                                   ///< higher; INFINITY: they do not
  double ambient_fog_color[3];     ///< linear RGB, finite, >= 0
  litfog_density_profile profile;  ///< layers, in exp fog only; {0}: none
} litfog_atmosphere;

// Contrast thresholds that give a visibility its meaning.
#define LITFOG_CONTRAST_MOR 0.05          ///< meteorological optical range (WMO, ICAO Annex 3)
#define LITFOG_CONTRAST_KOSCHMIEDER 0.02  ///< Koschmieder 1924
#define LITFOG_CONTRAST_FLIGHTGEAR 0.01   ///< FlightGear's fog density

/// The fog of a visibility.
///
/// mode      LITFOG_FOG_*
/// metres    visibility, >= 0; infinity is no fog, 0 is total fog
/// contrast  (0, 1)
LITFOG_API litfog_status litfog_fog_from_visibility(int32_t mode, double metres, double contrast, litfog_fog* fog);

/// The phase function of water droplets (Jendersie and d'Eon 2023).
///
/// micrometres  the droplets' diameter, [5, 50]
LITFOG_API litfog_status litfog_phase_droplets(double micrometres, litfog_phase* phase);
/// The fog of a runway visual range, how far lamps or markings are seen (litfog/runway_visual_range.h).
///
/// mode                   LITFOG_FOG_*
/// metres                 >= 0, at most sqrt(candela / illuminance_threshold) unless candela is 0; infinity is no fog,
///                        0 is total fog
/// candela                a lamp's intensity, finite, >= 0; 0: only markings are seen. A new edge light has 10,000.
/// illuminance_threshold  lux at the eye at which a lamp becomes visible, finite, > 0; a pilot's by night is 8e-7
LITFOG_API litfog_status litfog_fog_from_runway_visual_range(int32_t mode, double metres, double candela,
                                                             double illuminance_threshold, litfog_fog* fog);
/// The runway visual range of a fog; infinite in clear air.
LITFOG_API litfog_status litfog_runway_visual_range(const litfog_fog* fog, double candela, double illuminance_threshold,
                                                    double* metres);
/// The lux at the eye at which a lamp becomes visible against a background (litfog/visual_threshold.h).
///
/// background  luminance, cd/m2, [0, 1e12]
LITFOG_API litfog_status litfog_illuminance_threshold(double background, double* lux);

/// The profile of layers, which add up where they overlap. A layer without base or top needs 2 knots, any other 4.
///
/// contrast  of the layers' visibilities, (0, 1)
LITFOG_API litfog_status litfog_density_profile_from_layers(const litfog_fog_layer* layers, size_t count,
                                                            double contrast, litfog_density_profile* profile);

/// Uniform fog with the mean density between two heights, in either order. A straight line between the heights has the
/// same fog factor in it. At equal heights it is the fog there: pass the eye's height for litfog_updater_set_fog.
///
/// height_a, height_b  metres, finite
LITFOG_API litfog_status litfog_fog_between(const litfog_atmosphere* atmosphere, double height_a, double height_b,
                                            litfog_fog* fog);

// --- lights (litfog/light.h) ---

/// a(r) = min(1, 1 / (constant + linear r + quadratic r^2)); finite, >= 0, not all 0.
typedef struct litfog_attenuation {
  double constant;
  double linear;     ///< 1/m
  double quadratic;  ///< 1/m^2
} litfog_attenuation;

enum {
  LITFOG_CONE_NONE = 0,       ///< 1 everywhere: a point light
  LITFOG_CONE_COSINE = 1,     ///< cos^exponent(u) for u < half_angle, else 0
  LITFOG_CONE_SMOOTHSTEP = 2  ///< smoothstep(cos outer, cos inner, cos u)
};

typedef struct litfog_cone {
  int32_t profile;    ///< LITFOG_CONE_*
  double half_angle;  ///< cosine: (0, pi/2], where the light is cut off
  double exponent;    ///< cosine: >= 0, finite; 0 is a flat beam
  double inner;       ///< smoothstep: [0, outer), full intensity up to here
  double outer;       ///< smoothstep: (inner, pi], no light beyond
} litfog_cone;

#define LITFOG_DEFAULT_THRESHOLD 0.05
#define LITFOG_MAX_POSITION 16777216.0     ///< largest magnitude of a coordinate, 2^24 m
#define LITFOG_DIRECTION_TOLERANCE 1.0e-6  ///< how far the length of a direction may differ from 1

#define LITFOG_MAX_FLASHES 8

/// One flash of a lamp, in each period.
typedef struct litfog_single_flash {
  double start;      ///< seconds from the period's start, not before the end of the previous flash
  double duration;   ///< seconds, > 0; the flash ends within the period
  double intensity;  ///< (0, 1e6]: multiplies the light's colour
} litfog_single_flash;

/// How a lamp flashes: it is dark except in its flashes, which recur in each period. The first period begins at time 0.
typedef struct litfog_flash {
  double period;                                    ///< seconds, (0, 3600]
  size_t count;                                     ///< flashes per period; 0: a steady lamp
  litfog_single_flash flashes[LITFOG_MAX_FLASHES];  ///< the first `count` are in use
} litfog_flash;

/// A kind of light: what a light file holds.
typedef struct litfog_light {
  double color[3];  ///< finite, >= 0; 1 is the display's white
  litfog_attenuation attenuation;
  double threshold;  ///< (0, 1): attenuation at which the light ends
  litfog_cone cone;
  double density_scale;  ///< finite, >= 0: factor on the fog's density for this light; 0: no fog
  double source_radius;  ///< metres, R of the lamp's luminous disc for litfog_photometric; 0: unknown
  litfog_flash flash;    ///< when the lamp is lit; only calls that take a time read it
} litfog_light;

/// A light in a scene.
typedef struct litfog_placed_light {
  litfog_light light;
  double position[3];   ///< each coordinate at most LITFOG_MAX_POSITION in magnitude
  double direction[3];  ///< axis of the cone; its length is 1 within LITFOG_DIRECTION_TOLERANCE
  int32_t carried;      ///< not 0: carried by the eye's vehicle; Hales's term is for carried lights only
} litfog_placed_light;

/// Clear air that scatters alike in all directions, with albedo 1, no layers, no top and a black fog colour, to start
/// from.
LITFOG_API litfog_status litfog_default_atmosphere(litfog_atmosphere* atmosphere);
/// A white point light with a(r) = 1 and the default threshold, to start from.
LITFOG_API litfog_status litfog_default_light(litfog_light* light);
/// The light of litfog_default_light at the origin along -z, not carried.
LITFOG_API litfog_status litfog_default_placed_light(litfog_placed_light* light);

/// Checks a struct: an error is LITFOG_INVALID_ARGUMENT and litfog_last_error(). Every other call checks its arguments,
/// too.
LITFOG_API litfog_status litfog_check_fog(const litfog_fog* fog);
LITFOG_API litfog_status litfog_check_atmosphere(const litfog_atmosphere* atmosphere);
LITFOG_API litfog_status litfog_check_light(const litfog_light* light);
LITFOG_API litfog_status litfog_check_placed_light(const litfog_placed_light* light);

#define LITFOG_WHITE_LUX 20.0  ///< illuminance of colour 1 at attenuation 1

/// The light without the clamp of its range attenuation, as bright near the lamp as a disc of its source radius.
LITFOG_API litfog_status litfog_photometric(const litfog_light* light, litfog_light* photometric);

/// The light's far intensity on its axis in candela, for each colour component; INFINITY without a quadratic term.
LITFOG_API litfog_status litfog_candela(const litfog_light* light, double candela[3]);

/// The factor on a light's colour at a time: a flash's intensity while it is on, 0 between flashes, 1 for a steady
/// lamp.
///
/// seconds  [0, 1e9]
LITFOG_API litfog_status litfog_flash_at(const litfog_flash* flash, double seconds, double* factor);

// --- light files (litfog/files/light_file.h) ---

/// Reads a light file.
///
/// path       bytes for the system's file calls, mostly UTF-8
/// name       name_size bytes for the light's name, in UTF-8 with a NUL; a longer name is cut after a whole character.
///            May be NULL if name_size is 0
/// returns    LITFOG_BAD_FILE with "headlight.json:7:12: threshold = 7: must be in (0, 1)" as the last error
LITFOG_API litfog_status litfog_read_light(const char* path, litfog_light* light, char* name, size_t name_size);

// --- fog colour intensity (litfog/solve.h) ---

enum {
  LITFOG_SOLVE_OK = 0,
  LITFOG_SOLVE_NOT_CONVERGED = 1,  ///< intensity is a lower bound, the value at peak_range
  LITFOG_SOLVE_INVALID = 2         ///< batch only: a value breaks its rule; intensity, peak range and extent are 0
};

typedef struct litfog_fog_intensity {
  double intensity;   ///< [0, 1]
  double peak_range;  ///< metres, [0, extent]; may be infinity
  double extent;      ///< metres; infinity for constant attenuation
  int32_t status;     ///< LITFOG_SOLVE_OK or LITFOG_SOLVE_NOT_CONVERGED
} litfog_fog_intensity;

/// Fog colour intensity of a light, in fog scaled by its density scale.
LITFOG_API litfog_status litfog_solve(const litfog_light* light, const litfog_fog* fog, litfog_fog_intensity* solution);

/// Fog colour intensity as published (Hales 2004): the largest of `samples` samples, which is an underestimate.
///
/// samples  >= 1; time is proportional to it
LITFOG_API litfog_status litfog_sample(const litfog_light* light, const litfog_fog* fog, int32_t samples,
                                       litfog_fog_intensity* solution);

// --- batch (litfog/batch.h): SIMD; allocates nothing but errors ---

/// Lights, one column per parameter. Columns hold `count` values; threshold and density may also hold a single value
/// for all lights, with a count of 1.
typedef struct litfog_batch_lights {
  size_t count;
  const double* constant;
  const double* linear;     ///< 1/m
  const double* quadratic;  ///< 1/m^2
  const double* threshold;
  size_t threshold_count;
  const double* density;  ///< 1/m: the fog's, scaled for the light's class
  size_t density_count;
} litfog_batch_lights;

/// Where the results go: columns of `count` values. A column that overlaps another, or a column of the lights, is
/// refused. All columns except intensity may be NULL; a NULL column is not computed.
typedef struct litfog_batch_solutions {
  double* intensity;
  double* peak_range;  ///< metres
  double* extent;      ///< metres
  uint8_t* status;     ///< LITFOG_SOLVE_OK, LITFOG_SOLVE_NOT_CONVERGED or LITFOG_SOLVE_INVALID
} litfog_batch_solutions;

typedef struct litfog_batch_lights_f {
  size_t count;
  const float* constant;
  const float* linear;
  const float* quadratic;
  const float* threshold;
  size_t threshold_count;
  const float* density;
  size_t density_count;
} litfog_batch_lights_f;

typedef struct litfog_batch_solutions_f {
  float* intensity;
  float* peak_range;
  float* extent;
  uint8_t* status;
} litfog_batch_solutions_f;

/// litfog_solve for columns of lights.
///
/// invalid  number of invalid lights, which do not fail the call; may be NULL
LITFOG_API litfog_status litfog_solve_batch(int32_t fog_mode, const litfog_batch_lights* lights,
                                            const litfog_batch_solutions* solutions, size_t* invalid);
LITFOG_API litfog_status litfog_solve_batch_f(int32_t fog_mode, const litfog_batch_lights_f* lights,
                                              const litfog_batch_solutions_f* solutions, size_t* invalid);

// --- airlight (litfog/airlight.h) ---

enum {
  LITFOG_LAMP_LEG_CLEAR = 0,  ///< k = 0: no loss between lamp and scattering, as in Hales's model
  LITFOG_LAMP_LEG_FOGGED = 1  ///< k = 1: the fog factor dims light on that leg (single scattering)
};

typedef struct litfog_eye_ray {
  double origin[3];
  double direction[3];  ///< its length is 1 within LITFOG_DIRECTION_TOLERANCE
  double length;        ///< >= 0: to the surface or the end of the fog; may be infinity
} litfog_eye_ray;

/// Airlight of a light along rays: the fraction of the light's colour that the fog scatters into the eye.
///
/// lamp_leg   LITFOG_LAMP_LEG_*
/// airlights  one per ray, [0, 1] in isotropic fog; must not overlap the rays
LITFOG_API litfog_status litfog_airlight(const litfog_placed_light* light, const litfog_atmosphere* atmosphere,
                                         const litfog_eye_ray* rays, size_t count, int32_t lamp_leg, double* airlights);

/// Airlight of a light along its own axis, [0, 1], with the eye at the light and the lamp's leg clear, out to the
/// extent.
LITFOG_API litfog_status litfog_axial_airlight(const litfog_light* light, const litfog_fog* fog, double* airlight);

/// The range in metres beyond which a light is visible neither on surfaces nor in fog.
///
/// fog       in layered air the thinnest at any height
/// budget    (0, 1): fraction of the largest component of the light's colour
/// lamp_leg  LITFOG_LAMP_LEG_*
/// range     [0, extent]; may be infinity
LITFOG_API litfog_status litfog_light_reach(const litfog_light* light, const litfog_fog* fog, double budget,
                                            int32_t lamp_leg, double* range);

/// The budget at which everything that lights add beyond their reach stays below a step of a picture.
///
/// step        linear light, finite, > 0
/// brightness  the largest component of the light's colour
/// budget      (0, 0.5]
LITFOG_API litfog_status litfog_reach_budget(double step, size_t lights, double brightness,
                                             const litfog_atmosphere* atmosphere, double* budget);

// --- sun and moon (litfog/directional_airlight.h) ---

/// Airlight of a directional light along rays: the fraction of the light's colour that the fog scatters into the eye.
/// The light enters at the atmosphere's top, or at 1200 m above height 0 if that is INFINITY, and at least at the last
/// knot's height. A profile that is not 0 above its knots ends 1200 m above the last.
///
/// atmosphere  exp fog
/// to_light    its length is 1 within LITFOG_DIRECTION_TOLERANCE
/// airlights   one per ray, >= 0; must not overlap the rays
LITFOG_API litfog_status litfog_directional_airlight(const litfog_atmosphere* atmosphere, const double* to_light,
                                                     const litfog_eye_ray* rays, size_t count, double* airlights);

/// The fraction of a directional light that reaches a height through the fog, and lights surfaces there.
///
/// atmosphere  exp fog
/// height      metres, at most LITFOG_MAX_POSITION in magnitude
/// factor      [0, 1]
LITFOG_API litfog_status litfog_directional_fog_factor(const litfog_atmosphere* atmosphere, const double* to_light,
                                                       double height, double* factor);

// --- all orders of scattering (litfog/multiple_scattering.h) ---

#define LITFOG_SCATTERING_DEPTHS 61
#define LITFOG_SCATTERING_ANGLES 69
#define LITFOG_BEAM_ORDERS 48
#define LITFOG_BEAM_DEPTHS 16
#define LITFOG_BEAM_ANGLES 24

/// A point lamp's light that a phase function scatters twice or more, by optical depth and angle: the texture of
/// litfog/shaders/multiple_scattering.glsl, one angle per column.
typedef struct litfog_scattering_table {
  float logs[LITFOG_SCATTERING_DEPTHS][LITFOG_SCATTERING_ANGLES];
} litfog_scattering_table;

/// The table of an atmosphere's phase function.
///
/// atmosphere  exp fog of albedo 1, isotropic, of one lobe with alpha 0 and g in [0, 0.95], or of droplets
LITFOG_API litfog_status litfog_make_scattering_table(const litfog_atmosphere* atmosphere,
                                                      litfog_scattering_table* table);

/// The intensity, m^2, of a lamp with 1 / r^2 that loses as much light to the fog as a light with this attenuation.
///
/// density  1/m, finite, > 0
LITFOG_API litfog_status litfog_effective_intensity(const litfog_attenuation* attenuation, double density,
                                                    double* intensity);

/// Light that the fog scatters twice or more into the eye along rays, a factor on the light's colour that adds to
/// litfog_airlight.
///
/// table      made for the atmosphere
/// scattered  one per ray, >= 0; must not overlap the rays
LITFOG_API litfog_status litfog_multiple_scattering(const litfog_placed_light* light,
                                                    const litfog_atmosphere* atmosphere,
                                                    const litfog_scattering_table* table, const litfog_eye_ray* rays,
                                                    size_t count, double* scattered);

/// A thin beam's scattered light, at an optical depth from its lamp (litfog/scattered_beam.h).
typedef struct litfog_thin_beam {
  double share[LITFOG_BEAM_ORDERS];
  double radial[LITFOG_BEAM_ORDERS];
  double turned[LITFOG_BEAM_ORDERS];
  double forward;
} litfog_thin_beam;

/// Data from which the beams of all lamps are made.
typedef struct litfog_thin_beams {
  litfog_thin_beam rows[LITFOG_BEAM_DEPTHS];
} litfog_thin_beams;

/// A cone's scattered light: the rows of one beam in the shaders' texture litfog_scattered_beams.
typedef struct litfog_scattered_beam {
  float texels[LITFOG_BEAM_DEPTHS][LITFOG_BEAM_ANGLES][4];
} litfog_scattered_beam;

/// A light as the fog around it scatters it.
typedef struct litfog_scattering_source {
  double intensity;     ///< m^2: litfog_effective_intensity in the densest layer; 0 in clear air and total fog
  double soft_range;    ///< metres, added in quadrature to distances from a lamp weaker than 1 / r^2 near it
  double phase_cosine;  ///< mean cosine of the phase function
  int32_t is_cone;      ///< 0: a point lamp
  litfog_scattered_beam beam;
} litfog_scattering_source;

/// Light from many directions. The light of several lamps is the sum, member by member.
typedef struct litfog_diffuse_light {
  double all;      ///< the integral of the radiance over all directions, [0, 1e100]
  double flow[3];  ///< the integral of radiance times its direction of travel, at most 1e100 in magnitude
} litfog_diffuse_light;

/// How exp fog of albedo 1 scatters a thin beam, for litfog_make_scattering_source.
///
/// table  made for the atmosphere
LITFOG_API litfog_status litfog_make_thin_beams(const litfog_atmosphere* atmosphere,
                                                const litfog_scattering_table* table, litfog_thin_beams* beams);

/// How an atmosphere's fog scatters a light, independent of the light's position.
///
/// beams  made by litfog_make_thin_beams for the atmosphere
LITFOG_API litfog_status litfog_make_scattering_source(const litfog_light* light, const litfog_atmosphere* atmosphere,
                                                       const litfog_thin_beams* beams,
                                                       litfog_scattering_source* source);

/// A lamp's light that fog has scattered, at positions, a factor on the light's colour.
///
/// source     made by litfog_make_scattering_source for the light and the atmosphere; it is not checked
/// positions  three coordinates each, metres, at most LITFOG_MAX_POSITION in magnitude
/// scattered  one per position; must not overlap the positions
LITFOG_API litfog_status litfog_scattered_light(const litfog_placed_light* light,
                                                const litfog_scattering_source* source,
                                                const litfog_atmosphere* atmosphere, const double* positions,
                                                size_t count, litfog_diffuse_light* scattered);

/// A surface's irradiance by diffuse light, in the unit in which the lamp itself gives attenuation times cone times fog
/// factor times cosine.
///
/// normal  its length is 1 within LITFOG_DIRECTION_TOLERANCE
LITFOG_API litfog_status litfog_irradiance(const litfog_diffuse_light* light, const double* normal, double* irradiance);

// --- tables and block of the shaders (litfog/fog_light_block.h): std140, ready for upload ---

typedef struct litfog_fog_light_kind {
  float attenuation_extent[4];    ///< constant, linear, quadratic, extent
  float cone_scale_intensity[4];  ///< cone (2), density scale, fog colour intensity
} litfog_fog_light_kind;

typedef struct litfog_fog_light_instance {
  float position_kind[4];  ///< position (3), index of its kind
  float axis_profile[4];   ///< axis (3), profile
  float color[4];          ///< colour (3), 0
} litfog_fog_light_instance;

typedef struct litfog_fog_header {
  float fog[4];                                      ///< density, mode, number of instances, albedo
  float ambient_fog_color[4];                        ///< colour (3), number of knots
  float phase_lobes[2][4];                           ///< with terms that do not depend on the angle
  float density_knots[LITFOG_MAX_DENSITY_KNOTS][4];  ///< height, density, 0, 0
} litfog_fog_header;

#define LITFOG_MAX_FOG_LIGHTS 200

/// The uniform block LitfogLightBlock.
typedef struct litfog_fog_light_block {
  litfog_fog_header header;
  litfog_fog_light_kind kinds[LITFOG_MAX_FOG_LIGHTS];
  litfog_fog_light_instance instances[LITFOG_MAX_FOG_LIGHTS];
} litfog_fog_light_block;

/// The first members of the block, for lights that an updater holds.
///
/// instances  number of lights in the block, at most LITFOG_MAX_FOG_LIGHTS; 0 if all lights are in buffers
LITFOG_API litfog_status litfog_pack_fog_header(const litfog_atmosphere* atmosphere, size_t instances,
                                                litfog_fog_header* header);

/// The whole block from lights, which are solved in the atmosphere's fog without its profile. For lights that do not
/// change; others need an updater.
///
/// count  at most LITFOG_MAX_FOG_LIGHTS
LITFOG_API litfog_status litfog_pack_fog_light_block(const litfog_atmosphere* atmosphere,
                                                     const litfog_placed_light* lights, size_t count,
                                                     litfog_fog_light_block* block);

// --- updater (litfog/updater.h) ---

/// The lights of a scene as tables of kinds and instances, kept up to date through every change of the visibility.
typedef struct litfog_updater litfog_updater;

/// A light that an updater holds. Calls refuse the handle of a removed light, but cannot detect a handle of another
/// updater.
typedef struct litfog_light_handle {
  uint32_t slot;
  uint32_t generation;  ///< 0: no light
} litfog_light_handle;

/// Entries [begin, end) of a table.
typedef struct litfog_entry_range {
  size_t begin;
  size_t end;
} litfog_entry_range;

/// The ranges of each table that must be uploaded again, sorted and disjoint. Valid as long as the tables.
typedef struct litfog_fog_light_changes {
  const litfog_entry_range* kinds;
  size_t kind_count;
  const litfog_entry_range* instances;
  size_t instance_count;
  const litfog_entry_range* sources;
  size_t source_count;
} litfog_fog_light_changes;

/// What all orders of scattering need for a kind's lights: members of their litfog_scattering_source.
typedef struct litfog_fog_light_source {
  float intensity;  ///< m^2; 0 if none of the kind's lights is on
  float soft_range;
} litfog_fog_light_source;

/// The tables. Valid until the next call on the updater that is not const.
typedef struct litfog_fog_light_tables {
  const litfog_fog_light_kind* kinds;
  size_t kind_count;
  const litfog_fog_light_instance* instances;
  size_t instance_count;
} litfog_fog_light_tables;

/// What the last set_fog or set_atmosphere did.
typedef struct litfog_fog_update_statistics {
  size_t kinds_solved;
  size_t kinds_skipped;
  size_t lights_skipped;
  size_t bytes_dirty;
  size_t sources_solved;
} litfog_fog_update_statistics;

#define LITFOG_DEFAULT_SKIP_BUDGET_255 0.5  ///< half a step of an 8-bit picture

/// Makes an updater without lights in clear air.
///
/// skip_budget_255  steps of 1/255, finite, >= 0: lights that cannot add that much to a pixel are not solved
LITFOG_API litfog_status litfog_updater_create(double skip_budget_255, litfog_updater** updater);
LITFOG_API void litfog_updater_destroy(litfog_updater* updater);

/// Adds a light, switched on. It is in the tables after the next set_fog, like every change below.
LITFOG_API litfog_status litfog_updater_add(litfog_updater* updater, const litfog_placed_light* light,
                                            litfog_light_handle* handle);
/// Replaces a light. If it is switched off, it stays off.
LITFOG_API litfog_status litfog_updater_change(litfog_updater* updater, litfog_light_handle handle,
                                               const litfog_placed_light* light);
/// is_on  0: off, black in the tables; otherwise on
LITFOG_API litfog_status litfog_updater_switch_light(litfog_updater* updater, litfog_light_handle handle,
                                                     int32_t is_on);
/// Sets the time, which is 0 before the first call: lights that flash take their colour at that time. Solves nothing.
///
/// seconds  [0, 1e9]
LITFOG_API litfog_status litfog_updater_set_time(litfog_updater* updater, double seconds);
LITFOG_API litfog_status litfog_updater_remove(litfog_updater* updater, litfog_light_handle handle);

/// Brings the tables up to date with the fog (clear air before the first call) and with all changes of lights. Call it
/// once per frame. Allocates nothing.
LITFOG_API litfog_status litfog_updater_set_fog(litfog_updater* updater, const litfog_fog* fog,
                                                litfog_fog_light_changes* changes);

/// The same for any atmosphere. Kinds have their intensities in the fog at the eye's height. A change of the fog, its
/// layers or its phase function changes only kinds and sources.
LITFOG_API litfog_status litfog_updater_set_atmosphere(litfog_updater* updater, const litfog_atmosphere* atmosphere,
                                                       double eye_height, litfog_fog_light_changes* changes);

/// Makes set_fog and set_atmosphere also solve the source of each kind, for all orders of scattering.
LITFOG_API litfog_status litfog_updater_solve_sources(litfog_updater* updater);
/// The sources, one per kind: those in the densest fog at any height, and after set_fog in isotropic fog. None unless
/// they are solved. Valid as long as the tables.
LITFOG_API litfog_status litfog_updater_sources(const litfog_updater* updater, const litfog_fog_light_source** sources,
                                                size_t* count);

LITFOG_API litfog_status litfog_updater_tables(const litfog_updater* updater, litfog_fog_light_tables* tables);
LITFOG_API litfog_status litfog_updater_statistics(const litfog_updater* updater,
                                                   litfog_fog_update_statistics* statistics);
/// Index of a light among the instances, and of its kind among the kinds.
LITFOG_API litfog_status litfog_updater_instance_of(const litfog_updater* updater, litfog_light_handle handle,
                                                    size_t* instance);
LITFOG_API litfog_status litfog_updater_kind_of(const litfog_updater* updater, litfog_light_handle handle,
                                                size_t* kind);

// --- culling (litfog/light_bounds.h, litfog/view_frustum.h) ---

/// All points within a range of a light and within an angle of its axis.
typedef struct litfog_light_bounds {
  double position[3];
  double direction[3];
  double range;       ///< metres, >= 0; 0 lights nothing, infinity has no end
  double half_angle;  ///< [0, pi]; pi is a sphere
} litfog_light_bounds;

/// The bounds of a light.
///
/// range  metres, >= 0, as litfog_light_reach gives it
LITFOG_API litfog_status litfog_bounds_of(const litfog_placed_light* light, double range, litfog_light_bounds* bounds);

/// Whether a light can light anything in a box.
///
/// low, high  corners, three coordinates each: metres, finite, low's at most high's
/// can        0 only if the light can light nothing in the box
LITFOG_API litfog_status litfog_can_light(const litfog_light_bounds* bounds, const double* low, const double* high,
                                          int32_t* can);

/// The part of space that a perspective picture shows.
typedef struct litfog_view {
  double eye[3];
  double forward[3];  ///< unit
  double up[3];       ///< unit, orthogonal to forward
  double left;        ///< tangents of the angles at which the picture's edges lie, right and up positive, in [-10, 10],
                      ///< left < right and bottom < top
  double right;
  double bottom;
  double top;
  double nearest;   ///< depth along forward, > 0
  double farthest;  ///< (nearest, LITFOG_MAX_POSITION]
} litfog_view;

/// A view from the origin along -z, 90 degrees wide and high, from 0.1 to 10,000 m.
LITFOG_API litfog_status litfog_default_view(litfog_view* view);

typedef struct litfog_view_frustum litfog_view_frustum;

LITFOG_API litfog_status litfog_view_frustum_create(const litfog_view* view, litfog_view_frustum** frustum);
LITFOG_API void litfog_view_frustum_destroy(litfog_view_frustum* frustum);

/// Whether the view shows any of a sphere.
///
/// radius  metres, >= 0
/// can     0 only if the sphere does not meet the frustum
LITFOG_API litfog_status litfog_view_frustum_can_see_ball(const litfog_view_frustum* frustum, const double* centre,
                                                          double radius, int32_t* can);
/// Whether the view shows anything that a light can light.
///
/// can     0 only if the light can light nothing in the frustum
LITFOG_API litfog_status litfog_view_frustum_can_see_light(const litfog_view_frustum* frustum,
                                                           const litfog_light_bounds* bounds, int32_t* can);

// --- cluster lists (litfog/light_clusters.h) ---

typedef struct litfog_cluster_grid {
  uint32_t columns;    ///< [1, 64]
  uint32_t rows;       ///< [1, 64]
  uint32_t slices;     ///< [1, 64]
  double first_depth;  ///< metres, > 0: where the first slice ends; below the view's farthest depth, and above its
                       ///< nearest with two slices or more
} litfog_cluster_grid;

/// The lights of a cluster: `count` entries of the light list from `first` on.
typedef struct litfog_cluster {
  uint32_t first;
  uint32_t count;
} litfog_cluster;

/// The lists, and how a shader finds the cluster of a fragment (ClusterLookup). Valid until the next update. Before the
/// first update all clusters are empty.
typedef struct litfog_cluster_lists {
  const litfog_cluster* clusters;
  size_t cluster_count;
  const uint32_t* lights;
  size_t light_count;
  float slice_scale;
  float slice_bias;
  const uint32_t* table;  ///< all lists, also those along rays, for litfog/shaders/light_clusters.glsl
  size_t table_size;      ///< words
} litfog_cluster_lists;

typedef struct litfog_light_clusters litfog_light_clusters;

/// grid  NULL: 16 columns, 9 rows, 24 slices, the first up to 5 m
LITFOG_API litfog_status litfog_light_clusters_create(const litfog_cluster_grid* grid,
                                                      litfog_light_clusters** clusters);
LITFOG_API void litfog_light_clusters_destroy(litfog_light_clusters* clusters);

/// Sets the number of lights; new lights have a range of 0.
///
/// count  at most (2^31 - 2^20) / (columns * rows * slices)
LITFOG_API litfog_status litfog_light_clusters_resize(litfog_light_clusters* clusters, size_t count);
/// light  below the number of lights
LITFOG_API litfog_status litfog_light_clusters_set_light(litfog_light_clusters* clusters, size_t light,
                                                         const litfog_light_bounds* bounds);
/// Sets the bounds of all lights of an updater in clusters, by their indices, once per frame. Beyond their bounds all
/// lights together add less than a step to surfaces and airlight. The bounds follow the fog's changes.
///
/// step      linear light, finite, > 0; 0.5 / 255 is half a step of an 8-bit picture
/// lamp_leg  LITFOG_LAMP_LEG_*
LITFOG_API litfog_status litfog_updater_bound_lights(const litfog_updater* updater, litfog_light_clusters* clusters,
                                                     const litfog_atmosphere* atmosphere, double step,
                                                     int32_t lamp_leg);
/// The range in metres of a kind's bounds, for a host's own culling.
///
/// kind   below the number of kinds
/// range  [0, extent]; may be infinity
LITFOG_API litfog_status litfog_updater_reach_of_kind(const litfog_updater* updater, size_t kind,
                                                      const litfog_atmosphere* atmosphere, double step,
                                                      int32_t lamp_leg, double* range);
/// Brings the lists up to date with a view and the lights.
///
/// changed  not 0 if the lists have changed; may be NULL
LITFOG_API litfog_status litfog_light_clusters_update(litfog_light_clusters* clusters, const litfog_view* view,
                                                      int32_t* changed);
LITFOG_API litfog_status litfog_light_clusters_lists(const litfog_light_clusters* clusters,
                                                     litfog_cluster_lists* lists);

// --- shaders (litfog/shaders/*.glsl), embedded in the library ---

typedef struct litfog_shader_text {
  const char* name;  ///< as shaders include it: "litfog/shaders/fog.glsl"
  const char* text;
} litfog_shader_text;

/// The shader files as installed, for a host that resolves `#include` lines itself. Never freed.
LITFOG_API litfog_status litfog_shader_texts(const litfog_shader_text** texts, size_t* count);

/// Expands a shader's lines that include litfog's files, each file once, for drivers without `#include`. Other lines
/// stay as they are, `#version` first; `#line` keeps their numbers, by files in the order of inclusion.
///
/// source     may include only litfog's files; others are an error
/// expanded   at least `size` bytes; may be NULL if size is 0
/// length     of the whole text, without its NUL; expanded is written only if size is larger
LITFOG_API litfog_status litfog_expand_shader(const char* source, char* expanded, size_t size, size_t* length);

#ifdef __cplusplus
}
#endif
