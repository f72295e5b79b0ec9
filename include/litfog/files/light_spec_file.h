// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "litfog/attenuation.h"
#include "litfog/files/output_error.h"
#include "litfog/input_error.h"

namespace litfog {

// clang-format off
/// Light-spec files, version 1: what a light's data sheet says, for litfog-fit to make a light of.
///
///     {
///       "litfog": "light-spec",
///       "version": 1,
///       "name": "landing lamp",                 optional: the file's name without its ending
///       "source": "where the figures are from", optional, or an array of such; the light's
///       "color": [1, 0.9, 0.8],                 optional: white; the light's; or
///       "color_temperature_k": 3200,            instead: 1000 to 25000 (litfog/color_temperature.h)
///       "density_scale": 0.4,                   optional: 1; the light's
///       "range": {                              optional, and each member of it, but not an extent and samples both
///         "threshold": 0.05,                    the light's
///         "extent_m": 120,                      where the attenuation is to be the threshold, met exactly; or instead
///         "end_lx": 1,                          where the light gives that much, from its peak; or what an eye just
///                                               sees of it (ICAO Annex 3, attachment D): "night" (8e-7), "twilight"
///                                               (1e-5), "day" (1e-4) or "bright day" (1e-3); default: 1
///         "peak_cd": 12000,                     default: that of the cone's photometry; or instead
///         "illuminance": {"range_m": 10, "lx": 120},     on the axis in clear air: the peak is lx * range_m^2
///         "constant": 1,                        C, to be kept
///         "family": "quadratic",                of an extent alone: quadratic, linear or mixed (half and half)
///         "samples": [{"range_m": 10, "attenuation": 0.8, "weight": 1}]      by increasing range; weight optional
///       },
///       "cone": {                               optional: a point light; each member optional, but not all angles,
///                                               samples and photometry
///         "profile": "best",                    best (of both), cosine or smoothstep
///         "half_angle_deg": 30,                 where the light ends
///         "beam_angle_deg": 11,                 full angle at 50 % of the peak
///         "field_angle_deg": 22,                full angle at 10 %
///         "samples": [{"angle_deg": 0, "intensity": 1, "weight": 1}],        by increasing angle; weight optional
///         "photometry": "lamp.ies"              in place of samples: IES LM-63 or EULUMDAT, relative to this file;
///                                               without a range the light ends where its peak gives 1 lx
///       }
///     }
///
/// It has a range, a cone or both. JSON of at most 64 MiB. Nothing here depends on the locale.
// clang-format on

/// The member "range".
struct RangeSpec {
  enum class Family { quadratic, linear, mixed };
  struct Sample {
    double range = 0;  ///< metres
    double attenuation = 1;
    double weight = 1;
  };

  double threshold = kDefaultThreshold;
  std::optional<double> extent = {};           ///< metres
  std::optional<double> end_illuminance = {};  ///< lux, > 0; not beside an extent
  std::optional<double> peak = {};             ///< candela, > 0; not beside an extent
  std::optional<double> constant = {};
  Family family = Family::quadratic;
  std::vector<Sample> samples = {};
};

/// The member "cone".
struct ConeSpec {
  enum class Profile { best, cosine, smoothstep };
  struct Sample {
    double angle = 0;  ///< radians
    double intensity = 1;
    double weight = 1;
  };

  Profile profile = Profile::best;
  std::optional<double> half_angle = {};   ///< radians
  std::optional<double> beam_angle = {};   ///< radians
  std::optional<double> field_angle = {};  ///< radians
  std::vector<Sample> samples = {};
  std::optional<std::string> photometry = {};  ///< a path: the file's own folder stands before a relative one
};

struct LightSpecText;

/// What a light-spec file says. Its figures are of the right types; whether a light can have them is for the fits to
/// say.
struct LightSpec {
  std::string file = {};  ///< its path
  std::string name = {};
  std::vector<std::string> source = {};
  glm::dvec3 color{1.0};
  std::optional<double> color_temperature = {};  ///< kelvin, of which the color was made
  double density_scale = 1;
  std::optional<RangeSpec> range = {};
  std::optional<ConeSpec> cone = {};
  std::shared_ptr<const LightSpecText> text = {};  ///< the file as read, for error_at

  /// What is wrong with a value of this spec, at its location in the file and in the file's terms, degrees for radians:
  ///
  ///     throw spec.error_at("cone.beam_angle", "6.3", "must be in (0, 2 pi]");
  ///     lamp.json:9:23: cone.beam_angle_deg = 361: must be in (0, 360]
  ///
  /// field  a member of this struct, as in "range.samples[3].attenuation"; if the file lacks it, the error is at the
  ///        samples or at the nearest member that it is missing from
  /// value  to show if the file lacks the field; else its own text is shown
  InputError error_at(std::string_view field, std::string_view value, std::string_view rule) const;
};

/// Reads a light-spec file.
///
/// throws  InputError with the location of what is wrong
LightSpec read_light_spec(const std::string& path);

/// A spec as the text of its file. Numbers are read back exactly, except angles that no double in degrees stands for,
/// which are off by their last bit. A photometric file in the folder of spec.file is named from there, another by its
/// absolute path.
std::string format_light_spec(const LightSpec& spec);

/// Writes a light-spec file atomically: an earlier file stays as it was when anything fails. spec.file need not be the
/// path.
///
/// throws  InputError for a spec that read_light_spec would not take, before anything is written; OutputError
void write_light_spec(const std::string& path, LightSpec spec);

}  // namespace litfog
