// SPDX-License-Identifier: Apache-2.0
#include <litfog/c/litfog.h>
#include <stdio.h>

int main(int count, char** arguments) {
  litfog_light lamp;
  char name[64];
  if (count != 2 || litfog_read_light(arguments[1], &lamp, name, sizeof name) != LITFOG_OK) {
    fprintf(stderr, "%s\n", litfog_last_error());
    return 2;
  }
  const litfog_fog fog = {LITFOG_FOG_EXP, 0.1};
  litfog_fog_intensity solution;
  if (litfog_solve(&lamp, &fog, &solution) != LITFOG_OK) return 1;
  printf("litfog %s: %s ends at %g m\n", litfog_version(), name, solution.extent);
  return 0;
}
