// SPDX-License-Identifier: Apache-2.0
#include "litfog/directional_airlight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "reference/double_limits.h"
#include "reference/near_numbers.h"
#include "reference/random_light.h"
#include "reference/ulp.h"
#include "value_errors.h"

namespace litfog::test {
namespace {

using glm::dvec3;

/// Fog up to a top, or layers under clear air.
Atmosphere draw_open_air(Random& random) {
  if (random.chance(0.5)) return {.fog = {FogMode::exp, random.log_uniform(1e-5, 1)}, .top = random.uniform(-50, 300)};
  std::vector<DensityKnot> knots;
  double height = random.uniform(-50, 200);
  for (int count = random.below(int(kMaxDensityKnots)); count > 0; --count) {
    knots.push_back({height, random.chance(0.3) ? 0 : random.log_uniform(1e-5, 1)});
    height += random.log_uniform(1e-2, 200);
  }
  knots.push_back({height, 0});
  return {.profile = make_density_profile(knots)};
}

dvec3 draw_slanted(Random& random) {
  const double rise = random.chance(0.1) ? 0 : random.chance(0.5) ? random.log_uniform(1e-4, 1) : random.uniform(-1, 1);
  const double angle = random.uniform(0, 6.28);
  const double across = std::sqrt(1 - rise * rise);
  return {across * std::cos(angle), rise, across * std::sin(angle)};
}

/// The depth from a height to the light.
double depth_to_light(const Atmosphere& air, double height, double slope) {
  if (air.profile.count > 0) return optical_depth_to_sky(air.profile, height, slope);
  if (height >= air.top && slope >= 0) return 0;
  return slope > 0 ? (air.top - height) / slope * air.fog.density : kInfinity;
}

/// The definition's integral, cut where the density over height is not smooth.
double integrated_airlight(const Atmosphere& air, const dvec3& to_light, const EyeRay& ray) {
  const double height = ray.origin.y, rise = ray.direction.y;
  const auto integrand = [&](double s) {
    const double here = height + s * rise;
    const double depth = air.fog_between(height, here).density * s + depth_to_light(air, here, to_light.y);
    return air.fog_at(here).density * std::exp(-depth);
  };
  std::vector<double> cuts{0, ray.length};
  const auto cut_at = [&](double edge) {
    const double s = (edge - height) / rise;
    if (s > 0 && s < ray.length) cuts.push_back(s);
  };
  if (rise != 0) {
    cut_at(air.top);
    for (const DensityKnot& knot : air.profile.used()) cut_at(knot.height);
  }
  std::sort(cuts.begin(), cuts.end());
  double sum = 0;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (!(cuts[i] > cuts[i - 1])) continue;
    sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, cuts[i - 1], cuts[i], 12, 1e-11);
  }
  return sum * phase_at(air.phase, glm::dot(ray.direction, to_light));
}

std::string describe(const Atmosphere& air, const dvec3& to_light, const EyeRay& ray) {
  std::string text = "density " + std::to_string(air.fog.density) + ", top " + std::to_string(air.top) + ", light " +
                     std::to_string(to_light.y) + ", ray " + std::to_string(ray.origin.y) + " + " +
                     std::to_string(ray.direction.y) + " s up to " + std::to_string(ray.length) + ", knots";
  for (const auto& [height, density] : air.profile.used()) {
    text += " " + std::to_string(height) + ":" + std::to_string(density);
  }
  return text;
}

TEST(DirectionalAirlight, ClosedFormIsTheIntegralInAnyFogThatIsOpenAbove) {
  Random random(4141);
  WorstError error("directional_airlight", "tops and up to 8 knots", kDirectionalAirlightMaxError, "relative");
  for (int i = 0; i < 20000; ++i) {
    const Atmosphere air = draw_open_air(random);
    ASSERT_TRUE(is_open_above(air));
    const dvec3 to_light = draw_slanted(random);
    const EyeRay ray{{0, random.uniform(-100, 500), 0}, draw_slanted(random), random.log_uniform(1e-2, 1e4)};
    const double expected = integrated_airlight(air, to_light, ray);
    const double found = directional_airlight(air, to_light, ray);
    if (expected < 1e-80) {
      ASSERT_LT(found, 2e-80) << describe(air, to_light, ray);
    } else {
      error.add(std::abs(found / expected - 1), [&] { return describe(air, to_light, ray); });
    }
    ASSERT_NEAR(directional_fog_factor(air, to_light, ray.origin.y),
                std::exp(-depth_to_light(air, ray.origin.y, to_light.y)), 1e-13);
  }
  error.check();
}

RC_GTEST_PROP(DirectionalAirlight, ClosedFormIsTheIntegralOfRaysFromAndToKnotsAndAlongAxes, ()) {
  Random random(*rc::gen::arbitrary<std::uint32_t>());
  const Atmosphere air = draw_open_air(random);
  std::vector<double> edges{0};
  if (air.profile.count == 0) edges.push_back(air.top);
  for (const DensityKnot& knot : air.profile.used()) edges.push_back(knot.height);
  const auto draw_axis = [&] {
    const double rise = *near_one_of({0, 1, -1, 0.5, 0.05, -0.05});
    if (std::abs(rise) > 1) return dvec3(0, std::copysign(1.0, rise), 0);
    return dvec3(std::sqrt((1 - rise) * (1 + rise)), rise, 0);
  };
  const dvec3 to_light = draw_axis();
  EyeRay ray{{0, *near_one_of(edges), 0}, *rc::gen::arbitrary<bool>() ? draw_axis() : to_light, 100};
  const double end = (*near_one_of(edges) - ray.origin.y) / ray.direction.y;
  if (end > 1e-3 && end < 1e5) ray.length = end;
  const double expected = integrated_airlight(air, to_light, ray);
  const double found = directional_airlight(air, to_light, ray);
  RC_LOG() << describe(air, to_light, ray) << ": " << found << " instead of " << expected;
  const double crossing = 4e-16 * ray.length * std::max(air.fog.density, largest_density(air.profile));  // of an edge
  RC_ASSERT(std::abs(found - expected) <= kDirectionalAirlightMaxError * expected + crossing);
}

TEST(DirectionalAirlight, AnglesHaveThePhaseFunctionsValue) {
  Random random(4142);
  for (int i = 0; i < 1000; ++i) {
    Atmosphere air{.fog = {FogMode::exp, 0.01}, .top = 100};
    const dvec3 to_light = draw_slanted(random);
    const EyeRay ray{{0, 1, 0}, draw_slanted(random), 50};
    const double isotropic = directional_airlight(air, to_light, ray);
    air.phase = Phase::droplets(10);
    const double expected = isotropic * phase_at(air.phase, glm::dot(ray.direction, to_light));
    EXPECT_NEAR(directional_airlight(air, to_light, ray), expected, 1e-9 * expected);
  }
}

TEST(DirectionalAirlight, EndlessRayIsTheLimitOfLongOnes) {
  Random random(4143);
  for (int i = 0; i < 2000; ++i) {
    const Atmosphere air = draw_open_air(random);
    const dvec3 to_light = draw_slanted(random);
    EyeRay ray{{0, random.uniform(-100, 500), 0}, draw_slanted(random), 1e9};
    const double expected = directional_airlight(air, to_light, ray);
    ray.length = kInfinity;
    EXPECT_NEAR(directional_airlight(air, to_light, ray), expected, 1e-9 * expected + 1e-100)
        << describe(air, to_light, ray);
  }
}

TEST(DirectionalAirlight, NoLightEntersFogWithoutAnEndAbove) {
  const std::array<DensityKnot, 2> cloud{{{100, 0}, {120, 0.1}}};
  const std::array<DensityKnot, 2> ground{{{100, 0.1}, {120, 0}}};
  for (const Atmosphere& air :
       {Atmosphere{.fog = {FogMode::exp, 0.01}}, Atmosphere{.profile = make_density_profile(cloud)},
        Atmosphere{.fog = {FogMode::exp, 1e-4}, .profile = make_density_profile(ground)}}) {
    EXPECT_FALSE(is_open_above(air));
    for (const double rise : {-1.0, 0.0, 1.0}) {
      const dvec3 direction{std::sqrt(1 - rise * rise), rise, 0};
      EXPECT_EQ(directional_airlight(air, {0, 1, 0}, {{0, 110, 0}, direction, 50}), 0);
    }
    EXPECT_EQ(directional_fog_factor(air, {0, 1, 0}, 110), 0);
  }
  EXPECT_FALSE(is_open_above({.fog = {FogMode::exp2, 0.01}, .top = 100}));
}

TEST(DirectionalAirlight, TotalFogIsLitWhereTheEyeIsAboveItsTop) {
  const Atmosphere air{.fog = {FogMode::exp, kInfinity}, .top = 100};
  for (const double length : {1e-3, 10.0, 1e4, kInfinity}) {
    EXPECT_EQ(directional_airlight(air, {0, 1, 0}, {{0, 90, 0}, {0.6, 0.8, 0}, length}), 0);
    EXPECT_NEAR(directional_airlight(air, {0, 1, 0}, {{0, 110, 0}, {0.6, -0.8, 0}, length}), 1, 1e-12);
  }
  EXPECT_EQ(directional_airlight(air, {0, 1, 0}, {{0, 110, 0}, {0.6, -0.8, 0}, 0}), 0);
}

TEST(DirectionalAirlight, BadArgumentIsNamed) {
  const Atmosphere air{.fog = {FogMode::exp, 0.01}, .top = 100};
  const Atmosphere exp2{.fog = {FogMode::exp2, 0.01}, .top = 100};
  EXPECT_EQ(error_of([&] { directional_airlight(exp2, {0, 1, 0}, {}); }), "fog.mode = 1: must be exp");
  EXPECT_EQ(error_of([&] { directional_airlight(air, {0, 2, 0}, {}); }), "to_light = 2: length must be 1 within 1e-6");
  EXPECT_EQ(error_of([&] { directional_airlight(air, {0, 1, 0}, {.length = -1}); }), "length = -1: must be >= 0");
  EXPECT_EQ(error_of([&] {
              directional_fog_factor(air, {0, 1, 0}, kNan);
            }),
            "height = nan: must be at most 16777216 in magnitude");
}

}  // namespace
}  // namespace litfog::test
