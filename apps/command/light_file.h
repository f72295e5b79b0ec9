// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "command/json_document.h"
#include "litfog/light.h"

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
///       "density_scale": 0.4                  optional: 1
///       "fit": {...}                          optional: how litfog-fit found the figures (fit/fit_record.h); passed
///       over
///     }

/// Reads a light file. Throws BadInput.
litfog::Light read_light(const std::string& path);

/// A light within another file; there "litfog", "version" and "name" may be left out.
litfog::Light parse_light(const JsonValue& value);

/// Refuses a member of a light that is in an object of another kind of file, at its place.
[[noreturn]] void fail_light(const JsonValue& value, const litfog::ValueError& refusal);

/// A light as the text of its file: numbers are read back exactly, but for angles that no number of degrees stands for,
/// which are off by their last bit. fit is the JSON text of that member, or empty.
std::string format_light(const litfog::Light& light, const std::vector<std::string>& source, std::string_view fit);
