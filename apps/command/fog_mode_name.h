// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "litfog/fog.h"

namespace litfog::command {

/// The mode's name in options, files and tables.
inline const char* fog_mode_name(FogMode mode) { return mode == FogMode::exp ? "exp" : "exp2"; }

/// The inverse; nothing for any other word.
inline std::optional<FogMode> parse_fog_mode(std::string_view text) {
  for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
    if (text == fog_mode_name(mode)) return mode;
  }
  return std::nullopt;
}

}  // namespace litfog::command
