// SPDX-License-Identifier: Apache-2.0
#include "litfog/files/phase_name.h"

#include <algorithm>
#include <cmath>

#include "text/number_text.h"

namespace litfog::files {
namespace {

/// The number after a prefix; nothing where the text is not the prefix and a number.
std::optional<double> number_after(std::string_view prefix, std::string_view text) {
  return text.starts_with(prefix) ? whole_number(text.substr(prefix.size())) : std::nullopt;
}

std::optional<PhaseLobe> lobe_named(std::string_view name) {
  PhaseLobe lobe;
  if (name == "rayleigh") {
    lobe.alpha = 1;
  } else if (const auto asymmetry = number_after("hg:", name)) {
    lobe.asymmetry = *asymmetry;
  } else if (name != "isotropic") {
    const std::size_t comma = std::min(name.find(','), name.size());
    const auto of_draine = number_after("draine:", name.substr(0, comma));
    const auto alpha = number_after(",", name.substr(comma));
    if (!of_draine || !alpha) return std::nullopt;
    lobe = {.asymmetry = *of_draine, .alpha = *alpha};
  }
  return find_error(Phase{.first = lobe}) ? std::nullopt : std::optional(lobe);
}

struct WeightedLobe {
  double weight;
  PhaseLobe lobe;
};

std::optional<WeightedLobe> weighted_lobe_named(std::string_view name) {
  const std::size_t star = std::min(name.find('*'), name.size());
  const auto weight = whole_number(name.substr(0, star));
  const auto lobe = lobe_named(name.substr(std::min(star + 1, name.size())));
  return weight && lobe ? std::optional(WeightedLobe{*weight, *lobe}) : std::nullopt;
}

}  // namespace

std::optional<Phase> phase_named(std::string_view name) {
  if (const auto lobe = lobe_named(name)) return Phase{.first = *lobe};
  if (const auto diameter = number_after("droplets:", name)) {
    const bool is_stated = *diameter >= kSmallestDroplets && *diameter <= kLargestDroplets;
    return is_stated ? std::optional(Phase::droplets(*diameter)) : std::nullopt;
  }
  constexpr auto kNone = std::string_view::npos;
  for (std::size_t plus = name.find('+'); plus != kNone; plus = name.find('+', plus + 1)) {  // a number's, too: 1e+3
    const auto first = weighted_lobe_named(name.substr(0, plus)), second = weighted_lobe_named(name.substr(plus + 1));
    if (!first || !second || !(std::abs(first->weight + second->weight - 1) <= kPhaseWeightTolerance)) continue;
    const Phase phase{.first = first->lobe, .second = second->lobe, .weight = first->weight};
    return find_error(phase) ? std::nullopt : std::optional(phase);
  }
  return std::nullopt;
}

}  // namespace litfog::files
