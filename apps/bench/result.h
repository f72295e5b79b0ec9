// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "command/plot.h"
#include "command/table.h"

namespace litfog::bench {

/// What a benchmark found.
struct Result {
  command::Table table;
  command::Figure figure;             ///< without charts for a benchmark that draws none
  std::string gl_renderer = "none";   ///< what drew
  std::vector<std::string> failures;  ///< sentences: where litfog itself missed an error that it states
};

}  // namespace litfog::bench
