// SPDX-License-Identifier: Apache-2.0
#include <litfog/fit/attenuation_fit.h>

#include <cstdio>

int main() {
  const auto fit = litfog::fit_attenuation({.threshold = 0.25, .extent = 6, .samples = {{2, 0.5}, {4, 0.3}}});
  std::printf("%.4g %.4g\n", litfog::compute_extent(fit.attenuation, 0.25), litfog::attenuation_at(fit.attenuation, 2));
}
