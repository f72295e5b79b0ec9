// SPDX-License-Identifier: Apache-2.0
// The smallest host: lights and changes of the visibility go in, the bytes to upload come out.
#include <litfog/updater.h>

#include <cstdio>

int main() {
  const litfog::Light runway_edge{.color = {1, 0.87, 0.7}, .attenuation = {1, 0, 0.0019}, .density_scale = 0.4};
  const litfog::Light landing_lamp{.attenuation = {1, 0, 9.5e-5}, .cone = litfog::Cone::smoothstep(0.09, 0.15)};
  litfog::FogUpdater updater;
  for (int i = 0; i < 60; ++i) updater.add({.light = runway_edge, .position = {30, 0, -60. * i}});
  updater.add({.light = landing_lamp, .position = {0, 3, 0}, .carried = true});

  for (const double visibility : {5000., 1500., 550., 200.}) {
    const auto changes = updater.set_fog(litfog::Fog::from_visibility(litfog::FogMode::exp, visibility));
    std::printf("visibility %4.0f m: %3zu bytes, landing lamp in fog %.3f\n", visibility,
                updater.statistics().bytes_dirty, double(updater.kinds()[1].cone_scale_intensity.w));
    for (const auto& [begin, end] : changes.kinds) std::printf("  upload kinds [%zu, %zu)\n", begin, end);
    for (const auto& [begin, end] : changes.instances) std::printf("  upload instances [%zu, %zu)\n", begin, end);
  }
}
