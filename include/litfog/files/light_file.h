// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "litfog/files/output_error.h"
#include "litfog/input_error.h"
#include "litfog/light.h"

namespace litfog {

// clang-format off
/// Light files, version 1:
///
///     {
///       "litfog": "light",
///       "version": 1,
///       "name": "landing lamp",               optional: the file's name without its ending
///       "source": "where the figures are from", optional, or an array of such; for people only
///       "color": [1, 0.9, 0.8],               optional: white
///       "attenuation": {"constant": 1, "linear": 0, "quadratic": 9.5e-5},  each 0 where absent, not all 0
///       "threshold": 0.05,                    optional
///       "cone": {"profile": "cosine", "half_angle_deg": 15, "exponent": 75},  optional: a point light
///               {"profile": "smoothstep", "inner_deg": 5, "outer_deg": 15}
///       "density_scale": 0.4,                 optional: 1
///       "source_radius_m": 0.05,              optional: 0, unknown; above 0, pictures by airlight show the light by
///                                             photometric()
///       "flash": {"period_s": 2,              optional: a lamp that is dark except in at most 8 flashes per period
///                 "flashes": [{"start_s": 0, "duration_s": 0.05, "intensity": 5}]},  intensity: 1, times the colour
///       "fit": {...}                          optional: how litfog-fit found the figures; ignored
///     }
///
/// JSON of at most 64 MiB. Nothing here depends on the locale.
// clang-format on

/// Reads a light file:
///
///     const litfog::Light headlight = litfog::read_light("headlight.json");
///
/// throws  InputError with the location of what is wrong: "headlight.json:7:12: threshold = 7: must be in (0, 1)"
Light read_light(const std::string& path);

/// A light as the text of its file. Numbers read back exactly, except angles that no double in degrees represents,
/// which are off by their last bit.
///
/// light   must pass find_error(); not checked here
/// source  lines of the member "source", which is left out if there are none
/// fit     JSON text of the member "fit"; empty: left out
std::string format_light(const Light& light, const std::vector<std::string>& source = {}, std::string_view fit = {});

/// Writes a light file atomically: if anything fails, an earlier file stays as it was.
///
/// throws  std::invalid_argument for a light that find_error() refuses; OutputError
void write_light(const std::string& path, const Light& light, const std::vector<std::string>& source = {});

}  // namespace litfog
