// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "files/json_document.h"
#include "litfog/density_profile.h"

namespace litfog::scene {

/// Layers of fog as scene files state them, in metres. Throws InputError, also if together they need more knots than a
/// profile has.
///
///     [{"base_m": 200, "top_m": 300,     optional: without base or top
///       "transition_m": 40,              optional: 0
///       "visibility_m": 150}]            within the layer
std::vector<FogLayer> read_fog_layers(const files::JsonValue& value);

/// The layers of a file that holds such an array. Throws InputError.
std::vector<FogLayer> read_fog_layers(const std::string& path);

}  // namespace litfog::scene
