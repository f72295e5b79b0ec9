// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "litfog/attenuation.h"
#include "litfog/cone.h"
#include "litfog/files/output_error.h"
#include "litfog/flash.h"
#include "litfog/input_error.h"
#include "litfog/visual_threshold.h"

namespace litfog {

// clang-format off
/// Light-spec files, version 1: what a light's data sheet says, from which litfog-fit makes a light.
///
///     {
///       "litfog": "light-spec",
///       "version": 1,
///       "name": "landing lamp",                 optional: the file's name without its ending
///       "source": "where the figures are from", optional, or an array of strings; the light's
///       "color": [1, 0.9, 0.8],                 optional: white; the light's; or
///       "color_temperature_k": 3200,            instead, with a luminance of 1: 1000 to 25000
///                                               (litfog/color_temperature.h)
///       "density_scale": 0.4,                   optional: 1; the light's
///       "source_radius_m": 0.08,                optional: of a disc with the area of the photometry's luminous
///                                               opening, or 0.05, if the light can have it; the light's
///       "flash": {...},                         optional: the light's (litfog/files/light_file.h)
///       "range": {                              optional; needs samples or one of extent_m to flux_lm
///         "threshold": 0.05,                    the light's
///         "extent_m": 120,                      where the attenuation reaches the threshold, met exactly; or instead
///         "end_lx": 1,                          the illuminance of the peak there in clear air; or a name of
///                                               kVisualThresholds, such as "night"; default: 1
///         "peak_cd": 12000,                     the beam's largest intensity, for a colour of luminance 1; default:
///                                               the peak of the cone's photometry, which is scaled to it; or
///         "illuminance": {"range_m": 10, "lx": 120},     instead, in clear air: the peak is lx * range_m^2; for a
///                                               table, an array of such rows at different ranges, it is the
///                                               geometric mean; or
///         "flux_lm": 900,                       instead, of the whole light: the peak is the flux over that of the
///                                               cone or the photometry with a peak of 1 cd
///         "constant": 1,                        C, fixed
///         "family": "quadratic",                for an extent alone: quadratic, linear or mixed (half and half)
///         "samples": [{"range_m": 10, "attenuation": 0.8, "weight": 1}]      by increasing range; weight optional
///       },
///       "cone": {                               optional: a point light; needs a beam or field angle, samples or
///                                               photometry
///         "profile": "best",                    best (of all), or a profile of light files
///         "half_angle_deg": 30,                 where the light ends
///         "beam_angle_deg": 11,                 full angle at 50 % of the peak; [12, 6], horizontal and vertical, for
///                                               an elliptical beam, which has no samples
///         "field_angle_deg": 22,                full angle at 10 %, in the same form
///         "samples": [{"angle_deg": 0, "intensity": 1, "weight": 1}],        by increasing angle; weight optional
///         "photometry": "lamp.ies"              instead of samples: any photometric file that read_luminaire() reads
///                                               (litfog/photometry/luminaire.h), relative to this file; without a
///                                               range the light ends where its peak gives 1 lx. The light's peak
///                                               is the largest mean over the azimuth, which keeps the flux
///       }
///     }
///
/// A spec has a range, a cone or both. JSON of at most 64 MiB. Nothing here depends on the locale.
// clang-format on

/// The member "range".
struct RangeSpec {
  enum class Family { quadratic, linear, mixed };
  /// A row of the falloff table.
  struct Sample {
    double range = 0;  ///< metres
    double attenuation = 1;
    double weight = 1;
  };

  /// The illuminance on the light's axis at a range.
  struct Illuminance {
    double range = 1;  ///< metres, > 0
    double lux = 1;    ///< > 0

    friend bool operator==(const Illuminance&, const Illuminance&) = default;
  };

  double threshold = kDefaultThreshold;
  std::optional<double> extent = {};           ///< metres; excludes the next four
  std::optional<double> end_illuminance = {};  ///< lux, > 0
  std::optional<double> peak = {};             ///< candela, > 0; excludes the next two
  std::vector<Illuminance> illuminance = {};   ///< one row, or the rows of a table, at different ranges
  std::optional<double> flux = {};             ///< lumens, > 0
  std::optional<double> constant = {};
  Family family = Family::quadratic;
  std::vector<Sample> samples = {};
};

/// Full angles in the horizontal and the vertical plane through a beam's axis; equal for a round beam.
struct FullAngles {
  double horizontal;  ///< radians
  double vertical;    ///< radians

  FullAngles(double round) : horizontal(round), vertical(round) {}
  FullAngles(double h, double v) : horizontal(h), vertical(v) {}

  bool is_round() const { return horizontal == vertical; }
  friend bool operator==(const FullAngles&, const FullAngles&) = default;
};

/// The member "cone".
struct ConeSpec {
  /// An intensity, in any unit, at an angle from the axis.
  struct Sample {
    double angle = 0;  ///< radians
    double intensity = 1;
    double weight = 1;
  };

  std::optional<ConeProfile> profile = {};  ///< absent: the best of those that can be fitted
  std::optional<double> half_angle = {};    ///< radians
  std::optional<FullAngles> beam_angle = {};
  std::optional<FullAngles> field_angle = {};
  std::vector<Sample> samples = {};
  std::optional<std::string> photometry = {};  ///< path; a relative one is prefixed with the file's folder
};

struct LightSpecText;

/// The contents of a light-spec file. Types are checked; the fits check whether a light can have the values.
struct LightSpec {
  std::string file = {};  ///< its path
  std::string name = {};
  std::vector<std::string> source = {};
  glm::dvec3 color{1.0};
  std::optional<double> color_temperature = {};  ///< kelvin, if the color was given by it
  double density_scale = 1;
  std::optional<double> source_radius = {};  ///< metres, >= 0
  Flash flash = {};
  std::optional<RangeSpec> range = {};
  std::optional<ConeSpec> cone = {};
  std::shared_ptr<const LightSpecText> text = {};  ///< the file as read, for error_at

  /// The error of a value, at its location in the file and in the file's terms, degrees for radians:
  ///
  ///     throw spec.error_at("cone.beam_angle", "6.3", "must be in (0, 2 pi]");
  ///     lamp.json:9:23: cone.beam_angle_deg = 361: must be in (0, 360]
  ///
  /// field  a member of this struct, such as "range.samples[3].attenuation"; if the file lacks it, the error is located
  ///        at the samples or at the nearest member that it is missing from
  /// value  shown if the file lacks the field; otherwise the file's own text is shown
  InputError error_at(std::string_view field, std::string_view value, std::string_view rule) const;
};

/// Reads a light-spec file.
///
/// throws  InputError with the location of what is wrong
LightSpec read_light_spec(const std::string& path);

}  // namespace litfog
