// SPDX-License-Identifier: Apache-2.0
#include "litfog/phase.h"

#include <algorithm>

#include "model/phase_text.h"

namespace litfog {

std::optional<ValueError> find_error(const Phase& phase) {
  if (!(phase.asymmetry > -1 && phase.asymmetry < 1)) return ValueError{"asymmetry", phase.asymmetry, kAsymmetryRule};
  return std::nullopt;
}

bool is_isotropic(const Phase& phase) { return phase_text::litfog_is_isotropic(phase); }

double phase_at(const Phase& phase, double cosine) { return phase_text::litfog_phase(phase, cosine); }

double largest_phase(const Phase& phase, double lowest, double highest) {
  return phase_text::litfog_largest_phase(phase, lowest, highest);
}

PhaseF to_floats(const Phase& phase) {
  constexpr float kMax = 0x1.fffffep-1f;
  return {.asymmetry = std::clamp(float(phase.asymmetry), -kMax, kMax)};
}

}  // namespace litfog
