// SPDX-License-Identifier: Apache-2.0
#include <litfog/photometry/luminaire.h>

#include <cstdio>

int main() {
  const litfog::Luminaire lamp{.distribution = {.horizontal = {0}, .vertical = {0, 1}, .intensity = {100, 0}}};
  std::printf("%.4g lm\n", luminous_flux(lamp.distribution));  // 200 pi (1 - sin 1)
}
