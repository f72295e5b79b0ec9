// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "fuzz/fuzz_target.h"
#include "fuzz/wild_number.h"
#include "litfog/c/litfog.h"

namespace litfog::test {
namespace {

/// A call with any values ends well, or says what is wrong with them.
bool is_ok(litfog_status status) {
  EXPECT_TRUE(status == LITFOG_OK || status == LITFOG_INVALID_ARGUMENT) << status << ": " << litfog_last_error();
  if (status != LITFOG_OK) {
    EXPECT_NE(std::string_view(litfog_last_error()), "");
  }
  return status == LITFOG_OK;
}

/// Draws the structs of C, in which few values are wrong.
class Draw {
 public:
  explicit Draw(Random& random) : random_(random), wild_(random) {}

  double number(double usual) { return random_.chance(0.15) ? wild_.draw() : usual; }
  std::int32_t choice(int count) { return random_.chance(0.05) ? random_.below(9) - 3 : random_.below(count); }
  std::size_t count(std::size_t most) {
    return random_.chance(0.05) ? std::size_t(random_.bits()) : std::size_t(random_.below(int(most) + 1));
  }
  double size() { return number(random_.log_uniform(1e-3, 1e3)); }

  void vector(double (&values)[3]) {
    for (double& value : values) value = number(random_.uniform(-100, 100));
  }
  void direction(double (&values)[3]) {
    const glm::dvec3 unit = random_.chance(0.3) ? glm::dvec3(0, 1, 0) : draw_direction(random_);
    for (int i = 0; i < 3; ++i) values[i] = random_.chance(0.02) ? wild_.draw() : unit[i];
  }
  litfog_fog fog() { return {choice(2), size()}; }
  litfog_phase_lobe lobe() { return {number(random_.uniform(-0.99, 0.99)), number(random_.pick(std::array{0., 1.}))}; }
  litfog_atmosphere atmosphere() {
    litfog_atmosphere air{fog(), {}, number(1), number(kInfinity), {0, 0, 0}, {}};
    air.phase = {lobe(), lobe(), number(1)};
    if (random_.chance(0.5)) air.phase = {{0, 0}, {0, 0}, 1};
    air.profile.count = random_.chance(0.6) ? 0 : count(LITFOG_MAX_DENSITY_KNOTS);
    double height = number(-10);
    for (litfog_density_knot& knot : air.profile.knots) {
      knot = {height, size()};
      height += size();
    }
    return air;
  }
  litfog_placed_light light() {
    litfog_placed_light placed;
    litfog_default_placed_light(&placed);
    litfog_light& light = placed.light;
    for (double& part : light.color) part = number(1);
    light.attenuation = {number(1), size(), size()};
    light.threshold = number(0.05);
    light.cone = {choice(3), number(0.5), number(8), number(0.3), number(0.7)};
    light.density_scale = number(1);
    light.source_radius = number(0);
    light.flash.count = random_.chance(0.8) ? 0 : count(LITFOG_MAX_FLASHES);
    light.flash.period = number(10);
    for (int i = 0; i < LITFOG_MAX_FLASHES; ++i) light.flash.flashes[i] = {number(i), number(0.5), number(1)};
    vector(placed.position);
    direction(placed.direction);
    placed.carried = choice(2);
    return placed;
  }
  litfog_eye_ray ray() {
    litfog_eye_ray ray;
    vector(ray.origin);
    direction(ray.direction);
    ray.length = size();
    return ray;
  }
  litfog_light_bounds bounds() {
    litfog_light_bounds bounds;
    vector(bounds.position);
    direction(bounds.direction);
    bounds.range = size();
    bounds.half_angle = number(0.7);
    return bounds;
  }
  litfog_view view() {
    litfog_view view;
    litfog_default_view(&view);
    vector(view.eye);
    for (double* value : {&view.left, &view.right, &view.bottom, &view.top, &view.nearest, &view.farthest}) {
      *value = number(*value);
    }
    return view;
  }
  litfog_light_handle handle(const std::vector<litfog_light_handle>& held) {
    if (held.empty() || random_.chance(0.1)) return {std::uint32_t(random_.below(5)), std::uint32_t(random_.bits())};
    return random_.pick(held);
  }

 private:
  Random& random_;
  WildNumbers wild_;
};

void call_functions(Random& random, Draw& draw) {
  const litfog_atmosphere air = draw.atmosphere();
  const litfog_placed_light placed = draw.light();
  const litfog_light& light = placed.light;
  const litfog_fog& fog = air.fog;
  const bool is_light = is_ok(litfog_check_placed_light(&placed)), is_air = is_ok(litfog_check_atmosphere(&air));
  double number = 0;
  litfog_fog made;
  is_ok(litfog_fog_from_visibility(draw.choice(2), draw.size(), draw.number(0.05), &made));
  is_ok(litfog_fog_from_runway_visual_range(draw.choice(2), draw.size(), draw.number(1e4), draw.number(8e-7), &made));
  is_ok(litfog_runway_visual_range(&fog, draw.number(1e4), draw.number(8e-7), &number));
  is_ok(litfog_illuminance_threshold(draw.size(), &number));
  litfog_phase phase;
  is_ok(litfog_phase_droplets(draw.number(20), &phase));
  if (is_ok(litfog_fog_between(&air, draw.number(0), draw.number(9), &made))) {
    EXPECT_GE(made.density, 0);
  }
  std::array<litfog_fog_layer, 3> layers;
  for (litfog_fog_layer& layer : layers) layer = {draw.number(0), draw.number(30), draw.number(2), draw.size()};
  litfog_density_profile profile;
  is_ok(litfog_density_profile_from_layers(layers.data(), std::size_t(random.below(4)), draw.number(0.05), &profile));

  litfog_light near;
  is_ok(litfog_photometric(&light, &near));
  double candela[3];
  is_ok(litfog_candela(&light, candela));
  is_ok(litfog_flash_at(&light.flash, draw.size(), &number));
  litfog_fog_intensity solution;
  const bool can_solve = is_ok(litfog_check_light(&light)) && is_ok(litfog_check_fog(&fog));
  EXPECT_EQ(is_ok(litfog_solve(&light, &fog, &solution)), can_solve);
  if (can_solve) {
    EXPECT_TRUE(solution.intensity >= 0 && solution.intensity <= 1) << solution.intensity;
    EXPECT_TRUE(solution.peak_range >= 0 && solution.peak_range <= solution.extent) << solution.peak_range;
    EXPECT_EQ(solution.status, LITFOG_SOLVE_OK);
  }
  is_ok(litfog_sample(&light, &fog, draw.choice(60), &solution));
  EXPECT_EQ(is_ok(litfog_axial_airlight(&light, &fog, &number)), can_solve);
  if (can_solve) {
    EXPECT_TRUE(number >= 0 && number <= 1) << number;
  }
  litfog_light_bounds bounds;
  const std::array rays{draw.ray(), draw.ray()};
  std::array<double, 2> airlights;
  if (is_ok(litfog_airlight(&placed, &air, rays.data(), rays.size(), draw.choice(2), airlights.data()))) {
    EXPECT_TRUE(is_light && is_air);
    for (const double airlight : airlights) EXPECT_TRUE(airlight >= 0 && std::isfinite(airlight)) << airlight;
  }
  if (is_ok(litfog_light_reach(&light, &fog, draw.number(0.01), draw.choice(2), &number))) {
    EXPECT_TRUE(number >= 0 && number <= solution.extent) << number;
  }
  const double reach = draw.size();
  EXPECT_EQ(is_ok(litfog_bounds_of(&placed, reach, &bounds)), is_light && reach >= 0);
  is_ok(litfog_reach_budget(draw.number(0.002), draw.count(9), draw.size(), &air, &number));
  is_ok(litfog_effective_intensity(&light.attenuation, draw.size(), &number));
  if (is_ok(litfog_directional_airlight(&air, placed.direction, rays.data(), rays.size(), airlights.data()))) {
    EXPECT_TRUE(is_air);
    for (const double airlight : airlights) EXPECT_TRUE(airlight >= 0 && std::isfinite(airlight)) << airlight;
  }
  if (is_ok(litfog_directional_fog_factor(&air, placed.direction, draw.size(), &number))) {
    EXPECT_TRUE(number >= 0 && number <= 1) << number;
  }
  if (random.chance(0.05)) {
    static litfog_scattering_table table;
    static litfog_thin_beams beams;
    static litfog_scattering_source source;
    litfog_diffuse_light scattered;
    if (is_ok(litfog_make_scattering_table(&air, &table)) && is_ok(litfog_make_thin_beams(&air, &table, &beams)) &&
        is_ok(litfog_make_scattering_source(&light, &air, &beams, &source)) &&
        is_ok(litfog_scattered_light(&placed, &source, &air, rays[0].origin, 1, &scattered)) &&
        is_ok(litfog_irradiance(&scattered, placed.direction, &number))) {
      EXPECT_FALSE(std::isnan(number));
    }
    if (is_ok(litfog_make_scattering_table(&air, &table)) &&
        is_ok(litfog_multiple_scattering(&placed, &air, &table, rays.data(), rays.size(), airlights.data()))) {
      for (const double value : airlights) EXPECT_TRUE(value >= 0 && std::isfinite(value)) << value;
    }
  }
  litfog_fog_header header;
  is_ok(litfog_pack_fog_header(&air, draw.count(200), &header));
  if (random.chance(0.1)) {
    static litfog_fog_light_block block;
    is_ok(litfog_pack_fog_light_block(&air, &placed, 1, &block));
  }

  std::array<double, 5> columns[5], solved[3];
  for (auto& column : columns) {
    for (double& value : column) value = draw.number(0.5);
  }
  std::array<std::uint8_t, 5> status;
  const litfog_batch_lights lights{5,
                                   columns[0].data(),
                                   columns[1].data(),
                                   columns[2].data(),
                                   columns[3].data(),
                                   random.chance(0.5) ? 5u : 1u,
                                   columns[4].data(),
                                   random.chance(0.9) ? 5u : 2u};
  const litfog_batch_solutions solutions{solved[0].data(), solved[1].data(), solved[2].data(), status.data()};
  std::size_t invalid = 0;
  if (is_ok(litfog_solve_batch(draw.choice(2), &lights, &solutions, &invalid))) {
    EXPECT_EQ(invalid, std::size_t(std::ranges::count(status, LITFOG_SOLVE_INVALID)));
    for (const double intensity : solved[0]) EXPECT_TRUE(intensity >= 0 && intensity <= 1) << intensity;
  }

  bounds = draw.bounds();
  std::int32_t can = 0;
  double low[3], high[3];
  draw.vector(low);
  draw.vector(high);
  is_ok(litfog_can_light(&bounds, low, high, &can));
  const litfog_view view = draw.view();
  litfog_view_frustum* frustum = nullptr;
  if (is_ok(litfog_view_frustum_create(&view, &frustum))) {
    is_ok(litfog_view_frustum_can_see_ball(frustum, low, draw.size(), &can));
    is_ok(litfog_view_frustum_can_see_light(frustum, &bounds, &can));
  }
  litfog_view_frustum_destroy(frustum);
}

void call_handles(Random& random, Draw& draw) {
  litfog_updater* updater = nullptr;
  litfog_light_clusters* clusters = nullptr;
  const litfog_cluster_grid grid{std::uint32_t(draw.count(6)), std::uint32_t(draw.count(6)),
                                 std::uint32_t(draw.count(6)), draw.number(5)};
  if (is_ok(litfog_updater_create(draw.number(0.5), &updater)) &&
      is_ok(litfog_light_clusters_create(&grid, &clusters))) {
    std::vector<litfog_light_handle> held;
    for (int calls = random.below(60); calls > 0; --calls) {
      const litfog_light_handle handle = draw.handle(held);
      const litfog_placed_light light = draw.light();
      std::size_t index = 0;
      switch (random.below(11)) {
        case 0:
        case 1: {
          litfog_light_handle added;
          const bool is_light = is_ok(litfog_check_placed_light(&light));
          EXPECT_EQ(is_ok(litfog_updater_add(updater, &light, &added)), is_light);
          if (is_light) held.push_back(added);
          break;
        }
        case 2:
          is_ok(litfog_updater_change(updater, handle, &light));
          break;
        case 3:
          is_ok(litfog_updater_switch_light(updater, handle, draw.choice(2)));
          break;
        case 4:
          if (is_ok(litfog_updater_remove(updater, handle))) {
            EXPECT_FALSE(is_ok(litfog_updater_remove(updater, handle)));
          }
          break;
        case 5:
          is_ok(litfog_updater_set_time(updater, draw.size()));
          break;
        case 6: {
          const litfog_atmosphere air = draw.atmosphere();
          litfog_fog_light_changes changes;
          litfog_fog_light_tables tables;
          EXPECT_EQ(is_ok(litfog_updater_set_fog(updater, &air.fog, &changes)), is_ok(litfog_check_fog(&air.fog)));
          if (!is_ok(litfog_updater_set_atmosphere(updater, &air, draw.number(0.1), &changes))) break;
          EXPECT_TRUE(is_ok(litfog_updater_tables(updater, &tables)));
          for (std::size_t i = 0; i < changes.instance_count; ++i) {
            EXPECT_LE(changes.instances[i].end, tables.instance_count);
          }
          break;
        }
        case 7:
          if (is_ok(litfog_updater_kind_of(updater, handle, &index))) {
            double range = 0;
            const litfog_atmosphere air = draw.atmosphere();
            is_ok(litfog_updater_reach_of_kind(updater, index, &air, draw.number(0.002), draw.choice(2), &range));
            EXPECT_GE(range, 0);
          }
          is_ok(litfog_updater_instance_of(updater, handle, &index));
          break;
        case 8: {
          const litfog_atmosphere air = draw.atmosphere();
          is_ok(litfog_updater_bound_lights(updater, clusters, &air, draw.number(0.002), draw.choice(2)));
          break;
        }
        case 9: {
          const litfog_light_bounds bounds = draw.bounds();
          is_ok(litfog_light_clusters_set_light(clusters, draw.count(4), &bounds));
          break;
        }
        default: {
          const litfog_view view = draw.view();
          std::int32_t changed = 0;
          litfog_cluster_lists lists;
          is_ok(litfog_light_clusters_update(clusters, &view, &changed));
          EXPECT_TRUE(is_ok(litfog_light_clusters_lists(clusters, &lists)));
          for (std::size_t i = 0; i < lists.cluster_count; ++i) {
            EXPECT_LE(lists.clusters[i].first + lists.clusters[i].count, lists.light_count);
          }
        }
      }
    }
  }
  litfog_light_clusters_destroy(clusters);
  litfog_updater_destroy(updater);
}

void call_c(std::string_view bytes) {
  Random random(bytes);
  Draw draw(random);
  if (random.chance(0.5)) {
    call_functions(random, draw);
  } else {
    call_handles(random, draw);
  }
}

const AddFuzzTargets kAdd{{"c-face", call_c, {}, random_seeds}};

}  // namespace
}  // namespace litfog::test
