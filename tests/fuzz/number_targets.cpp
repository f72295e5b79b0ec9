// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>
#include <string_view>
#include <vector>

#include "core/cluster_lists.h"
#include "core/updater_mirror.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/wild_number.h"
#include "litfog/batch.h"
#include "litfog/directional_airlight.h"
#include "litfog/intensity_bound.h"
#include "litfog/multiple_scattering.h"
#include "reference/airlight_climb.h"
#include "reference/digits50.h"
#include "reference/reference_solver.h"

namespace litfog::test {
namespace {

// --- solve.h, batch.h, intensity_bound.h ---

void expect_batch(const std::vector<SolveCase>& cases, FogMode mode) {
  std::vector<double> constant, linear, quadratic, threshold, density;
  for (const SolveCase& c : cases) {
    constant.push_back(c.attenuation.constant);
    linear.push_back(c.attenuation.linear);
    quadratic.push_back(c.attenuation.quadratic);
    threshold.push_back(c.threshold);
    density.push_back(c.fog.density);
  }
  std::vector<double> intensity(cases.size()), peak_range(cases.size()), extent(cases.size());
  std::vector<BatchStatus> status(cases.size());
  solve_fog_intensities(mode, {constant, linear, quadratic, threshold, density},
                        {intensity, peak_range, extent, status});
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const SolveCase& c = cases[i];
    if (find_error(c.attenuation) || find_error(c.fog) || find_threshold_error(c.threshold)) {
      EXPECT_EQ(status[i], BatchStatus::invalid) << to_string(c);
      EXPECT_TRUE(intensity[i] == 0 && peak_range[i] == 0 && extent[i] == 0) << to_string(c);
      EXPECT_THROW(solve_fog_intensity(c.attenuation, c.fog, c.threshold), std::invalid_argument) << to_string(c);
      continue;
    }
    const FogIntensity solved = solve_fog_intensity(c.attenuation, c.fog, c.threshold);
    EXPECT_EQ(solved.status, SolveStatus::ok) << to_string(c);
    EXPECT_EQ(status[i], BatchStatus::ok) << to_string(c);
    EXPECT_TRUE(solved.intensity >= 0 && solved.intensity <= 1) << to_string(c);
    EXPECT_TRUE(solved.peak_range >= 0 && solved.peak_range <= solved.extent) << to_string(c);
    EXPECT_TRUE(peak_range[i] >= 0 && peak_range[i] <= extent[i]) << to_string(c);
    const double bound = IntensityBound(c.attenuation, c.threshold).at(c.fog);
    EXPECT_TRUE(bound <= 1 && bound >= std::max(solved.intensity, intensity[i])) << to_string(c);
    const bool has_reference =
        c.fog.density > 0 && c.fog.density < kInfinity && (c.attenuation.linear > 0 || c.attenuation.quadratic > 0);
    if (!has_reference) {
      EXPECT_EQ(intensity[i], solved.intensity) << to_string(c);
      continue;
    }
    const ReferencePeak reference = solve_reference(c.attenuation, c.fog, c.threshold);
    EXPECT_LE(ulp_error(solved.intensity, reference.intensity), kIntensityMaxUlp<double>) << to_string(c);
    EXPECT_LE(ulp_error(intensity[i], reference.intensity), kBatchIntensityMaxUlp) << to_string(c);
    EXPECT_LE(ulp_error(solved.extent, reference.extent), kExtentMaxUlp<double>) << to_string(c);
    EXPECT_LE(ulp_error(extent[i], reference.extent), kBatchExtentMaxUlp<double>) << to_string(c);
    for (const double range : {solved.peak_range, peak_range[i]}) {
      if (ulp_error(range, reference.peak_range) <= 1) continue;
      EXPECT_LE(relative_error(range, reference.peak_range), kPeakRangeMaxError) << to_string(c);
    }
  }
}

void solve(std::string_view bytes) {
  Random random(bytes);
  const FogMode mode = random.pick(kModes);
  std::vector<SolveCase> cases;
  for (int count = 1 + random.below(9); count > 0; --count) {
    WildNumbers wild(random);
    cases.push_back(random.chance(0.5)
                        ? draw_ordinary_case(random, mode)
                        : SolveCase{{wild.draw(), wild.draw(), wild.draw()}, {mode, wild.draw()}, wild.draw()});
  }
  expect_batch(cases, mode);
}

// --- airlight.h ---

double airlight_of(const AirlightCase& c) { return airlight(c.light, c.atmosphere, c.ray, c.lamp_leg); }
double reference_of(const AirlightCase& c) { return reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg); }

void expect_airlight(const AirlightCase& c, double most) {
  const double expected = reference_of(c);
  EXPECT_LE(std::abs(airlight_of(c) - expected), most * std::max(expected, 1.0)) << to_string(c);
  const double bound = bound_airlight(c.light, c.atmosphere, c.ray.origin, c.ray.direction, 1e-12, c.lamp_leg);
  EXPECT_GE(bound, expected) << to_string(c);
}

/// Any light, air and ray.
void expect_finite_airlight(Random& random) {
  WildNumbers wild(random);
  AirlightCase c = draw_spot_airlight_case(random, random.pick(kModes), random.pick(kLampLegs));
  const auto change = [&](double& value) {
    if (random.chance(0.3)) value = wild.draw();
  };
  Light& light = c.light.light;
  for (double* value :
       {&light.attenuation.constant, &light.attenuation.linear, &light.attenuation.quadratic, &light.threshold,
        &light.density_scale, &light.cone.half_angle, &light.cone.exponent, &light.cone.inner, &light.cone.outer,
        &c.atmosphere.fog.density, &c.atmosphere.top, &c.atmosphere.phase.first.asymmetry,
        &c.atmosphere.phase.first.alpha, &c.atmosphere.phase.weight, &c.ray.length}) {
    change(*value);
  }
  for (int i = 0; i < 3; ++i) {
    change(c.light.position[i]);
    change(c.ray.origin[i]);
  }
  if (random.chance(0.3)) c.light.position = c.ray.origin;
  if (random.chance(0.3) && c.atmosphere.fog.mode == FogMode::exp) {
    double height = wild.draw();
    for (std::size_t& count = c.atmosphere.profile.count; count < 4; ++count) {
      c.atmosphere.profile.knots[count] = {height, wild.draw()};
      height += std::abs(wild.draw());
    }
  }
  if (find_error(c.light) || find_error(c.atmosphere) || find_error(c.ray)) {
    EXPECT_THROW(airlight_of(c), std::invalid_argument) << to_string(c);
    return;
  }
  const double most = largest_phase(c.atmosphere.phase) * (1 + 1e-9);
  const double value = airlight_of(c);
  EXPECT_TRUE(value >= 0 && value <= most && std::isfinite(value)) << value << ": " << to_string(c);
  if (random.chance(0.01)) {
    const double reference = reference_of(c);
    EXPECT_TRUE(reference >= 0 && std::isfinite(reference)) << reference << ": " << to_string(c);
  }
  const double bound = bound_airlight(c.light, c.atmosphere, c.ray.origin, c.ray.direction, 1e-12, c.lamp_leg);
  EXPECT_TRUE(bound >= 0 && !std::isnan(bound)) << bound << ": " << to_string(c);
  const double reach = light_reach(light, c.atmosphere.thinnest_fog(), 0.01, c.lamp_leg);
  EXPECT_TRUE(reach >= 0 && reach <= compute_extent(light.attenuation, light.threshold)) << to_string(c);
}

void scatter_once(std::string_view bytes) {
  Random random(bytes);
  const int way = random.below(4);
  if (way == 0) {
    const ClimbKind kind{random.pick(std::array{LampShape::point, LampShape::cosine, LampShape::smoothstep}),
                         random.chance(0.5), random.pick(kModes), random.pick(kLampLegs)};
    ClimbPoint point;
    for (double& x : point) x = random.uniform(0, 1);
    const AirlightCase c = case_at(point, kind);
    if (compute_extent(c.light.light.attenuation, c.light.light.threshold) > 0) expect_airlight(c, stated_error(kind));
  } else if (way == 1) {
    const AirlightCase c = draw_coincident_airlight_case(random, random.pick(kModes), random.pick(kLampLegs));
    if (!runs_along_edge(c)) expect_airlight(c, kAirlightMaxError);
  } else if (way == 2) {
    AirlightCase c = draw_spot_airlight_case(random, FogMode::exp, random.pick(kLampLegs));
    const bool is_point = random.chance(0.5);
    if (is_point) c.light.light.cone = {};
    const bool is_shaped = random.chance(0.5);
    if (is_shaped) c.atmosphere.phase = draw_phase(random);
    draw_layers(random, c);
    if (runs_along_edge(c)) return;
    expect_airlight(c, is_shaped && is_point ? kShapedAirlightMaxError : kLayeredAirlightMaxError);
  } else {
    expect_finite_airlight(random);
  }
}

// --- directional_airlight.h, density_profile.h ---

void scatter_sunlight(std::string_view bytes) {
  Random random(bytes);
  WildNumbers wild(random);
  std::vector<FogLayer> layers(1 + std::size_t(random.below(3)));
  for (FogLayer& layer : layers) {
    layer = {wild.draw(), wild.draw(), random.chance(0.3) ? wild.draw() : random.log_uniform(1e-3, 1e3), wild.draw()};
    if (random.chance(0.3)) layer.base = -kInfinity;
    if (random.chance(0.3)) layer.top = kInfinity;
  }
  Atmosphere air{.phase = draw_phase(random), .top = random.chance(0.5) ? kInfinity : wild.draw()};
  if (random.chance(0.5)) air.fog.density = wild.draw();
  try {
    air.profile = make_density_profile(layers);
  } catch (const std::invalid_argument&) {
    return;
  }
  EXPECT_FALSE(find_error(air.profile));
  EyeRay ray{{0, wild.draw(), 0}, draw_direction(random), wild.draw()};
  if (find_error(air) || find_error(ray)) return;
  const double least = smallest_density(air.profile), largest = largest_density(air.profile);
  EXPECT_LE(least, largest);
  const double low = ray.origin.y, high = random.chance(0.2) ? low : random.uniform(-1e4, 1e4);
  const double mean = mean_density(air.profile, low, high);
  EXPECT_TRUE(mean >= least * (1 - 1e-14) - 1e-300 && mean <= largest * (1 + 1e-14) + 1e-300)
      << mean << " " << least << " " << largest;
  EXPECT_EQ(mean, mean_density(air.profile, high, low));
  const glm::dvec3 to_light = random.chance(0.3) ? glm::dvec3(0, 1, 0) : draw_direction(random);
  const double factor = directional_fog_factor(air, to_light, low);
  EXPECT_TRUE(factor >= 0 && factor <= 1) << factor;
  const double value = directional_airlight(air, to_light, ray);
  EXPECT_TRUE(value >= 0 && value <= largest_phase(air.phase) * (1 + 1e-9)) << value;
}

// --- multiple_scattering.h, scattered_beam.h ---

struct ScatteringAir {
  Atmosphere atmosphere;
  ScatteringTable table = make_scattering_table(atmosphere);
  ThinBeams beams = make_thin_beams(atmosphere, table);
};

void scatter_often(std::string_view bytes) {
  static const std::vector<ScatteringAir> kAirs = [] {
    std::vector<ScatteringAir> airs;
    for (const Phase& phase : {Phase{}, Phase::henyey_greenstein(0.95), Phase::droplets(10)}) {
      airs.push_back({{.fog = {FogMode::exp, 0.1}, .phase = phase}});
    }
    return airs;
  }();
  Random random(bytes);
  WildNumbers wild(random);
  const ScatteringAir& air = kAirs[std::size_t(random.below(int(kAirs.size())))];
  AirlightCase c = draw_spot_airlight_case(random, FogMode::exp, LampLeg::fogged);
  if (random.chance(0.3)) c.light.light.cone = {};
  Light& light = c.light.light;
  for (double* value :
       {&light.attenuation.constant, &light.attenuation.linear, &light.attenuation.quadratic, &light.density_scale,
        &light.cone.half_angle, &light.cone.outer, &c.atmosphere.fog.density, &c.ray.length}) {
    if (random.chance(0.2)) *value = wild.draw();
  }
  if (random.chance(0.2)) c.light.position = c.ray.origin;
  const Atmosphere atmosphere{.fog = c.atmosphere.fog, .phase = air.atmosphere.phase};
  if (find_error(c.light) || find_error(atmosphere) || find_error(c.ray)) return;
  const ScatteringSource source = scattering_source(light, atmosphere, air.beams);
  EXPECT_TRUE(source.intensity >= 0 && !std::isnan(source.intensity)) << source.intensity << ": " << to_string(c);
  const double value = multiple_scattering(c.light, source, atmosphere, air.table, c.ray);
  EXPECT_TRUE(value >= 0 && std::isfinite(value)) << value << ": " << to_string(c);
  const double depth = std::abs(wild.draw()), angle = random.uniform(0, std::numbers::pi);
  if (std::isnan(depth)) return;
  EXPECT_TRUE(scattered_at(air.table, depth, angle) >= 0) << depth << " " << angle;
}

// --- light_clusters.h, view_frustum.h ---

void cluster(std::string_view bytes) {
  Random random(bytes);
  View view = draw_view(random);
  if (random.chance(0.3)) {
    expect_complete(random, view);
    return;
  }
  WildNumbers wild(random);
  LightClusters clusters({.columns = 1 + std::uint32_t(random.below(9)),
                          .rows = 1 + std::uint32_t(random.below(9)),
                          .slices = 1 + std::uint32_t(random.below(9)),
                          .first_depth = view.nearest + random.uniform(0.01, 0.9) * (view.farthest - view.nearest)});
  std::vector<LightBounds> lights;
  for (int step = random.below(30); step > 0; --step) {
    const int kind = random.below(5);
    if (kind == 0) {
      lights.resize(std::size_t(random.below(50)), {.range = 0});
      clusters.resize(lights.size());
    } else if (kind < 3 && !lights.empty()) {
      const auto light = std::size_t(random.below(int(lights.size())));
      LightBounds bounds = draw_bounds(random, view);
      if (random.chance(0.3)) bounds.range = wild.draw();
      if (random.chance(0.3)) bounds.half_angle = wild.draw();
      if (random.chance(0.2)) bounds.position = view.eye;
      if (find_error(bounds)) {
        EXPECT_THROW(clusters.set_light(light, bounds), std::invalid_argument);
        continue;
      }
      clusters.set_light(light, bounds);
      lights[light] = bounds;
    } else {
      if (kind == 3) view.eye += random.uniform(-50, 50);
      if (find_error(view)) return;
      clusters.update(view);
      LightClusters fresh(clusters.grid());
      set_lights(fresh, lights);
      fresh.update(view);
      EXPECT_TRUE(Lists(clusters) == Lists(fresh));
      EXPECT_TRUE(std::ranges::equal(clusters.table(), fresh.table()));
      for (std::size_t light = 0; light < lights.size(); ++light) {
        const glm::dvec3 point = draw_point_in(random, lights[light], 3 * view.farthest);
        const auto at = clusters.cluster_at(point);
        if (at && lights[light].range > 0) {
          EXPECT_TRUE(has_light(clusters, *at, light)) << to_string(view, lights[light]);
        }
        if (at && lights[light].half_angle == std::numbers::pi && lights[light].range > 0) {
          EXPECT_TRUE(ViewFrustum(view).can_see(lights[light])) << to_string(view, lights[light]);
        }
      }
    }
  }
}

// --- updater.h ---

void update(std::string_view bytes) {
  Random random(bytes);
  Mirror mirror(random.pick(std::array{0., 0.5, 20.}));
  run_random_calls(mirror, random, 1 + random.below(60), 3, random.pick(std::array{0.3, 0.6, 0.9}));
}

const AddFuzzTargets kAdd{{"solve", solve, {}, random_seeds},
                          {"airlight", scatter_once, {}, random_seeds},
                          {"directional-airlight", scatter_sunlight, {}, random_seeds},
                          {"multiple-scattering", scatter_often, {}, random_seeds},
                          {"clusters", cluster, {}, random_seeds},
                          {"updater", update, {}, random_seeds}};

}  // namespace
}  // namespace litfog::test
