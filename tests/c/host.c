// SPDX-License-Identifier: Apache-2.0
// A host in C99 that goes through the whole C face once. Ends with 1 and the line of the first thing that is wrong.
#include <litfog/c/litfog.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPECT(condition)                                                                               \
  do {                                                                                                  \
    if (!(condition)) {                                                                                 \
      fprintf(stderr, "%s:%d: %s is false; %s\n", __FILE__, __LINE__, #condition, litfog_last_error()); \
      exit(1);                                                                                          \
    }                                                                                                   \
  } while (0)
#define EXPECT_OK(call) EXPECT((call) == LITFOG_OK)

static litfog_placed_light landing_lamp(void) {
  litfog_placed_light light;
  EXPECT_OK(litfog_default_placed_light(&light));
  light.light.attenuation.quadratic = 9.5e-5;
  light.light.cone.profile = LITFOG_CONE_SMOOTHSTEP;
  light.light.cone.inner = 0.1;
  light.light.cone.outer = 0.3;
  light.carried = 1;
  EXPECT_OK(litfog_check_placed_light(&light));
  return light;
}

static litfog_fog fog_of(double visibility) {
  litfog_fog fog;
  EXPECT_OK(litfog_fog_from_visibility(LITFOG_FOG_EXP, visibility, LITFOG_CONTRAST_MOR, &fog));
  EXPECT_OK(litfog_check_fog(&fog));
  return fog;
}

static void solve(void) {
  const litfog_placed_light light = landing_lamp();
  const litfog_fog fog = fog_of(1500);
  litfog_fog_intensity exact, sampled;
  EXPECT_OK(litfog_check_light(&light.light));
  EXPECT_OK(litfog_solve(&light.light, &fog, &exact));
  EXPECT(exact.status == LITFOG_SOLVE_OK && fabs(exact.intensity - 0.093) < 5e-4 && exact.peak_range < exact.extent);
  EXPECT_OK(litfog_sample(&light.light, &fog, 64, &sampled));
  EXPECT(sampled.intensity <= exact.intensity && sampled.intensity > exact.intensity - 0.024);

  double axial, ahead, reach;
  const litfog_atmosphere air = {fog, {{0, 0}, {0, 0}, 1}, 1, INFINITY, {0, 0, 0}, {{{0, 0}}, 0}};
  litfog_eye_ray ray = {{0, 0, 0}, {0, 0, -1}, INFINITY};
  EXPECT_OK(litfog_check_atmosphere(&air));
  EXPECT_OK(litfog_axial_airlight(&light.light, &fog, &axial));
  EXPECT(axial >= exact.intensity);
  EXPECT_OK(litfog_airlight(&light, &air, &ray, 1, LITFOG_LAMP_LEG_FOGGED, &ahead));
  EXPECT(ahead > 0 && ahead < axial);  // the lamp's own leg is fogged
  litfog_scattering_table table;
  double more;
  EXPECT_OK(litfog_make_scattering_table(&air, &table));
  EXPECT_OK(litfog_multiple_scattering(&light, &air, &table, &ray, 1, &more));
  EXPECT(more > 0);

  litfog_thin_beams beams;
  litfog_scattering_source source;
  litfog_diffuse_light scattered[2];
  const double places[] = {0, 0, 9, 0, 0, -9}, facing[] = {0, 0, -1};
  double received;
  EXPECT_OK(litfog_make_thin_beams(&air, &table, &beams));
  EXPECT_OK(litfog_make_scattering_source(&light.light, &air, &beams, &source));
  EXPECT(source.is_cone && source.intensity > 0);
  EXPECT_OK(litfog_scattered_light(&light, &source, &air, places, 2, scattered));
  EXPECT_OK(litfog_irradiance(&scattered[0], facing, &received));
  EXPECT(received > 0 && scattered[1].all > scattered[0].all);  // it shines to the second place

  const litfog_atmosphere ground = {fog, {{0, 0}, {0, 0}, 1}, 1, 50, {0, 0, 0}, {{{0, 0}}, 0}};
  const double to_sun[] = {0, 1, 0};
  double sunlit, left;
  EXPECT_OK(litfog_directional_airlight(&ground, to_sun, &ray, 1, &sunlit));
  EXPECT_OK(litfog_directional_fog_factor(&ground, to_sun, 0, &left));
  EXPECT(fabs(sunlit - left) < 1e-12);  // a level ray without end
  EXPECT_OK(litfog_light_reach(&light.light, &fog, 1. / 255, LITFOG_LAMP_LEG_FOGGED, &reach));
  EXPECT(reach > 0 && reach <= exact.extent);
}

static void convert_runway_visual_range(void) {
  litfog_fog fog;
  double metres, threshold;
  EXPECT_OK(litfog_illuminance_threshold(10, &threshold));
  EXPECT_OK(litfog_fog_from_runway_visual_range(LITFOG_FOG_EXP, 550, 10000, threshold, &fog));
  EXPECT_OK(litfog_runway_visual_range(&fog, 10000, threshold, &metres));
  EXPECT(fabs(metres - 550) < 1e-9);
}

static void solve_batch(void) {
  const double constant[] = {1, 1, -1}, linear[] = {0, 0.5, 0}, quadratic[] = {9.5e-5, 0, 1}, threshold = 0.05;
  const double density = fog_of(1500).density;
  const litfog_batch_lights lights = {3, constant, linear, quadratic, &threshold, 1, &density, 1};
  double intensity[3];
  uint8_t status[3];
  const litfog_batch_solutions solutions = {intensity, NULL, NULL, status};
  size_t invalid = 0;
  EXPECT_OK(litfog_solve_batch(LITFOG_FOG_EXP, &lights, &solutions, &invalid));
  EXPECT(invalid == 1 && status[1] == LITFOG_SOLVE_OK && status[2] == LITFOG_SOLVE_INVALID && intensity[2] == 0);
}

static void update(void) {
  litfog_updater* updater;
  litfog_light_handle lamp, other;
  litfog_placed_light light = landing_lamp();
  EXPECT_OK(litfog_updater_create(LITFOG_DEFAULT_SKIP_BUDGET_255, &updater));
  EXPECT_OK(litfog_updater_add(updater, &light, &lamp));
  light.position[0] = 3;
  EXPECT_OK(litfog_updater_add(updater, &light, &other));

  litfog_fog_light_changes changes;
  litfog_fog fog = fog_of(1500);
  EXPECT_OK(litfog_updater_set_fog(updater, &fog, &changes));
  EXPECT(changes.kind_count == 1 && changes.kinds[0].end == 1);
  EXPECT(changes.instance_count == 1 && changes.instances[0].end == 2);
  litfog_fog_light_tables tables;
  EXPECT_OK(litfog_updater_tables(updater, &tables));
  EXPECT(tables.kind_count == 1 && tables.instance_count == 2 && tables.instances[1].position_kind[0] == 3);

  fog = fog_of(500);
  EXPECT_OK(litfog_updater_set_fog(updater, &fog, &changes));
  EXPECT(changes.kind_count == 1 && changes.instance_count == 0);  // a step of the visibility touches kinds alone
  litfog_fog_update_statistics statistics;
  EXPECT_OK(litfog_updater_statistics(updater, &statistics));
  EXPECT(statistics.kinds_solved == 1 && statistics.bytes_dirty == sizeof(litfog_fog_light_kind));

  const litfog_fog_light_source* sources;
  size_t source_count;
  EXPECT_OK(litfog_updater_solve_sources(updater));
  EXPECT_OK(litfog_updater_set_fog(updater, &fog, &changes));
  EXPECT(changes.kind_count == 0 && changes.source_count == 1);
  EXPECT_OK(litfog_updater_sources(updater, &sources, &source_count));
  EXPECT(source_count == 1 && sources[0].intensity > 0 && sources[0].soft_range > 0);

  size_t instance, kind;
  EXPECT_OK(litfog_updater_instance_of(updater, other, &instance));
  EXPECT_OK(litfog_updater_kind_of(updater, other, &kind));
  EXPECT(instance == 1 && kind == 0);
  EXPECT_OK(litfog_updater_change(updater, other, &light));
  EXPECT_OK(litfog_updater_switch_light(updater, other, 0));
  EXPECT_OK(litfog_updater_remove(updater, lamp));
  EXPECT(litfog_updater_remove(updater, lamp) == LITFOG_INVALID_ARGUMENT);
  EXPECT(strstr(litfog_last_error(), "handle.slot = 0: must be that of a light held") != NULL);
  litfog_updater_destroy(updater);
}

static void pack(void) {
  const litfog_placed_light light = landing_lamp();
  const litfog_fog fog = fog_of(1500);
  const litfog_atmosphere air = {fog, {{0, 0}, {0, 0}, 1}, 1, INFINITY, {0.1, 0.2, 0.3}, {{{0, 0}}, 0}};
  litfog_fog_header header;
  EXPECT_OK(litfog_pack_fog_header(&air, 7, &header));
  EXPECT(header.fog[0] == (float)fog.density && header.fog[2] == 7 && header.ambient_fog_color[1] == 0.2f);
  EXPECT(litfog_pack_fog_header(&air, LITFOG_MAX_FOG_LIGHTS + 1, &header) == LITFOG_INVALID_ARGUMENT);
  EXPECT(header.fog[2] == 7);
  litfog_fog_light_block* block = malloc(sizeof *block);
  EXPECT(block != NULL);
  EXPECT_OK(litfog_pack_fog_light_block(&air, &light, 1, block));
  EXPECT(block->header.fog[2] == 1 && block->kinds[0].cone_scale_intensity[3] > 0.09f);
  free(block);
}

static void cull(void) {
  const litfog_placed_light light = landing_lamp();
  litfog_light_bounds bounds;
  litfog_view view;
  int32_t can, changed;
  EXPECT_OK(litfog_bounds_of(&light, 100, &bounds));
  const double low[] = {-1, -1, 10}, high[] = {1, 1, 20}, behind[] = {0, 0, 50};
  EXPECT_OK(litfog_can_light(&bounds, low, high, &can));
  EXPECT(!can);  // it shines the other way

  EXPECT_OK(litfog_default_view(&view));
  litfog_view_frustum* frustum;
  EXPECT_OK(litfog_view_frustum_create(&view, &frustum));
  EXPECT_OK(litfog_view_frustum_can_see_ball(frustum, behind, 1, &can));
  EXPECT(!can);
  EXPECT_OK(litfog_view_frustum_can_see_light(frustum, &bounds, &can));
  EXPECT(can);
  litfog_view_frustum_destroy(frustum);

  const litfog_cluster_grid grid = {2, 2, 2, 5};
  litfog_light_clusters* clusters;
  litfog_cluster_lists lists;
  EXPECT_OK(litfog_light_clusters_create(&grid, &clusters));
  EXPECT_OK(litfog_light_clusters_resize(clusters, 1));
  EXPECT_OK(litfog_light_clusters_set_light(clusters, 0, &bounds));
  EXPECT_OK(litfog_light_clusters_update(clusters, &view, &changed));
  EXPECT_OK(litfog_light_clusters_lists(clusters, &lists));
  EXPECT(changed && lists.cluster_count == 8 && lists.light_count == 8 && lists.clusters[7].count == 1);
  EXPECT_OK(litfog_light_clusters_update(clusters, &view, &changed));
  EXPECT(!changed);

  litfog_updater* updater;
  litfog_light_handle handle;
  const litfog_atmosphere air = {fog_of(1500), {{0, 0}, {0, 0}, 1}, 1, INFINITY, {0.1, 0.2, 0.3}, {{{0, 0}}, 0}};
  double reach, budget;
  EXPECT_OK(litfog_updater_create(LITFOG_DEFAULT_SKIP_BUDGET_255, &updater));
  EXPECT_OK(litfog_updater_add(updater, &light, &handle));
  EXPECT_OK(litfog_updater_bound_lights(updater, clusters, &air, 0.5 / 255, LITFOG_LAMP_LEG_FOGGED));
  EXPECT_OK(litfog_updater_reach_of_kind(updater, 0, &air, 0.5 / 255, LITFOG_LAMP_LEG_FOGGED, &reach));
  EXPECT_OK(litfog_reach_budget(0.5 / 255, 1, 1, &air, &budget));
  EXPECT(reach > 100 && budget > 0);
  EXPECT_OK(litfog_light_clusters_update(clusters, &view, &changed));
  EXPECT_OK(litfog_light_clusters_lists(clusters, &lists));
  EXPECT(lists.table[0] == 2 && lists.table[lists.table_size - 1] == 0);
  litfog_updater_destroy(updater);
  litfog_light_clusters_destroy(clusters);
}

static void read(const char* path) {
  litfog_light light;
  char name[16];
  EXPECT_OK(litfog_read_light(path, &light, name, sizeof name));
  EXPECT(light.attenuation.quadratic == 0.25 && strcmp(name, "a lamp") == 0);
  EXPECT(litfog_read_light("no such file", &light, NULL, 0) == LITFOG_BAD_FILE);
  EXPECT(strncmp(litfog_last_error(), "no such file: ", 14) == 0);
}

static void shaders(void) {
  const litfog_shader_text* texts;
  size_t count, length;
  EXPECT_OK(litfog_shader_texts(&texts, &count));
  EXPECT(count == 19 && strncmp(texts[0].name, "litfog/shaders/", 15) == 0 && strlen(texts[0].text) > 100);
  const char* source = "#version 330 core\n#include \"litfog/shaders/fog.glsl\"\nvoid main() {}\n";
  EXPECT_OK(litfog_expand_shader(source, NULL, 0, &length));
  char* expanded = malloc(length + 1);
  EXPECT(expanded != NULL);
  EXPECT_OK(litfog_expand_shader(source, expanded, length + 1, &length));
  EXPECT(strlen(expanded) == length && strstr(expanded, "vec3 litfog_apply_fog(") != NULL);
  free(expanded);
}

int main(int count, char** arguments) {
  EXPECT(count == 2);
  EXPECT(strcmp(litfog_last_error(), "") == 0);
  char version[32];
  snprintf(version, sizeof version, "%d.%d.%d", LITFOG_VERSION_MAJOR, LITFOG_VERSION_MINOR, LITFOG_VERSION_PATCH);
  EXPECT(strcmp(litfog_version(), version) == 0);
  solve();
  convert_runway_visual_range();
  solve_batch();
  update();
  pack();
  cull();
  read(arguments[1]);
  shaders();
  return 0;
}
