// SPDX-License-Identifier: Apache-2.0
#include <litfog/solve.h>
#include <litfog/updater.h>

#include <cmath>
#include <cstdio>

int main() {
  const litfog::Fog fog{litfog::FogMode::exp, std::log(4 / 3.) / 6};  // takes a quarter over six metres
  const auto solved = litfog::solve_fog_intensity({.constant = 1, .linear = 0.5, .quadratic = 0}, fog, 0.25);
  std::printf("%.4g at %.4g of %g\n", solved.intensity, solved.peak_range, solved.extent);

  litfog::FogUpdater updater;
  for (const double x : {0., 1., 2.}) {
    updater.add({.light = {.attenuation = {1, 0.5, 0}, .threshold = 0.25}, .position = {x, 0, 0}, .carried = true});
  }
  const litfog::FogLightChanges changes = updater.set_fog(fog);
  std::printf("%zu lights of %zu kind: %.4g\n", changes.instances[0].end, changes.kinds[0].end,
              double(updater.kinds()[0].cone_scale_intensity.w));
}
