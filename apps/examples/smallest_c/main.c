// SPDX-License-Identifier: Apache-2.0
// The smallest host in C: lights and changes of the visibility go in, the bytes to upload come out.
#include <litfog/c/litfog.h>
#include <stdio.h>
#include <stdlib.h>

static void require(litfog_status status) {
  if (status == LITFOG_OK) return;
  fprintf(stderr, "%s\n", litfog_last_error());
  exit(1);
}

int main(void) {
  litfog_updater* updater;
  litfog_light_handle handle;
  litfog_placed_light light;
  require(litfog_updater_create(LITFOG_DEFAULT_SKIP_BUDGET_255, &updater));
  require(litfog_default_placed_light(&light));
  light.light =
      (litfog_light){{1, 0.87, 0.7}, {1, 0, 0.0019}, LITFOG_DEFAULT_THRESHOLD, {LITFOG_CONE_NONE, 0, 0, 0, 0}, 0.4};
  for (int i = 0; i < 60; ++i) {  // runway edge
    light.position[0] = 30;
    light.position[2] = -60. * i;
    require(litfog_updater_add(updater, &light, &handle));
  }
  require(litfog_default_placed_light(&light));  // landing lamp
  light.light.attenuation.quadratic = 9.5e-5;
  light.light.cone = (litfog_cone){.profile = LITFOG_CONE_SMOOTHSTEP, .inner = 0.09, .outer = 0.15};
  light.position[1] = 3;
  light.carried = 1;
  require(litfog_updater_add(updater, &light, &handle));

  const double visibilities[] = {5000, 1500, 550, 200};
  for (int i = 0; i < 4; ++i) {
    litfog_fog fog;
    litfog_fog_light_changes changes;
    litfog_fog_light_tables tables;
    litfog_fog_update_statistics statistics;
    require(litfog_fog_from_visibility(LITFOG_FOG_EXP, visibilities[i], LITFOG_CONTRAST_MOR, &fog));
    require(litfog_updater_set_fog(updater, &fog, &changes));
    require(litfog_updater_tables(updater, &tables));
    require(litfog_updater_statistics(updater, &statistics));
    printf("visibility %4.0f m: %3zu bytes, landing lamp in fog %.3f\n", visibilities[i], statistics.bytes_dirty,
           (double)tables.kinds[1].cone_scale_intensity[3]);
    for (size_t k = 0; k < changes.kind_count; ++k) {
      printf("  upload kinds [%zu, %zu)\n", changes.kinds[k].begin, changes.kinds[k].end);
    }
    for (size_t k = 0; k < changes.instance_count; ++k) {
      printf("  upload instances [%zu, %zu)\n", changes.instances[k].begin, changes.instances[k].end);
    }
  }
  litfog_updater_destroy(updater);
}
