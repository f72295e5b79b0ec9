// SPDX-License-Identifier: Apache-2.0
#include <litfog/solve.h>

#include <cmath>
#include <cstdio>

int main() {
  const litfog::Fog fog{litfog::FogMode::exp, std::log(4 / 3.) / 6};  // takes a quarter over six metres
  const auto solved = litfog::solve_fog_intensity({.constant = 1, .linear = 0.5, .quadratic = 0}, fog, 0.25);
  std::printf("%.4g at %.4g of %g\n", solved.intensity, solved.peak_range, solved.extent);
}
