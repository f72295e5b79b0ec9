// SPDX-License-Identifier: Apache-2.0
#include "bench/simd_target.h"

// highway.h says which targets are compiled.
#include <hwy/highway.h>
#include <hwy/targets.h>

#include <cassert>

namespace litfog::bench {

std::vector<std::string> simd_targets() {
  std::vector<std::string> names;
  for (const auto target : hwy::SupportedAndGeneratedTargets()) names.emplace_back(hwy::TargetName(target));
  return names;
}

std::string simd_target() { return simd_targets().front(); }

void limit_simd_target(const std::string& name) {
  for (const auto target : hwy::SupportedAndGeneratedTargets()) {
    if (hwy::TargetName(target) != name) continue;
    hwy::DisableTargets(target - 1);  // better targets are lower bits
    return;
  }
  assert(false);
}

}  // namespace litfog::bench
