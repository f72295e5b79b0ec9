// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <functional>
#include <span>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "command/temporary_directory.h"
#include "core/allocation_count.h"
#include "litfog/airlight.h"
#include "litfog/batch.h"
#include "litfog/c/litfog.h"
#include "litfog/directional_airlight.h"
#include "litfog/files/light_file.h"
#include "litfog/fog_light_block.h"
#include "litfog/light_clusters.h"
#include "litfog/multiple_scattering.h"
#include "litfog/runway_visual_range.h"
#include "litfog/scattered_beam.h"
#include "litfog/solve.h"
#include "litfog/updater.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A light and its twin of C.
struct Twins {
  PlacedLight cpp;
  litfog_placed_light c;
};

Twins random_twins(Random& random) {
  PlacedLight placed;
  Light& light = placed.light;
  light.color = {random.uniform(0, 2), random.uniform(0, 2), random.uniform(0, 2)};
  light.attenuation = {random.uniform(0.1, 2), random.log_uniform(1e-4, 1), random.log_uniform(1e-6, 1)};
  light.threshold = random.uniform(0.01, 0.2);
  light.density_scale = random.uniform(0.2, 2);
  light.source_radius = random.chance(0.5) ? 0 : random.uniform(0.01, 0.3);
  light.cone = random.pick(std::array{Cone{}, Cone::cosine(random.uniform(0.1, 1.5), random.uniform(0, 50)),
                                      Cone::smoothstep(random.uniform(0, 0.4), random.uniform(0.5, 3))});
  if (random.chance(0.5))
    light.flash = {2, 2, {{{0, random.uniform(0.1, 0.5), 5}, {random.uniform(0.5, 1.5), 0.5, 1}}}};
  placed.position = {random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-50, 50)};
  placed.direction = {0, 1, 0};
  placed.carried = random.chance(0.5);
  const Cone& cone = light.cone;
  return {placed,
          {{{light.color.r, light.color.g, light.color.b},
            {light.attenuation.constant, light.attenuation.linear, light.attenuation.quadratic},
            light.threshold,
            {int(cone.profile), cone.half_angle, cone.exponent, cone.inner, cone.outer},
            light.density_scale,
            light.source_radius,
            {light.flash.period,
             light.flash.count,
             {{light.flash.flashes[0].start, light.flash.flashes[0].duration, light.flash.flashes[0].intensity},
              {light.flash.flashes[1].start, light.flash.flashes[1].duration, light.flash.flashes[1].intensity}}}},
           {placed.position.x, placed.position.y, placed.position.z},
           {0, 1, 0},
           placed.carried}};
}

/// What a call that refuses its arguments returns and says.
void expect_refused(litfog_status status, const std::string& sentence) {
  EXPECT_EQ(status, LITFOG_INVALID_ARGUMENT);
  EXPECT_EQ(litfog_last_error(), sentence);
}

class CFace : public testing::Test {
 protected:
  CFace() { EXPECT_EQ(litfog_default_placed_light(&light_), LITFOG_OK); }

  litfog_placed_light light_;
  Random random_{15};
  const litfog_fog fog_{LITFOG_FOG_EXP2, 0.002};
  const litfog_atmosphere air_{fog_, {{0, 0}, {0, 0}, 1}, 1, kInfinity, {0, 0, 0}, {}};
  const Fog cpp_fog_{FogMode::exp2, 0.002};
};

TEST_F(CFace, SolvesAreThoseOfCpp) {
  for (int i = 0; i < 100; ++i) {
    const Twins twins = random_twins(random_);
    const Light& light = twins.cpp.light;
    litfog_fog_intensity solution;
    ASSERT_EQ(litfog_solve(&twins.c.light, &fog_, &solution), LITFOG_OK) << litfog_last_error();
    const FogIntensity exact = solve_fog_intensity(light, cpp_fog_);
    EXPECT_EQ(solution.intensity, exact.intensity);
    EXPECT_EQ(solution.peak_range, exact.peak_range);
    EXPECT_EQ(solution.extent, exact.extent);
    EXPECT_EQ(solution.status, LITFOG_SOLVE_OK);

    ASSERT_EQ(litfog_sample(&twins.c.light, &fog_, 64, &solution), LITFOG_OK);
    EXPECT_EQ(
        solution.intensity,
        sample_fog_intensity(light.attenuation, scaled(cpp_fog_, light.density_scale), light.threshold, 64).intensity);
  }
}

TEST_F(CFace, PhotometricLightsAreThoseOfCpp) {
  for (int i = 0; i < 50; ++i) {
    const Twins twins = random_twins(random_);
    litfog_light near;
    double intensity[3];
    ASSERT_EQ(litfog_photometric(&twins.c.light, &near), LITFOG_OK) << litfog_last_error();
    ASSERT_EQ(litfog_candela(&twins.c.light, intensity), LITFOG_OK) << litfog_last_error();
    const Light expected = photometric(twins.cpp.light);
    EXPECT_EQ(near.color[1], expected.color.g);
    EXPECT_EQ(near.attenuation.quadratic, expected.attenuation.quadratic);
    EXPECT_EQ(near.threshold, expected.threshold);
    EXPECT_EQ(near.source_radius, 0);
    EXPECT_EQ(intensity[2], candela(twins.cpp.light).b);
  }
  litfog_light wrong{};
  wrong.source_radius = 1;
  EXPECT_EQ(litfog_photometric(&wrong, &wrong), LITFOG_INVALID_ARGUMENT);
}

TEST_F(CFace, FlashesAreThoseOfCpp) {
  for (int i = 0; i < 50; ++i) {
    const Twins twins = random_twins(random_);
    const double seconds = random_.uniform(0, 100);
    double factor = -1;
    ASSERT_EQ(litfog_flash_at(&twins.c.light.flash, seconds, &factor), LITFOG_OK) << litfog_last_error();
    EXPECT_EQ(factor, flash_at(twins.cpp.light.flash, seconds));
    expect_refused(litfog_flash_at(&twins.c.light.flash, -1, &factor), "seconds = -1: must be in [0, 1e9]");
  }
}

TEST_F(CFace, LayersAreThoseOfCpp) {
  const litfog_fog_layer layers[] = {{-kInfinity, 100, 20, 300}, {200, 300, 50, 1000}};
  const FogLayer cpp_layers[] = {{-kInfinity, 100, 20, 300}, {200, 300, 50, 1000}};
  litfog_atmosphere air{{LITFOG_FOG_EXP, 0.001}, {{0, 0}, {0, 0}, 1}, 1, kInfinity, {0, 0, 0}, {}};
  ASSERT_EQ(litfog_density_profile_from_layers(layers, 2, LITFOG_CONTRAST_MOR, &air.profile), LITFOG_OK)
      << litfog_last_error();
  const Atmosphere same{.fog = {FogMode::exp, 0.001}, .profile = make_density_profile(cpp_layers)};
  EXPECT_EQ(std::memcmp(&air.profile, &same.profile, sizeof air.profile), 0);
  litfog_fog between;
  ASSERT_EQ(litfog_fog_between(&air, 50, 250, &between), LITFOG_OK);
  EXPECT_EQ(between.density, same.fog_between(50, 250).density);
  litfog_fog_header header;
  ASSERT_EQ(litfog_pack_fog_header(&air, 3, &header), LITFOG_OK);
  const FogHeader expected = pack_fog_header(same, 3);
  EXPECT_EQ(std::memcmp(&header, &expected, sizeof header), 0);

  expect_refused(litfog_fog_between(&air, 50, kInfinity, &between), "height_b = inf: must be finite");
  const litfog_fog_layer wrong{10, 5, 0, 100};
  expect_refused(litfog_density_profile_from_layers(&wrong, 1, LITFOG_CONTRAST_MOR, &air.profile),
                 "top = 5: must be above the base");
  air.fog.mode = LITFOG_FOG_EXP2;
  expect_refused(litfog_check_atmosphere(&air), "profile.count = 6: must be 0 in exp2 fog");
}

TEST_F(CFace, AirlightsAreThoseOfCpp) {
  const litfog_atmosphere air{fog_, {{0.3, 0.5}, {-0.2, 0}, 0.6}, 0.9, kInfinity, {0, 0, 0}, {}};
  const litfog_eye_ray rays[] = {{{0, 0, 0}, {0, 0, -1}, kInfinity}, {{1, 2, 3}, {0, 1, 0}, 40}};
  for (int i = 0; i < 50; ++i) {
    const Twins twins = random_twins(random_);
    double found[2];
    ASSERT_EQ(litfog_airlight(&twins.c, &air, rays, 2, LITFOG_LAMP_LEG_CLEAR, found), LITFOG_OK) << litfog_last_error();
    const Atmosphere same{.fog = cpp_fog_, .phase = {{0.3, 0.5}, {-0.2, 0}, 0.6}, .albedo = 0.9};
    EXPECT_EQ(found[0], airlight(twins.cpp, same, EyeRay{}, LampLeg::clear));
    EXPECT_EQ(found[1], airlight(twins.cpp, same, {{1, 2, 3}, {0, 1, 0}, 40}, LampLeg::clear));
    ASSERT_EQ(litfog_airlight(&twins.c, &air, rays, 1, LITFOG_LAMP_LEG_FOGGED, found), LITFOG_OK);
    EXPECT_EQ(found[0], airlight(twins.cpp, same, EyeRay{}));

    double axial, range;
    ASSERT_EQ(litfog_axial_airlight(&twins.c.light, &fog_, &axial), LITFOG_OK);
    EXPECT_EQ(axial, axial_airlight(twins.cpp.light, cpp_fog_));
    ASSERT_EQ(litfog_light_reach(&twins.c.light, &fog_, 0.01, LITFOG_LAMP_LEG_CLEAR, &range), LITFOG_OK);
    EXPECT_EQ(range, light_reach(twins.cpp.light, cpp_fog_, 0.01, LampLeg::clear));
  }
}

template <typename Real>
class CFaceBatch : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(CFaceBatch, Reals);

TYPED_TEST(CFaceBatch, SolvesAreThoseOfCpp) {
  using Real = TypeParam;
  constexpr bool kIsDouble = std::is_same_v<Real, double>;
  using Lights = std::conditional_t<kIsDouble, litfog_batch_lights, litfog_batch_lights_f>;
  using Solutions = std::conditional_t<kIsDouble, litfog_batch_solutions, litfog_batch_solutions_f>;
  constexpr std::size_t kCount = 37;
  std::vector<Real> constant(kCount), linear(kCount), quadratic(kCount), density(kCount);
  Random random(5);
  for (std::size_t i = 0; i < kCount; ++i) {
    constant[i] = Real(random.uniform(0, 2));
    linear[i] = Real(random.uniform(0, 1));
    quadratic[i] = Real(i == 11 ? -1 : random.log_uniform(1e-6, 1));
    density[i] = Real(random.log_uniform(1e-5, 0.1));
  }
  const Real threshold = Real(0.05);
  const Lights lights{kCount, constant.data(), linear.data(), quadratic.data(), &threshold, 1, density.data(), kCount};
  std::vector<Real> intensity(kCount), peak_range(kCount), extent(kCount);
  std::vector<std::uint8_t> status(kCount);
  const Solutions solutions{intensity.data(), peak_range.data(), extent.data(), status.data()};
  std::size_t invalid = 0;
  litfog_status result;
  if constexpr (kIsDouble) {
    result = litfog_solve_batch(LITFOG_FOG_EXP, &lights, &solutions, &invalid);
  } else {
    result = litfog_solve_batch_f(LITFOG_FOG_EXP, &lights, &solutions, &invalid);
  }
  ASSERT_EQ(result, LITFOG_OK) << litfog_last_error();
  EXPECT_EQ(invalid, 1u);
  EXPECT_EQ(status[11], LITFOG_SOLVE_INVALID);

  std::vector<Real> cpp_intensity(kCount), cpp_peak_range(kCount), cpp_extent(kCount);
  solve_fog_intensities(FogMode::exp,
                        BasicBatchLights<Real>{constant, linear, quadratic, std::span(&threshold, 1), density},
                        BasicBatchSolutions<Real>{cpp_intensity, cpp_peak_range, cpp_extent, {}});
  EXPECT_EQ(intensity, cpp_intensity);
  EXPECT_EQ(peak_range, cpp_peak_range);
  EXPECT_EQ(extent, cpp_extent);
}

TEST_F(CFace, BatchRefusesColumnsThatDoNotFit) {
  const double column[] = {1, 1, 1};
  double results[3] = {7, 7, 7};
  const litfog_batch_solutions solutions{results, nullptr, nullptr, nullptr};
  litfog_batch_lights lights{3, column, column, column, column, 2, column, 3};
  expect_refused(litfog_solve_batch(LITFOG_FOG_EXP, &lights, &solutions, nullptr),
                 "lights.threshold_count = 2: must be 1 or count");
  lights.threshold_count = 3;
  lights.linear = nullptr;
  expect_refused(litfog_solve_batch(LITFOG_FOG_EXP, &lights, &solutions, nullptr), "lights.linear: must not be NULL");
  lights.linear = column;
  expect_refused(litfog_solve_batch(2, &lights, &solutions, nullptr), "fog.mode = 2: must be in [0, 1]");
  const litfog_batch_solutions without_intensity{nullptr, results, nullptr, nullptr};
  expect_refused(litfog_solve_batch(LITFOG_FOG_EXP, &lights, &without_intensity, nullptr),
                 "solutions.intensity: must not be NULL");
  EXPECT_EQ(results[0], 7);
  lights = {};
  lights.threshold = lights.density = column;
  lights.threshold_count = lights.density_count = 1;
  EXPECT_EQ(litfog_solve_batch(LITFOG_FOG_EXP, &lights, &solutions, nullptr), LITFOG_OK) << "no lights at all";
}

TEST_F(CFace, ColumnsOfResultsThatOverlapAnotherColumnAreRefused) {
  const std::vector<double> ones(6, 1);
  std::vector<double> from = ones;
  std::vector<double> to(6, 7);
  const double threshold = 0.5;
  litfog_batch_lights lights{3, ones.data(), ones.data(), ones.data(), &threshold, 1, &from[3], 3};
  litfog_batch_solutions solutions{to.data(), nullptr, nullptr, nullptr};
  const auto solve = [&] { return litfog_solve_batch(LITFOG_FOG_EXP, &lights, &solutions, nullptr); };
  solutions.intensity = &from[3];
  expect_refused(solve(), "solutions.intensity: must not overlap lights.density");
  solutions.intensity = &from[1];
  expect_refused(solve(), "solutions.intensity: must not overlap lights.density");
  solutions.intensity = to.data();
  solutions.extent = &to[2];
  expect_refused(solve(), "solutions.extent: must not overlap solutions.intensity");
  solutions.extent = nullptr;
  solutions.status = reinterpret_cast<std::uint8_t*>(&to[2]) + 7;
  expect_refused(solve(), "solutions.status: must not overlap solutions.intensity");
  std::vector<litfog_eye_ray> rays(2, {{0, 0, 0}, {0, 0, -1}, 9});
  expect_refused(litfog_airlight(&light_, &air_, rays.data(), 2, LITFOG_LAMP_LEG_FOGGED, &rays[1].length),
                 "airlights: must not overlap rays");
  EXPECT_EQ(from, ones);
  EXPECT_EQ(to, std::vector<double>(6, 7));

  solutions = {&from[0], &to[0], &to[3], nullptr};  // side by side
  EXPECT_EQ(solve(), LITFOG_OK) << litfog_last_error();
}

TEST_F(CFace, PackedBlockIsThatOfCpp) {
  std::vector<PlacedLight> lights;
  std::vector<litfog_placed_light> c_lights;
  std::vector<FogIntensity> solutions;
  for (int i = 0; i < 20; ++i) {
    const Twins twins = random_twins(random_);
    lights.push_back(twins.cpp);
    c_lights.push_back(twins.c);
    solutions.push_back(solve_fog_intensity(twins.cpp.light, cpp_fog_));
  }
  const litfog_atmosphere air{fog_, {{0, 0}, {0, 0}, 1}, 1, kInfinity, {0.1, 0.2, 0.3}, {}};
  litfog_fog_light_block block;
  ASSERT_EQ(litfog_pack_fog_light_block(&air, c_lights.data(), c_lights.size(), &block), LITFOG_OK);
  const FogLightBlock expected =
      pack_fog_light_block({.fog = cpp_fog_, .ambient_fog_color = {0.1, 0.2, 0.3}}, lights, solutions);
  EXPECT_EQ(std::memcmp(&block, &expected, sizeof expected), 0);

  c_lights.resize(LITFOG_MAX_FOG_LIGHTS + 1, c_lights[0]);
  expect_refused(litfog_pack_fog_light_block(&air, c_lights.data(), c_lights.size(), &block),
                 "count = 201: must be at most 200");
  EXPECT_EQ(litfog_pack_fog_light_block(&air, c_lights.data(), 1'000'000'000, &block), LITFOG_INVALID_ARGUMENT)
      << "and none of them is read";
}

TEST_F(CFace, MultipleScatteringIsThatOfCpp) {
  litfog_atmosphere air{{LITFOG_FOG_EXP, 0.02}, {{0.7, 0}, {0, 0}, 1}, 1, kInfinity, {0, 0, 0}, {}};
  const Atmosphere same{.fog = {FogMode::exp, 0.02}, .phase = Phase::henyey_greenstein(0.7)};
  litfog_scattering_table table;
  ASSERT_EQ(litfog_make_scattering_table(&air, &table), LITFOG_OK) << litfog_last_error();
  const ScatteringTable expected = make_scattering_table(same);
  EXPECT_EQ(std::memcmp(&table, &expected, sizeof table), 0);
  litfog_eye_ray rays[] = {{{0, 0, 0}, {0, 0, -1}, kInfinity}, {{1, 2, 3}, {0, 1, 0}, 40}};
  double found[2];
  for (int i = 0; i < 20; ++i) {
    const Twins twins = random_twins(random_);
    ASSERT_EQ(litfog_multiple_scattering(&twins.c, &air, &table, rays, 2, found), LITFOG_OK) << litfog_last_error();
    EXPECT_EQ(found[0], multiple_scattering(twins.cpp, same, expected, EyeRay{}));
    EXPECT_EQ(found[1], multiple_scattering(twins.cpp, same, expected, {{1, 2, 3}, {0, 1, 0}, 40}));
    double intensity;
    ASSERT_EQ(litfog_effective_intensity(&twins.c.light.attenuation, 0.02, &intensity), LITFOG_OK);
    EXPECT_EQ(intensity, effective_intensity(twins.cpp.light.attenuation, 0.02));
  }
  const Twins twins = random_twins(random_);
  float unknown = kInfinity;
  const auto expect_unchanged = [&](const char* sentence) {
    found[0] = 7;
    expect_refused(litfog_multiple_scattering(&twins.c, &air, &table, rays, 2, found), sentence);
    EXPECT_EQ(found[0], 7);
  };
  std::swap(table.logs[3][4], unknown);
  expect_unchanged("table = inf: must be at most 100 in magnitude");
  std::swap(table.logs[3][4], unknown);
  rays[1].length = -1;
  expect_unchanged("rays[1].length = -1: must be >= 0");
  air.albedo = 0.5;
  expect_unchanged("albedo = 0.5: must be 1 for all orders of scattering");
  EXPECT_EQ(litfog_make_scattering_table(&air, &table), LITFOG_INVALID_ARGUMENT);
  expect_refused(litfog_multiple_scattering(&twins.c, &air, &table, rays, 2, &rays[1].length),
                 "scattered: must not overlap rays");
  expect_refused(litfog_effective_intensity(&twins.c.light.attenuation, 0, found),
                 "density = 0: must be finite and > 0");
}

TEST_F(CFace, ScatteredLightAndItsIrradianceAreThoseOfCpp) {
  const litfog_atmosphere air{{LITFOG_FOG_EXP, 0.02}, {{0.7, 0}, {0, 0}, 1}, 1, kInfinity, {0, 0, 0}, {}};
  const Atmosphere same{.fog = {FogMode::exp, 0.02}, .phase = Phase::henyey_greenstein(0.7)};
  litfog_scattering_table table;
  litfog_thin_beams beams;
  ASSERT_EQ(litfog_make_scattering_table(&air, &table), LITFOG_OK) << litfog_last_error();
  ASSERT_EQ(litfog_make_thin_beams(&air, &table, &beams), LITFOG_OK) << litfog_last_error();
  const ThinBeams expected_beams = make_thin_beams(same, make_scattering_table(same));
  EXPECT_EQ(std::memcmp(&beams, &expected_beams, sizeof beams), 0);
  double positions[] = {1, 2, 3, -40, 0.5, 9};
  double normal[] = {0.6, 0, 0.8};
  litfog_scattering_source source;
  litfog_diffuse_light found[2];
  int cones = 0;
  for (int i = 0; i < 20; ++i) {
    const Twins twins = random_twins(random_);
    ASSERT_EQ(litfog_make_scattering_source(&twins.c.light, &air, &beams, &source), LITFOG_OK) << litfog_last_error();
    const ScatteringSource expected = scattering_source(twins.cpp.light, same, expected_beams);
    EXPECT_EQ(source.intensity, expected.intensity);
    EXPECT_EQ(source.soft_range, expected.soft_range);
    EXPECT_EQ(source.phase_cosine, expected.phase_cosine);
    EXPECT_EQ(source.is_cone, expected.is_cone);
    EXPECT_EQ(std::memcmp(&source.beam, &expected.beam, sizeof source.beam), 0);
    cones += source.is_cone;
    ASSERT_EQ(litfog_scattered_light(&twins.c, &source, &air, positions, 2, found), LITFOG_OK) << litfog_last_error();
    const DiffuseLight scattered = scattered_light(twins.cpp, expected, same, {-40, 0.5, 9});
    EXPECT_EQ(std::memcmp(&found[1], &scattered, sizeof scattered), 0);
    EXPECT_EQ(found[0].all, scattered_light(twins.cpp, expected, same, {1, 2, 3}).all);
    double received;
    ASSERT_EQ(litfog_irradiance(&found[1], normal, &received), LITFOG_OK) << litfog_last_error();
    EXPECT_EQ(received, irradiance(scattered, {0.6, 0, 0.8}));
    EXPECT_GT(received, 0);
  }
  EXPECT_TRUE(cones > 0 && cones < 20);
  const Twins twins = random_twins(random_);
  beams.rows[2].forward = 0;
  expect_refused(litfog_make_scattering_source(&twins.c.light, &air, &beams, &source),
                 "beams.forward = 0: must be in (0, 1]");
  positions[4] = kNaN;
  found[0].all = 7;
  expect_refused(litfog_scattered_light(&twins.c, &source, &air, positions, 2, found),
                 "position.y = nan: must be at most 16777216 in magnitude");
  EXPECT_EQ(found[0].all, 7);
  expect_refused(litfog_scattered_light(&twins.c, &source, &air_, positions, 1, found),
                 "fog.mode = 1: must be exp for all orders of scattering");
  expect_refused(litfog_scattered_light(&twins.c, &source, &air, found[1].flow, 1, &found[1]),
                 "scattered: must not overlap positions");
  double received = 7;
  normal[1] = 1;
  expect_refused(litfog_irradiance(&found[1], normal, &received),
                 "normal = 1.4142135623730951: length must be 1 within 1e-6");
  found[1].all = -1;
  expect_refused(litfog_irradiance(&found[1], normal, &received), "all = -1: must be in [0, 1e100]");
  found[1] = {1, {0, kInfinity, 0}};
  expect_refused(litfog_irradiance(&found[1], normal, &received), "flow.y = inf: must be at most 1e100 in magnitude");
  EXPECT_EQ(received, 7);
}

TEST_F(CFace, AirlightOfTheSunIsThatOfCpp) {
  const litfog_atmosphere air{{LITFOG_FOG_EXP, 0.01}, {{0.7, 0}, {0, 0}, 1}, 0.9, 80, {0, 0, 0}, {}};
  const Atmosphere same{.fog = {FogMode::exp, 0.01}, .phase = Phase::henyey_greenstein(0.7), .albedo = 0.9, .top = 80};
  const double to_light[] = {0, 0.6, 0.8};
  litfog_eye_ray rays[] = {{{0, 2, 0}, {0, 0, -1}, kInfinity}, {{1, 2, 3}, {0, 1, 0}, 40}};
  double found[2];
  ASSERT_EQ(litfog_directional_airlight(&air, to_light, rays, 2, found), LITFOG_OK) << litfog_last_error();
  EXPECT_EQ(found[0], directional_airlight(same, {0, 0.6, 0.8}, {{0, 2, 0}, {0, 0, -1}, kInfinity}));
  EXPECT_EQ(found[1], directional_airlight(same, {0, 0.6, 0.8}, {{1, 2, 3}, {0, 1, 0}, 40}));
  EXPECT_GT(found[1], 0);
  double factor;
  ASSERT_EQ(litfog_directional_fog_factor(&air, to_light, 30, &factor), LITFOG_OK) << litfog_last_error();
  EXPECT_EQ(factor, directional_fog_factor(same, {0, 0.6, 0.8}, 30));

  rays[1].length = -1;
  found[0] = 7;
  expect_refused(litfog_directional_airlight(&air, to_light, rays, 2, found), "rays[1].length = -1: must be >= 0");
  EXPECT_EQ(found[0], 7);
  const double down[] = {0, -2, 0};
  expect_refused(litfog_directional_airlight(&air, down, rays, 1, found), "to_light = 2: length must be 1 within 1e-6");
  expect_refused(litfog_directional_airlight(&air_, to_light, rays, 1, found), "fog.mode = 1: must be exp");
  expect_refused(litfog_directional_airlight(&air, to_light, rays, 2, &rays[1].length),
                 "airlights: must not overlap rays");
  expect_refused(litfog_directional_fog_factor(&air, to_light, kNaN, &factor),
                 "height = nan: must be at most 16777216 in magnitude");
}

TEST_F(CFace, SizesThatNoMemoryHasAreRefusedBeforeAnythingIsRead) {
  constexpr auto kMinusOne = std::size_t(-1);
  const litfog_eye_ray ray{{0, 0, 0}, {0, 0, -1}, 9};
  double x = 7;
  char text = '#';
  std::size_t length;
  const litfog_batch_lights lights{kMinusOne, &x, &x, &x, &x, 1, &x, 1};
  const litfog_batch_solutions solutions{&x, nullptr, nullptr, nullptr};
  const auto expect_refused = [](litfog_status status) {
    EXPECT_EQ(status, LITFOG_INVALID_ARGUMENT);
    const std::string error = litfog_last_error();
    EXPECT_TRUE(error.starts_with("size of ")) << error;
    EXPECT_NE(error.find(" = 18446744073709551615: must be at most "), error.npos) << error;
  };
  expect_refused(litfog_airlight(&light_, &air_, &ray, kMinusOne, LITFOG_LAMP_LEG_FOGGED, &x));
  const litfog_scattering_table table{};
  expect_refused(litfog_multiple_scattering(&light_, &air_, &table, &ray, kMinusOne, &x));
  const litfog_scattering_source source{};
  litfog_diffuse_light scattered;
  expect_refused(litfog_scattered_light(&light_, &source, &air_, &x, kMinusOne, &scattered));
  expect_refused(litfog_directional_airlight(&air_, &x, &ray, kMinusOne, &x));
  expect_refused(litfog_solve_batch(LITFOG_FOG_EXP, &lights, &solutions, nullptr));
  expect_refused(litfog_read_light("x", &light_.light, &text, kMinusOne));
  expect_refused(litfog_expand_shader("", &text, kMinusOne, &length));
  EXPECT_EQ(x, 7);
  EXPECT_EQ(text, '#');
}

TEST_F(CFace, UpdatersTablesAreThoseOfCpp) {
  FogUpdater cpp;
  litfog_updater* c = nullptr;
  ASSERT_EQ(litfog_updater_create(LITFOG_DEFAULT_SKIP_BUDGET_255, &c), LITFOG_OK);
  for (int i = 0; i < 40; ++i) {
    const Twins twins = random_twins(random_);
    const FogLightHandle expected = cpp.add(twins.cpp);
    litfog_light_handle handle;
    ASSERT_EQ(litfog_updater_add(c, &twins.c, &handle), LITFOG_OK);
    EXPECT_EQ(handle.slot, expected.slot);
    EXPECT_EQ(handle.generation, expected.generation);
  }
  ASSERT_EQ(litfog_updater_solve_sources(c), LITFOG_OK);
  cpp.solve_sources();
  for (const double density : {1e-3, 1e-2, 1e-2}) {
    const double seconds = random_.uniform(0, 100);
    cpp.set_time(seconds);
    ASSERT_EQ(litfog_updater_set_time(c, seconds), LITFOG_OK);
    const litfog_fog fog{LITFOG_FOG_EXP, density};
    litfog_fog_light_changes changes;
    ASSERT_EQ(litfog_updater_set_fog(c, &fog, &changes), LITFOG_OK);
    cpp.set_fog({FogMode::exp, density});
    litfog_atmosphere layered = air_;
    layered.fog = fog;
    layered.profile.count = 2;
    layered.profile.knots[0] = {0, 0.02};
    layered.profile.knots[1] = {10, 0};
    ASSERT_EQ(litfog_updater_set_atmosphere(c, &layered, 5, &changes), LITFOG_OK) << litfog_last_error();
    const FogLightChanges expected = cpp.set_atmosphere(std::bit_cast<Atmosphere>(layered), 5);
    ASSERT_EQ(changes.kind_count, expected.kinds.size());
    for (std::size_t i = 0; i < changes.kind_count; ++i) EXPECT_EQ(changes.kinds[i].end, expected.kinds[i].end);
    EXPECT_EQ(changes.instance_count, expected.instances.size());
    EXPECT_EQ(changes.source_count, expected.sources.size());
    const litfog_fog_light_source* sources;
    size_t count;
    ASSERT_EQ(litfog_updater_sources(c, &sources, &count), LITFOG_OK);
    ASSERT_TRUE(count > 0 && count == cpp.sources().size());
    EXPECT_EQ(std::memcmp(sources, cpp.sources().data(), cpp.sources().size_bytes()), 0);
    litfog_fog_light_tables tables;
    ASSERT_EQ(litfog_updater_tables(c, &tables), LITFOG_OK);
    ASSERT_EQ(tables.kind_count, cpp.kinds().size());
    EXPECT_EQ(std::memcmp(tables.kinds, cpp.kinds().data(), cpp.kinds().size_bytes()), 0);
    ASSERT_EQ(tables.instance_count, cpp.instances().size());
    EXPECT_EQ(std::memcmp(tables.instances, cpp.instances().data(), cpp.instances().size_bytes()), 0);

    LightClusters expected_clusters;
    cpp.bound_lights(expected_clusters, {.fog = {FogMode::exp, density}}, 0.01, LampLeg::clear);
    expected_clusters.update({});
    litfog_light_clusters* clusters = nullptr;
    ASSERT_EQ(litfog_light_clusters_create(nullptr, &clusters), LITFOG_OK);
    litfog_atmosphere air = air_;
    air.fog = fog;
    ASSERT_EQ(litfog_updater_bound_lights(c, clusters, &air, 0.01, LITFOG_LAMP_LEG_CLEAR), LITFOG_OK)
        << litfog_last_error();
    litfog_view view;
    ASSERT_EQ(litfog_default_view(&view), LITFOG_OK);
    ASSERT_EQ(litfog_light_clusters_update(clusters, &view, nullptr), LITFOG_OK);
    litfog_cluster_lists lists;
    ASSERT_EQ(litfog_light_clusters_lists(clusters, &lists), LITFOG_OK);
    EXPECT_TRUE(std::ranges::equal(std::span(lists.table, lists.table_size), expected_clusters.table()));
    double range, budget;
    ASSERT_EQ(litfog_updater_reach_of_kind(c, 3, &air, 0.01, LITFOG_LAMP_LEG_FOGGED, &range), LITFOG_OK);
    EXPECT_EQ(range, cpp.reach_of_kind(3, {.fog = {FogMode::exp, density}}, 0.01));
    ASSERT_EQ(litfog_reach_budget(0.01, 7, 2, &air, &budget), LITFOG_OK);
    EXPECT_EQ(budget, reach_budget(0.01, 7, 2, {}));
    litfog_light_clusters_destroy(clusters);
  }
  litfog_updater_destroy(c);
}

TEST_F(CFace, SetFogAndBatchAllocateNothing) {
  litfog_updater* updater = nullptr;
  litfog_light_handle handle;
  ASSERT_EQ(litfog_updater_create(0, &updater), LITFOG_OK);
  for (int i = 0; i < 40; ++i) {
    const Twins twins = random_twins(random_);
    ASSERT_EQ(litfog_updater_add(updater, &twins.c, &handle), LITFOG_OK);
  }
  litfog_fog_light_changes changes;
  const double one = 1;
  const double threshold = 0.05;
  double intensity;
  std::size_t invalid;
  const litfog_batch_lights lights{1, &one, &one, &one, &threshold, 1, &one, 1};
  const litfog_batch_solutions solutions{&intensity, nullptr, nullptr, nullptr};
  const std::size_t before = allocation_count();
  ASSERT_EQ(litfog_updater_set_fog(updater, &fog_, &changes), LITFOG_OK);
  ASSERT_EQ(litfog_solve_batch(LITFOG_FOG_EXP, &lights, &solutions, &invalid), LITFOG_OK);
  EXPECT_EQ(allocation_count(), before);
  EXPECT_EQ(invalid, 0u);
  litfog_updater_destroy(updater);
}

TEST_F(CFace, NullIsRefusedByName) {
  litfog_fog_intensity solution;
  litfog_updater* updater = nullptr;
  litfog_fog_light_changes changes;
  const litfog_eye_ray ray{{0, 0, 0}, {0, 0, -1}, 9};
  const litfog_scattering_table table{};
  litfog_scattering_source source{};
  litfog_diffuse_light scattered{};
  size_t count;
  int32_t can;
  double x;
  const std::vector<std::pair<const char*, std::function<litfog_status()>>> calls = {
      {"atmosphere", [&] { return litfog_default_atmosphere(nullptr); }},
      {"light", [&] { return litfog_default_light(nullptr); }},
      {"light", [&] { return litfog_solve(nullptr, &fog_, &solution); }},
      {"fog", [&] { return litfog_solve(&light_.light, nullptr, &solution); }},
      {"solution", [&] { return litfog_solve(&light_.light, &fog_, nullptr); }},
      {"rays", [&] { return litfog_airlight(&light_, &air_, nullptr, 1, LITFOG_LAMP_LEG_FOGGED, &x); }},
      {"atmosphere", [&] { return litfog_airlight(&light_, nullptr, &ray, 1, LITFOG_LAMP_LEG_FOGGED, &x); }},
      {"table", [&] { return litfog_make_scattering_table(&air_, nullptr); }},
      {"table", [&] { return litfog_multiple_scattering(&light_, &air_, nullptr, &ray, 1, &x); }},
      {"attenuation", [&] { return litfog_effective_intensity(nullptr, 1, &x); }},
      {"beams", [&] { return litfog_make_thin_beams(&air_, &table, nullptr); }},
      {"beams", [&] { return litfog_make_scattering_source(&light_.light, &air_, nullptr, &source); }},
      {"source", [&] { return litfog_scattered_light(&light_, nullptr, &air_, &x, 1, &scattered); }},
      {"positions", [&] { return litfog_scattered_light(&light_, &source, &air_, nullptr, 1, &scattered); }},
      {"normal", [&] { return litfog_irradiance(&scattered, nullptr, &x); }},
      {"to_light", [&] { return litfog_directional_airlight(&air_, nullptr, &ray, 1, &x); }},
      {"atmosphere", [&] { return litfog_directional_fog_factor(nullptr, ray.direction, 0, &x); }},
      {"updater", [&] { return litfog_updater_create(0.5, nullptr); }},
      {"updater", [&] { return litfog_updater_set_fog(updater, &fog_, &changes); }},
      {"frustum", [&] { return litfog_view_frustum_can_see_ball(nullptr, &x, 1, &can); }},
      {"clusters", [&] { return litfog_light_clusters_resize(nullptr, 1); }},
      {"updater", [&] { return litfog_updater_bound_lights(nullptr, nullptr, &air_, 1, LITFOG_LAMP_LEG_FOGGED); }},
      {"budget", [&] { return litfog_reach_budget(1, 1, 1, &air_, nullptr); }},
      {"path", [&] { return litfog_read_light(nullptr, &light_.light, nullptr, 0); }},
      {"name", [&] { return litfog_read_light("x", &light_.light, nullptr, 8); }},
      {"texts", [&] { return litfog_shader_texts(nullptr, &count); }},
      {"source", [&] { return litfog_expand_shader(nullptr, nullptr, 0, &count); }},
  };
  for (const auto& [name, call] : calls) {
    EXPECT_EQ(call(), LITFOG_INVALID_ARGUMENT) << name;
    EXPECT_EQ(litfog_last_error(), std::string(name) + ": must not be NULL");
  }
  litfog_updater_destroy(nullptr);
  litfog_view_frustum_destroy(nullptr);
  litfog_light_clusters_destroy(nullptr);
}

TEST_F(CFace, ValuesThatBreakTheirRuleAreRefusedAndResultsLeftAlone) {
  litfog_fog_intensity solution{1, 2, 3, 4};
  const auto expect_error = [&](const char* error) {
    EXPECT_EQ(litfog_check_placed_light(&light_), LITFOG_INVALID_ARGUMENT);
    EXPECT_STREQ(litfog_last_error(), error);
    EXPECT_EQ(litfog_solve(&light_.light, &fog_, &solution), LITFOG_INVALID_ARGUMENT);
    EXPECT_EQ(litfog_sample(&light_.light, &fog_, 64, &solution), LITFOG_INVALID_ARGUMENT);
    EXPECT_EQ(solution.intensity, 1);
    EXPECT_EQ(solution.status, 4);
  };
  light_.light.attenuation.linear = kNaN;
  expect_error("attenuation.linear = nan: must be finite and >= 0");
  light_.light.attenuation.linear = 0;
  light_.light.cone.profile = 3;
  expect_error("cone.profile = 3: must be in [0, 2]");
  light_.light.cone.profile = LITFOG_CONE_COSINE;
  expect_error("cone.half_angle = 0: must be in (0, pi/2]");
  light_.light.cone.half_angle = double(float(std::numbers::pi / 2));
  EXPECT_EQ(litfog_check_placed_light(&light_), LITFOG_OK) << "a float above pi/2 is pi/2";

  litfog_fog fog{LITFOG_FOG_EXP, -1};
  EXPECT_EQ(litfog_check_fog(&fog), LITFOG_INVALID_ARGUMENT);
  expect_refused(litfog_fog_from_visibility(LITFOG_FOG_EXP, kNaN, LITFOG_CONTRAST_MOR, &fog),
                 "visibility = nan: must be >= 0");
  EXPECT_EQ(fog.density, -1);
  ASSERT_EQ(litfog_fog_from_visibility(LITFOG_FOG_EXP, 0, LITFOG_CONTRAST_MOR, &fog), LITFOG_OK);
  EXPECT_EQ(fog.density, kInfinity);
  litfog_phase phase{};
  ASSERT_EQ(litfog_phase_droplets(20, &phase), LITFOG_OK);
  EXPECT_EQ(phase.second.asymmetry, Phase::droplets(20).second.asymmetry);
  expect_refused(litfog_phase_droplets(4, &phase), "micrometres = 4: must be in [5, 50]");

  litfog_light_clusters* clusters = nullptr;
  ASSERT_EQ(litfog_light_clusters_create(nullptr, &clusters), LITFOG_OK);
  EXPECT_EQ(litfog_light_clusters_resize(clusters, std::numeric_limits<std::size_t>::max()), LITFOG_INVALID_ARGUMENT);
  litfog_light_clusters_destroy(clusters);
}

TEST_F(CFace, RunwayVisualRangeIsThatOfCppBothWays) {
  litfog_fog fog{};
  ASSERT_EQ(litfog_fog_from_runway_visual_range(LITFOG_FOG_EXP2, 550, 5000, 1e-5, &fog), LITFOG_OK);
  EXPECT_EQ(fog.mode, LITFOG_FOG_EXP2);
  EXPECT_EQ(fog.density, fog_from_runway_visual_range(FogMode::exp2, 550, {5000, 1e-5}).density);
  double metres = 0;
  ASSERT_EQ(litfog_runway_visual_range(&fog, 5000, 1e-5, &metres), LITFOG_OK);
  EXPECT_EQ(metres, runway_visual_range({FogMode::exp2, fog.density}, {5000, 1e-5}));
  double threshold = 0;
  ASSERT_EQ(litfog_illuminance_threshold(40, &threshold), LITFOG_OK);
  EXPECT_EQ(threshold, illuminance_threshold(40));

  expect_refused(
      litfog_fog_from_runway_visual_range(LITFOG_FOG_EXP, 1001, 100, 1e-4, &fog),
      "runway_visual_range = 1001: must be at most sqrt(candela / illuminance_threshold), where the lamps are "
      "last seen in clear air");
  expect_refused(litfog_runway_visual_range(&fog, 100, 0, &metres),
                 "illuminance_threshold = 0: must be finite and > 0");
  for (const double background : {-1.0, 1e308, kInfinity, kNaN}) {
    EXPECT_EQ(litfog_illuminance_threshold(background, &threshold), LITFOG_INVALID_ARGUMENT);
  }
  EXPECT_STREQ(litfog_last_error(), "background = nan: must be in [0, 1e12]");
}

TEST_F(CFace, ArgumentsOutsideTheirStatedRangesAreRefused) {
  litfog_view view;
  ASSERT_EQ(litfog_default_view(&view), LITFOG_OK);
  litfog_fog_intensity solution;
  expect_refused(litfog_sample(&light_.light, &fog_, 0, &solution), "samples = 0: must be >= 1");

  const litfog_eye_ray ray{{0, 0, 0}, {0, 0, -1}, 9};
  double result = 7;
  expect_refused(litfog_airlight(&light_, &air_, &ray, 1, 2, &result), "lamp_leg = 2: must be in [0, 1]");
  expect_refused(litfog_light_reach(&light_.light, &fog_, 0.01, -1, &result), "lamp_leg = -1: must be in [0, 1]");
  EXPECT_EQ(result, 7);

  litfog_light_bounds bounds;
  EXPECT_EQ(litfog_bounds_of(&light_, -1, &bounds), LITFOG_INVALID_ARGUMENT);
  ASSERT_EQ(litfog_bounds_of(&light_, 5, &bounds), LITFOG_OK);
  const double low[] = {0, 0, 0};
  const double high[] = {1, -1, 1};
  int32_t can = 7;
  EXPECT_EQ(litfog_can_light(&bounds, low, high, &can), LITFOG_INVALID_ARGUMENT);
  EXPECT_EQ(can, 7);

  litfog_light_clusters* clusters = nullptr;
  ASSERT_EQ(litfog_light_clusters_create(nullptr, &clusters), LITFOG_OK);
  litfog_cluster_lists lists;
  ASSERT_EQ(litfog_light_clusters_lists(clusters, &lists), LITFOG_OK);
  EXPECT_EQ(lists.light_count, 0u) << "before the first update";
  for (const litfog_cluster& cluster : std::span(lists.clusters, lists.cluster_count)) EXPECT_EQ(cluster.count, 0u);
  ASSERT_EQ(litfog_light_clusters_resize(clusters, 2), LITFOG_OK);
  EXPECT_EQ(litfog_light_clusters_set_light(clusters, 2, &bounds), LITFOG_INVALID_ARGUMENT);
  EXPECT_EQ(litfog_light_clusters_set_light(clusters, 1, &bounds), LITFOG_OK);
  view.left = view.right;
  EXPECT_EQ(litfog_light_clusters_update(clusters, &view, nullptr), LITFOG_INVALID_ARGUMENT);
  view.left = -10.5;
  EXPECT_EQ(litfog_light_clusters_update(clusters, &view, nullptr), LITFOG_INVALID_ARGUMENT);
  view.left = -1;
  view.farthest = 5;  // where the first slice ends
  EXPECT_EQ(litfog_light_clusters_update(clusters, &view, nullptr), LITFOG_INVALID_ARGUMENT);
  litfog_light_clusters_destroy(clusters);
}

TEST_F(CFace, HandlesOfRemovedLightsAreRefused) {
  litfog_updater* updater = nullptr;
  litfog_light_handle removed, held;
  ASSERT_EQ(litfog_updater_create(0, &updater), LITFOG_OK);
  ASSERT_EQ(litfog_updater_add(updater, &light_, &removed), LITFOG_OK);
  ASSERT_EQ(litfog_updater_remove(updater, removed), LITFOG_OK);
  ASSERT_EQ(litfog_updater_add(updater, &light_, &held), LITFOG_OK);
  size_t index = 7;
  EXPECT_EQ(litfog_updater_change(updater, removed, &light_), LITFOG_INVALID_ARGUMENT);
  EXPECT_EQ(litfog_updater_switch_light(updater, removed, 0), LITFOG_INVALID_ARGUMENT);
  EXPECT_EQ(litfog_updater_remove(updater, removed), LITFOG_INVALID_ARGUMENT);
  EXPECT_EQ(litfog_updater_set_time(updater, -1), LITFOG_INVALID_ARGUMENT);
  EXPECT_EQ(litfog_updater_instance_of(updater, removed, &index), LITFOG_INVALID_ARGUMENT);
  EXPECT_EQ(litfog_updater_kind_of(updater, removed, &index), LITFOG_INVALID_ARGUMENT);
  EXPECT_EQ(litfog_updater_remove(updater, {0, 0}), LITFOG_INVALID_ARGUMENT) << "of no light";
  EXPECT_EQ(index, 7u);
  EXPECT_EQ(litfog_updater_instance_of(updater, held, &index), LITFOG_OK);
  litfog_updater_destroy(updater);
}

TEST_F(CFace, DefaultAtmosphereIsThatOfCpp) {
  litfog_atmosphere air = air_;
  air.albedo = air.phase.weight = 0;
  air.profile.count = 3;
  ASSERT_EQ(litfog_default_atmosphere(&air), LITFOG_OK);
  const Atmosphere expected;
  EXPECT_EQ(air.fog.mode, LITFOG_FOG_EXP);
  EXPECT_EQ(air.fog.density, expected.fog.density);
  EXPECT_EQ(air.phase.first.asymmetry, expected.phase.first.asymmetry);
  EXPECT_EQ(air.phase.weight, expected.phase.weight);
  EXPECT_EQ(air.albedo, expected.albedo);
  EXPECT_EQ(air.top, expected.top);
  EXPECT_EQ(air.profile.count, expected.profile.count);
  EXPECT_EQ(litfog_check_atmosphere(&air), LITFOG_OK);
}

TEST_F(CFace, LastErrorIsThatOfTheThread) {
  litfog_light light;
  ASSERT_EQ(litfog_default_light(nullptr), LITFOG_INVALID_ARGUMENT);
  std::string other = "none";
  std::thread([&] {
    other = litfog_last_error();
    litfog_read_light("no such file", &light, nullptr, 0);
  }).join();
  EXPECT_EQ(other, "");
  EXPECT_STREQ(litfog_last_error(), "light: must not be NULL");
  EXPECT_EQ(litfog_default_light(&light), LITFOG_OK);
  EXPECT_STREQ(litfog_last_error(), "light: must not be NULL") << "calls that succeed leave it";
}

class CFaceFile : public testing::Test {
 protected:
  std::string write(const std::string& text) const { return directory_.write("lamp.json", text); }

 private:
  TemporaryDirectory directory_;
};

TEST_F(CFaceFile, LightIsThatOfCpp) {
  const std::string path = write(R"({"litfog": "light", "version": 1, "name": "lamp", "color": [1, 0.5, 0.25],
    "attenuation": {"constant": 1, "quadratic": 0.25}, "threshold": 0.1, "density_scale": 0.4,
    "cone": {"profile": "cosine", "half_angle_deg": 15, "exponent": 75}})");
  litfog_light light;
  char name[8];
  ASSERT_EQ(litfog_read_light(path.c_str(), &light, name, sizeof name), LITFOG_OK) << litfog_last_error();
  const Light expected = read_light(path);
  EXPECT_STREQ(name, "lamp");
  EXPECT_EQ(glm::dvec3(light.color[0], light.color[1], light.color[2]), expected.color);
  EXPECT_EQ(light.attenuation.quadratic, expected.attenuation.quadratic);
  EXPECT_EQ(light.threshold, expected.threshold);
  EXPECT_EQ(light.cone.profile, LITFOG_CONE_COSINE);
  EXPECT_EQ(light.cone.half_angle, expected.cone.half_angle);
  EXPECT_EQ(light.cone.exponent, expected.cone.exponent);
  EXPECT_EQ(light.density_scale, expected.density_scale);
}

TEST_F(CFaceFile, CallThatRunsOutOfMemoryHasItsStatusAndCanBeMadeAgain) {
  Random random(72);
  const std::string path = write(R"({"litfog": "light", "version": 1, "name": "a lamp whose name needs memory",
    "attenuation": {"quadratic": 0.25}})");
  const litfog_fog fog{LITFOG_FOG_EXP, 0.01};
  const litfog_atmosphere air{fog, {{0.5, 0}, {0, 0}, 1}, 1, kInfinity, {0, 0, 0}, {}};
  const litfog_fog_layer layers[] = {{-kInfinity, 100, 20, 300}, {200, 300, 50, 1000}};
  const litfog_cluster_grid grid{4, 4, 4, 2};
  const litfog_placed_light wrong{};
  litfog_view view;
  litfog_default_view(&view);
  litfog_light light;
  litfog_density_profile profile;
  litfog_light_handle handle;
  litfog_updater* updater = nullptr;
  litfog_light_clusters* clusters = nullptr;
  litfog_view_frustum* frustum = nullptr;
  std::vector<litfog_placed_light> lights;
  for (int i = 0; i < 20; ++i) lights.push_back(random_twins(random).c);
  static litfog_fog_light_block block;
  static litfog_scattering_table table;
  size_t length = 0;
  std::int32_t has_changed = 0;

  std::size_t failed = 0;
  const auto expect = [&](litfog_status expected, const char* name, const auto& call) {
    litfog_status status = LITFOG_FAULT;
    failed += fail_each_allocation([&] { status = call(); },
                                   [&] {
                                     // Only the text of an error may have lacked memory.
                                     const bool is_kept = expected != LITFOG_OK && status == expected;
                                     EXPECT_TRUE(is_kept || status == LITFOG_OUT_OF_MEMORY) << name << ": " << status;
                                     EXPECT_TRUE(std::string_view(litfog_last_error()).starts_with("out of memory"));
                                   });
    EXPECT_EQ(status, expected) << name << ": " << litfog_last_error();
  };
  expect(LITFOG_OK, "read_light", [&] { return litfog_read_light(path.c_str(), &light, nullptr, 0); });
  expect(LITFOG_OK, "layers", [&] { return litfog_density_profile_from_layers(layers, 2, 0.05, &profile); });
  expect(LITFOG_OK, "scattering", [&] { return litfog_make_scattering_table(&air, &table); });
  expect(LITFOG_OK, "block", [&] { return litfog_pack_fog_light_block(&air, lights.data(), 2, &block); });
  expect(LITFOG_OK, "shader",
         [&] { return litfog_expand_shader("#include \"litfog/shaders/airlight.glsl\"\n", nullptr, 0, &length); });
  expect(LITFOG_OK, "frustum", [&] { return litfog_view_frustum_create(&view, &frustum); });
  expect(LITFOG_OK, "clusters", [&] { return litfog_light_clusters_create(&grid, &clusters); });
  expect(LITFOG_OK, "updater", [&] { return litfog_updater_create(0, &updater); });
  expect(LITFOG_INVALID_ARGUMENT, "error", [&] { return litfog_updater_add(updater, &wrong, &handle); });
  for (const litfog_placed_light& placed : lights) {
    expect(LITFOG_OK, "add", [&] { return litfog_updater_add(updater, &placed, &handle); });
  }
  expect(LITFOG_OK, "change", [&] { return litfog_updater_change(updater, handle, &lights[0]); });
  expect(LITFOG_OK, "bound",
         [&] { return litfog_updater_bound_lights(updater, clusters, &air, 0.002, LITFOG_LAMP_LEG_FOGGED); });
  expect(LITFOG_OK, "update", [&] { return litfog_light_clusters_update(clusters, &view, &has_changed); });
  EXPECT_GT(failed, 60u);
  litfog_view_frustum_destroy(frustum);
  litfog_light_clusters_destroy(clusters);
  litfog_updater_destroy(updater);
}

TEST_F(CFaceFile, ErrorBeginsWithFileLineAndColumn) {
  const std::string path =
      write("{\"litfog\": \"light\", \"version\": 1, \"attenuation\": {\"quadratic\": 1},\n \"threshold\": 7}");
  litfog_light light;
  light.threshold = 0.3;
  EXPECT_EQ(litfog_read_light(path.c_str(), &light, nullptr, 0), LITFOG_BAD_FILE);
  EXPECT_EQ(std::string(litfog_last_error()).substr(0, path.size() + 6), path + ":2:15:") << litfog_last_error();
  EXPECT_EQ(light.threshold, 0.3);
}

TEST_F(CFaceFile, LongNameIsCutAfterAWholeCharacter) {
  const std::string path =
      write(R"({"litfog": "light", "version": 1, "name": "aéé", "attenuation": {"quadratic": 1}})");  // 1 + 2 + 2 bytes
  litfog_light light;
  for (const auto& [size, expected] : std::vector<std::pair<std::size_t, std::string>>{
           {6, "aéé"}, {5, "aé"}, {4, "aé"}, {3, "a"}, {2, "a"}, {1, ""}}) {
    std::array<char, 8> name;
    name.fill('#');
    ASSERT_EQ(litfog_read_light(path.c_str(), &light, name.data(), size), LITFOG_OK);
    EXPECT_EQ(name.data(), expected) << size;
    EXPECT_EQ(name[size], '#') << size;
  }
}

class CFaceShader : public testing::Test {
 protected:
  static std::string expanded(const char* source) {
    size_t length = 0;
    EXPECT_EQ(litfog_expand_shader(source, nullptr, 0, &length), LITFOG_OK) << litfog_last_error();
    std::string text(length + 1, '#');
    EXPECT_EQ(litfog_expand_shader(source, text.data(), text.size(), &length), LITFOG_OK);
    EXPECT_EQ(text.back(), '\0');
    text.pop_back();
    return text;
  }
};

TEST_F(CFaceShader, IncludesAreReplacedOnceAndLinesKeepTheirNumbers) {
  const std::string text = expanded(
      "#version 330 core\n#include \"litfog/shaders/expm1.glsl\"\n#include \"litfog/shaders/expm1.glsl\"\nlast\n");
  EXPECT_EQ(text.find("#version 330 core\n#line 1 1\n"), 0u);
  EXPECT_EQ(text.find("#include \""), std::string::npos);
  EXPECT_EQ(text.find("#ifndef LITFOG_EXPM1_GLSL"), text.rfind("#ifndef LITFOG_EXPM1_GLSL"));
  EXPECT_TRUE(text.ends_with("#line 3 0\n#line 4 0\nlast\n")) << text;
}

TEST_F(CFaceShader, EveryTextExpands) {
  const litfog_shader_text* texts;
  size_t count;
  ASSERT_EQ(litfog_shader_texts(&texts, &count), LITFOG_OK);
  EXPECT_GT(count, 0u);
  for (const litfog_shader_text& text : std::span(texts, count)) {
    EXPECT_GE(expanded(text.text).size(), std::string(text.text).size() / 2) << text.name;
  }
}

TEST_F(CFaceShader, UnknownFileIsNamedAndAShortBufferLeftAlone) {
  size_t length = 7;
  expect_refused(litfog_expand_shader("#include \"mine.glsl\"\n", nullptr, 0, &length),
                 "#include \"mine.glsl\": must be a file of litfog_shader_texts()");
  EXPECT_EQ(length, 7u);
  char buffer[] = "####";
  EXPECT_EQ(litfog_expand_shader("abc\n", buffer, 4, &length), LITFOG_OK);
  EXPECT_EQ(length, 4u);
  EXPECT_STREQ(buffer, "####");
}

}  // namespace
}  // namespace litfog::test
