// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "litfog/photometry/cookie.h"

namespace litfog::test {

/// A beam of cos^4 that is flatter than it is wide: as fine as a cookie may be for kCookieAirlightMaxError.
inline Cookie make_smooth_cookie() {
  return make_cookie(64, [](const glm::dvec3& direction) {
    const glm::dvec3 d = glm::normalize(direction * glm::dvec3(0.7, 1, 1));
    return std::pow(std::max(-d.z, 0.0), 4);
  });
}

}  // namespace litfog::test
