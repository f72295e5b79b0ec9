// SPDX-License-Identifier: Apache-2.0
#include "litfog/files/phase_name.h"

#include "text/number_text.h"

namespace litfog::files {
namespace {

/// The number after a prefix; nothing where the text is not the prefix and a number.
std::optional<double> number_after(std::string_view prefix, std::string_view text) {
  return text.starts_with(prefix) ? whole_number(text.substr(prefix.size())) : std::nullopt;
}

}  // namespace

std::optional<Phase> phase_named(std::string_view name) {
  if (name == "isotropic") return Phase{};
  if (const auto asymmetry = number_after("hg:", name)) {
    const Phase phase = Phase::henyey_greenstein(*asymmetry);
    return find_error(phase) ? std::nullopt : std::optional(phase);
  }
  const auto diameter = number_after("droplets:", name);
  if (!diameter || !(*diameter >= kSmallestDroplets && *diameter <= kLargestDroplets)) return std::nullopt;
  return Phase::droplets(*diameter);
}

}  // namespace litfog::files
