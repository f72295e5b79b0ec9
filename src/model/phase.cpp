// SPDX-License-Identifier: Apache-2.0
#include "litfog/phase.h"

#include <algorithm>
#include <cmath>

#include "model/phase_text.h"
#include "model/require.h"

namespace litfog {
namespace {

constexpr double kAlpha[] = {3.62489, 8.29288, 5.52825};  // of the first lobe's alpha, which varies most

}  // namespace

Phase Phase::droplets(double micrometres) {
  const double d = micrometres;
  if (!(d >= kSmallestDroplets && d <= kLargestDroplets)) require(ValueError{"micrometres", d, "must be in [5, 50]"});
  return {.first = {.asymmetry = std::exp(-2.20679 / (d + 3.91029) - 0.428934),
                    .alpha = std::exp(kAlpha[0] - kAlpha[1] / (d + kAlpha[2]))},
          .second = {.asymmetry = std::exp(-0.0990567 / (d - 1.67154))},
          .weight = std::exp(-0.599085 / (d - 0.641583) - 0.665888)};
}

std::optional<double> droplet_diameter(const Phase& phase) {
  const double d = kAlpha[1] / (kAlpha[0] - std::log(phase.first.alpha)) - kAlpha[2];
  if (!(d > kSmallestDroplets - 1 && d < kLargestDroplets + 1)) return std::nullopt;
  const double diameter = std::clamp(d, kSmallestDroplets, kLargestDroplets);
  const Phase found = Phase::droplets(diameter);
  const auto is_near = [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(b); };
  const bool is_found = is_near(phase.first.asymmetry, found.first.asymmetry) &&
                        is_near(phase.first.alpha, found.first.alpha) &&
                        is_near(phase.second.asymmetry, found.second.asymmetry) && phase.second.alpha == 0 &&
                        is_near(phase.weight, found.weight);
  return is_found ? std::optional(diameter) : std::nullopt;
}

std::optional<ValueError> find_error(const PhaseLobe& lobe) {
  if (!(lobe.asymmetry > -1 && lobe.asymmetry < 1)) return ValueError{"asymmetry", lobe.asymmetry, kAsymmetryRule};
  if (!(lobe.alpha >= 0 && lobe.alpha <= 1e6)) return ValueError{"alpha", lobe.alpha, "must be in [0, 1e6]"};
  return std::nullopt;
}

std::optional<ValueError> find_error(const Phase& phase) {
  if (const auto error = find_error(phase.first)) return error;
  if (const auto error = find_error(phase.second)) return error;
  if (!(phase.weight >= 0 && phase.weight <= 1)) return ValueError{"weight", phase.weight, "must be in [0, 1]"};
  return std::nullopt;
}

bool is_isotropic(const Phase& phase) { return phase_text::litfog_is_isotropic(phase_text::pack<double>(phase)); }

double phase_at(const Phase& phase, double cosine) {
  return phase_text::litfog_phase(phase_text::pack<double>(phase), 1 - cosine);
}

double largest_phase(const Phase& phase, double lowest, double highest) {
  return phase_text::litfog_largest_phase(phase_text::pack<double>(phase), 1 - highest, 1 - lowest);
}

double mean_cosine(const Phase& phase) {
  const auto of_lobe = [](const PhaseLobe& lobe) {
    const auto [g, alpha] = lobe;
    return g * (1 + alpha * (3 + 2 * g * g) / 5) / (1 + alpha * (1 + 2 * g * g) / 3);
  };
  return phase.weight * of_lobe(phase.first) + (1 - phase.weight) * of_lobe(phase.second);
}

}  // namespace litfog
