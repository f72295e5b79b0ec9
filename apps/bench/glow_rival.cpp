// SPDX-License-Identifier: Apache-2.0
#include "bench/glow_rival.h"

#include <cmath>
#include <limits>

namespace litfog::bench {

double apsf_glow(double mean_cosine, double depth, double angle) {
  if (!(depth > 1)) return std::numeric_limits<double>::quiet_NaN();
  const auto weight = [=](int m) {
    if (m == 0) return 0.0;
    const double beta = (2.0 * m + 1) / m * (1 - std::pow(mean_cosine, m - 1));
    return std::exp(-beta * depth - (m + 1) * std::log(depth));
  };
  constexpr double kSmallest = 1e-9;  // of the first weight
  const double cosine = std::cos(angle);
  double sum = 0, legendre = 1, next = cosine;
  for (int m = 0; m == 0 || weight(m) > kSmallest * weight(1); ++m) {
    sum += (weight(m) + weight(m + 1)) * legendre;
    const double after = ((2 * m + 3) * cosine * next - (m + 1) * legendre) / (m + 2);
    legendre = next;
    next = after;
  }
  // The net flux is 4 pi / 3 of the second coefficient; that of the lamp, in this unit, 4 pi / depth^2.
  return 3 * sum / (weight(1) + weight(2)) / (depth * depth);
}

double gaussian_glow(double mean_cosine, double depth, double angle) {
  const double scattered = -std::expm1(-depth);
  const double square_angle = 2 / 3. * (1 - mean_cosine) * depth / scattered;
  return 4 * scattered / (depth * depth * square_angle) * std::exp(-angle * angle / square_angle);
}

double octave_glow(const Phase& phase, double depth, double angle, int steps) {
  constexpr int kOctaves = 3;
  constexpr double kReach = 9.2;
  const double approach = depth * std::cos(angle), offset = depth * std::sin(angle), step = kReach / steps;
  Phase flattened = phase;
  double density = 1, sum = 0;
  for (int octave = 0; octave < kOctaves; ++octave) {
    for (int i = 0; i < steps; ++i) {
      const double x = (i + 0.5) * step - approach, r = std::hypot(x, offset);
      const double opacity = std::exp(-density * step * i) - std::exp(-density * step * (i + 1));
      sum += opacity * std::exp(-density * r) / (r * r) * phase_at(flattened, -x / r);
    }
    density /= 2;
    flattened.first.asymmetry /= 2;
    flattened.second.asymmetry /= 2;
  }
  return sum;
}

}  // namespace litfog::bench
