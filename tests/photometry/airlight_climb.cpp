// SPDX-License-Identifier: Apache-2.0
// litfog_airlight_climb [STARTS STEPS [SEED]]: searches for the largest errors of the airlight by climbing, from 12
// starts of 600 steps for each kind of lamp, fog and scattering, or as many as are given. Prints a row a kind and exits
// with 1 where an error exceeds the stated one.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <string>

#include "litfog/photometry/cookie_airlight.h"
#include "photometry/smooth_cookie.h"
#include "reference/airlight_climb.h"

namespace litfog::test {
namespace {

/// The error of the airlight of a case, of the lamp's colour or of the airlight where that is brighter.
double error_of(const AirlightCase& c, const Cookie* cookie) {
  double fast, expected;
  if (cookie != nullptr) {
    const glm::dvec3& axis = c.light.direction;
    const glm::dvec3 right =
        glm::normalize(glm::cross(axis, std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
    const glm::dmat3 turn = glm::transpose(glm::dmat3(right, glm::cross(right, axis), -axis));
    fast = airlight(c.light, *cookie, turn, c.atmosphere, c.ray, c.lamp_leg);
    expected = reference_airlight(c.light, *cookie, turn, c.atmosphere, c.ray, c.lamp_leg);
  } else {
    fast = airlight(c.light, c.atmosphere, c.ray, c.lamp_leg);
    expected = reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg);
  }
  return std::abs(fast - expected) / std::max(expected, 1.0);
}

/// Whether the errors of a kind are as stated.
bool check(const ClimbKind& kind, int starts, int steps, std::uint64_t seed, const Cookie& cookie) {
  const bool is_cookie = kind.shape == LampShape::cookie;
  Random random(seed);
  ClimbResult worst;
  for (int i = 0; i < starts; ++i) {
    const ClimbResult found = climb_airlight(
        random, kind, steps, [&](const AirlightCase& c) { return error_of(c, is_cookie ? &cookie : nullptr); });
    if (found.error > worst.error) worst = found;
  }
  const double bound = is_cookie ? kCookieAirlightMaxError : kAirlightMaxError;
  const bool is_good = worst.error <= bound;
  std::printf("%-60s largest error %.3f/255%s%s\n", to_string(kind).c_str(), 255 * worst.error,
              is_good ? "" : ", stated less: ", is_good ? "" : to_string(worst.at).c_str());
  std::fflush(stdout);
  return is_good;
}

bool check_all(int starts, int steps, std::uint64_t seed) {
  const Cookie cookie = make_smooth_cookie();
  bool is_good = true;
  for (const LampShape shape : {LampShape::point, LampShape::cosine, LampShape::smoothstep, LampShape::cookie}) {
    for (const bool is_directional : {false, true}) {
      for (const FogMode mode : kModes) {
        for (const LampLeg leg : kLampLegs) {
          is_good &= check({shape, is_directional, mode, leg}, starts, steps, seed++, cookie);
        }
      }
    }
  }
  return is_good;
}

}  // namespace
}  // namespace litfog::test

int main(int argc, char** argv) {
  const int starts = argc > 2 ? std::atoi(argv[1]) : 12;
  const int steps = argc > 2 ? std::atoi(argv[2]) : 600;
  const int seed = argc > 3 ? std::atoi(argv[3]) : 1;
  if (argc == 2 || argc > 4 || starts < 1 || steps < 1 || seed < 0) {
    std::fprintf(stderr, "usage: litfog_airlight_climb [STARTS STEPS [SEED]]\n");
    return 1;
  }
  return litfog::test::check_all(starts, steps, std::uint64_t(seed)) ? 0 : 1;
}
